// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/expression.h>
#include <softgrain/scene/loads.h>

namespace softgrain
{
namespace
{
/// The load of one body, whose section has the formulas.
class BodyForce final : public Load<2>
{
public:
  explicit BodyForce(const std::string &formulas)
      : force(vector_expression(formulas, {"x", "y", "X", "Y", "t"}))
  {
    name = name_of_body_force;
  }

  std::string key() const override { return "Body force"; }
  void declare_parameters(dealii::ParameterHandler &) const override {}
  void parse_parameters(dealii::ParameterHandler &) override {}
  bool acts() const override { return true; }

  dealii::Tensor<1, 2> acceleration(const LoadPlace<2> &place) const override
  {
    const std::vector<double> at = {place.now[0], place.now[1], place.at_rest[0], place.at_rest[1],
                                    place.time};
    return dealii::Tensor<1, 2>({force[0](at), force[1](at)});
  }

private:
  const std::vector<Expression> force; ///< components, of x, y, X, Y, t [N/kg]
};
} // namespace

std::shared_ptr<const Load<2>> body_force(const std::string &formulas)
{
  // The parameter's default says that there is no load, and then none is evaluated.
  if (formulas.empty() || formulas == "0; 0")
    return nullptr;
  return std::make_shared<BodyForce>(formulas);
}
} // namespace softgrain
