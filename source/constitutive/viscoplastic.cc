// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/viscoplastic.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>

namespace softgrain::constitutive
{
template <int dim>
void Viscoplastic<dim>::declare_parameters(dealii::ParameterHandler &prm) const
{
  using dealii::Patterns::Double;
  J2Plastic<dim>::declare_parameters(prm);
  prm.declare_entry("Drag stress", "1e6", Double(0.),
                    "K, stress beyond the yield stress at which plastic strain grows by the reference rate, "
                    "above 0. Units: Pa.");
  prm.declare_entry("Exponent", "1", Double(1., 100.),
                    "n, power of the stress beyond the yield stress. Units: none.");
  prm.declare_entry("Reference rate", "1", Double(0.), "a, above 0. Units: 1/s.");
  prm.declare_entry("Largest increment", "0.05", Double(0.),
                    "Equivalent plastic strain of one step above which a shorter step is asked for; 0: any. "
                    "Units: none.");
}

template <int dim>
void Viscoplastic<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  J2Plastic<dim>::parse_parameters(prm);
  drag = prm.get_double("Drag stress");
  exponent = prm.get_double("Exponent");
  reference_rate = prm.get_double("Reference rate");
  this->largest_increment = prm.get_double("Largest increment");
  if (!(drag > 0))
    throw InputError("Drag stress = " + prm.get("Drag stress") + " Pa is not allowed; it must be above 0");
  if (!(reference_rate > 0))
    throw InputError("Reference rate = " + prm.get("Reference rate") +
                     " 1/s is not allowed; it must be above 0");
}

template <int dim>
std::vector<std::string> Viscoplastic<dim>::history_names() const
{
  std::vector<std::string> names = J2Plastic<dim>::history_names();
  names.push_back("equivalent_plastic_rate_per_s");
  return names;
}

template <int dim>
typename Viscoplastic<dim>::Flow Viscoplastic<dim>::flow(const double trial,
                                                         const double alpha_old,
                                                         const double rate_old,
                                                         const double dt) const
{
  const double excess = trial - this->yield_stress(alpha_old), elastic = 3 * this->mu + this->kinematic;
  const double c = reference_rate * dt, n = exponent;
  Flow flow;
  flow.rate = dt > 0 ? 0. : rate_old;
  if (dt > 0 && rate_old > 0)
    flow.dissipation = drag * std::pow(rate_old / reference_rate, 1 / n) * rate_old * dt / (n + 1);
  if (!(excess > 0 && dt > 0))
    return flow;
  // In y = s/K the increment is c y^n, and what is left over falls; Newton from the right, within brackets.
  double low = 0, high = std::min(std::pow(excess / (elastic * c), 1 / n), excess / drag), y = high;
  const double yield_old = this->yield_stress(alpha_old);
  double increment = 0, slope = 0;
  for (unsigned int i = 0; i < 100; ++i)
  {
    increment = c * std::pow(y, n);
    slope = n * c * std::pow(y, n - 1); // of the increment by y
    const double alpha = alpha_old + increment;
    const double rest = excess - elastic * increment - (this->yield_stress(alpha) - yield_old) - drag * y;
    (rest > 0 ? low : high) = y;
    double next = y + rest / ((elastic + this->hardening(alpha)) * slope + drag);
    if (!(next >= low && next <= high))
      next = (low + high) / 2;
    const double step = next - y;
    y = next;
    if (std::abs(step) <= 1e-15 * y)
      break;
  }
  increment = c * std::pow(y, n);
  const double alpha = alpha_old + increment;
  flow.increment = increment;
  flow.softness = slope / ((elastic + this->hardening(alpha)) * slope + drag);
  flow.dissipation += std::max(0., this->plastic_work(alpha) - this->plastic_work(alpha_old)) +
                      n / (n + 1) * drag * y * increment;
  flow.rate = increment / dt;
  return flow;
}

template class Viscoplastic<2>;
template class Viscoplastic<3>;

namespace
{
[[maybe_unused]] const bool registered = register_law<Viscoplastic>(
    "viscoplastic", "Solid that creeps: Perzyna's flow beyond a yield stress, or Norton's without one.");
}
} // namespace softgrain::constitutive
