// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/parameters/parameter_values.h>
#include <softgrain/scene/load.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
namespace
{
/// The same everywhere and at all times.
template <int dim>
class Gravity final : public Load<dim>
{
public:
  std::string key() const override { return "Gravity"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    using namespace dealii::Patterns;
    prm.declare_entry("Gravity", dim == 3 ? "0, 0, 0" : "0, 0", List(Double(), dim, dim, ","),
                      std::string("Acceleration of gravity, ") +
                          (dim == 3 ? "\"gx, gy, gz\"" : "\"gx, gy\"") + ". Units: m/s^2.");
  }

  void parse_parameters(dealii::ParameterHandler &prm) override
  {
    g = vector_of_numbers<dim>(prm.get("Gravity"));
  }

  bool acts() const override { return g.norm_square() > 0.; }
  bool is_uniform() const override { return true; }
  dealii::Tensor<1, dim> acceleration(const LoadPlace<dim> &) const override { return g; }

private:
  dealii::Tensor<1, dim> g; ///< [m/s^2]
};

[[maybe_unused]] const bool registered = add_load<Gravity>("gravity", "the same pull everywhere");
} // namespace
} // namespace softgrain
