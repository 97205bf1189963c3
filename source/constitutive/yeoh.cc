// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/yeoh.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace softgrain::constitutive
{
template <int dim>
void Yeoh<dim>::declare_parameters(dealii::ParameterHandler &prm) const
{
  FirstInvariantLaw<dim>::declare_parameters(prm);
  prm.declare_entry("Second coefficient", "-0.01", dealii::Patterns::Double(),
                    "C20 / C10 of the energy; below 0 softens at moderate stretch. Units: none.");
  prm.declare_entry("Third coefficient", "2e-4", dealii::Patterns::Double(0.),
                    "C30 / C10 of the energy; stiffens at large stretch. Units: none.");
}

template <int dim>
void Yeoh<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  FirstInvariantLaw<dim>::parse_parameters(prm);
  c2 = prm.get_double("Second coefficient");
  c3 = prm.get_double("Third coefficient");
  // A parabola without its lowest place above -3 is lowest at -3, or falls for ever when it is a falling
  // line.
  const double lowest = std::max(-3., c3 > 0 ? -c2 / (3 * c3) : -3.);
  if (!(shape(lowest).slope > 0) || (c3 == 0 && c2 < 0))
    throw InputError("Second coefficient = " + prm.get("Second coefficient") +
                     " with Third coefficient = " + prm.get("Third coefficient") +
                     " is not allowed: 1 + 2 c2 x + 3 c3 x^2 must be above 0 at every x = I1 - 3 >= -3, or a "
                     "stretch would need less force than a smaller one");
  this->check_volume("Second coefficient = " + prm.get("Second coefficient"));
}

template <int dim>
typename Yeoh<dim>::Shape Yeoh<dim>::shape(const double x) const
{
  return {x * (1 + x * (c2 + x * c3)), 1 + x * (2 * c2 + x * 3 * c3), 2 * c2 + 6 * c3 * x};
}

template class Yeoh<2>;
template class Yeoh<3>;

namespace
{
[[maybe_unused]] const bool registered = register_law<Yeoh>(
    "yeoh", "Rubber with a cubic energy in I1 - 3: softens at moderate and stiffens at large stretch.");
}
} // namespace softgrain::constitutive
