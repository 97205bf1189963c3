// SPDX-License-Identifier: LGPL-2.1-or-later
// Drag as of fast flow: it grows with the square of the speed.
#include <softgrain/scene/load.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

using namespace softgrain;

template <int dim>
class QuadraticDrag final : public Load<dim>
{
public:
  std::string key() const override { return "Quadratic drag"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry("Quadratic drag", "0", dealii::Patterns::Double(0),
                      "Force per mass over the square of the speed. Units: 1/m.");
  }

  void parse_parameters(dealii::ParameterHandler &prm) override { factor = prm.get_double("Quadratic drag"); }

  bool acts() const override { return factor > 0.; }
  bool sees_velocity() const override { return true; }

  dealii::Tensor<1, dim> acceleration(const LoadPlace<dim> &place) const override
  {
    return -factor * place.velocity.norm() * place.velocity;
  }

  dealii::Tensor<2, dim> velocity_tangent(const LoadPlace<dim> &place) const override
  {
    const double speed = place.velocity.norm();
    dealii::Tensor<2, dim> tangent;
    if (speed == 0.)
      return tangent;
    for (unsigned int d = 0; d < dim; ++d)
      tangent[d][d] = speed;
    return -factor * (tangent + outer_product(place.velocity, place.velocity) / speed);
  }

private:
  double factor = 0.; ///< [1/m]
};

[[maybe_unused]] const bool registered =
    add_load<QuadraticDrag>("quadratic_drag", "a medium at rest that is fast to flow around");
