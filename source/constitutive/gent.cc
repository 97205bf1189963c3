// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/gent.h>
#include <softgrain/constitutive/law_registry.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <sstream>

namespace softgrain::constitutive
{
template <int dim>
void Gent<dim>::declare_parameters(dealii::ParameterHandler &prm) const
{
  FirstInvariantLaw<dim>::declare_parameters(prm);
  prm.declare_entry(
      "Locking", "100", dealii::Patterns::Double(0.),
      "J_m, the value of I1 - 3 at which the chains are fully stretched, above 0; about 100 for "
      "natural rubber, 1 for soft tissue. Units: none.");
}

template <int dim>
void Gent<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  FirstInvariantLaw<dim>::parse_parameters(prm);
  locking = prm.get_double("Locking");
  if (!(locking > 0))
    throw InputError("Locking = " + prm.get("Locking") + " is not allowed; it must be above 0");
  this->check_volume("Locking = " + prm.get("Locking"));
}

template <int dim>
typename Gent<dim>::Shape Gent<dim>::shape(const double x) const
{
  const double slope = locking / (locking - x);
  return {-locking * std::log1p(-x / locking), slope, slope / (locking - x)};
}

template <int dim>
std::string Gent<dim>::why_refused(const Inputs<dim> &point) const
{
  const dealii::Tensor<2, dim> &F = *point.deformation_gradient;
  const double x = F.norm_square() - dim;
  if (!is_admissible(dealii::determinant(F)) || x < locking)
    return "";
  std::ostringstream text;
  text << "was stretched to I1 - 3 = " << x << ", but its law 'Gent' locks at 'Locking' = " << locking;
  return text.str();
}

template class Gent<2>;
template class Gent<3>;

namespace
{
[[maybe_unused]] const bool registered =
    register_law<Gent>("gent", "Rubber whose chains have a finite length: locks at I1 - 3 = J_m.");
}
} // namespace softgrain::constitutive
