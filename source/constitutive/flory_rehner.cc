// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/flory_rehner.h>
#include <softgrain/constitutive/law_registry.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain::constitutive
{
namespace
{
constexpr double nearly_dry = 1.05; ///< J_t below which mixing goes on linearly in ln J_t
constexpr double series_below = 0.05;
/// Gauss's rule with four points.
constexpr unsigned int n_gauss = 4;
constexpr double gauss_place[] = {0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                  0.9305681557970263},
                 gauss_weight[] = {0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                   0.1739274225687269};

/// (ln(1 - x) + x) / x, without what cancels where x is small.
double logarithm_beyond(const double x)
{
  if (x > series_below)
    return std::log1p(-x) / x + 1.;
  double sum = 0.;
  for (unsigned int n = 14; n >= 2; --n)
    sum = x * sum - 1. / n;
  return x * sum;
}

/// Mixing as it is with solvent.
struct Wet
{
  /// J ln(1 - 1/J) + 1 + chi/J, what mixing adds to the stress per dry volume, over q.
  static double stress(const double J, const double chi) { return logarithm_beyond(1. / J) + chi / J; }
  /// d stress / d ln J
  static double slope(const double J, const double chi)
  {
    return logarithm_beyond(1. / J) + 1. / (J - 1.) - chi / J;
  }
  /// (J - 1) ln(J / (J - 1)) + chi/J, less its limit for large J; d / d ln J of minus that is stress().
  static double energy(const double J, const double chi) { return (J - 1.) * -std::log1p(-1. / J) + chi / J; }
};

double mixing_stress(const double J, const double chi)
{
  return J > nearly_dry
             ? Wet::stress(J, chi)
             : Wet::stress(nearly_dry, chi) + Wet::slope(nearly_dry, chi) * std::log(J / nearly_dry);
}

double mixing_slope(const double J, const double chi)
{
  return Wet::slope(std::max(J, nearly_dry), chi);
}

/// What mixing stores beyond @p from, over q: the integral of mixing_stress() over ln J from there to @p to.
double mixing_energy(const double from, const double to, const double chi)
{
  const auto below = [chi](const double J)
  {
    const double log = std::log(std::min(J, nearly_dry) / nearly_dry);
    return Wet::stress(nearly_dry, chi) * log + 0.5 * Wet::slope(nearly_dry, chi) * log * log;
  };
  return Wet::energy(std::max(from, nearly_dry), chi) - Wet::energy(std::max(to, nearly_dry), chi) +
         below(to) - below(from);
}
} // namespace

template <int dim>
FloryRehner<dim>::FloryRehner() : chemical_potential("0", {"t"})
{
  find_rest();
}

template <int dim>
void FloryRehner<dim>::declare_parameters(dealii::ParameterHandler &prm) const
{
  using dealii::Patterns::Double;
  prm.declare_entry("Shear modulus", "1e4", Double(1e-300), "Of the dry network, N k T. Units: Pa.");
  prm.declare_entry(
      "Mixing pressure", "1.36e8", Double(1e-300),
      "k T over the volume of a molecule of the solvent; of water at 22 degrees 1.36e8. Units: Pa.");
  prm.declare_entry("Interaction", "0.45", Double(0., 3.),
                    "Flory's chi between network and solvent. Units: none.");
  prm.declare_entry(
      "Chemical potential", "0", dealii::Patterns::Anything(),
      "Of the solvent outside over k T, a formula of the time t that is never above 0, the pure "
      "solvent. A gel begins swollen freely at that of t = 0. Units: none.");
  prm.declare_entry(
      "Largest swelling", "0.1", Double(0.),
      "Change of volume per volume of a free gel in one step above which a shorter step is asked "
      "for; 0: any. Units: none.");
}

template <int dim>
void FloryRehner<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  shear_of_network = prm.get_double("Shear modulus");
  mixing = prm.get_double("Mixing pressure");
  interaction = prm.get_double("Interaction");
  chemical_potential = formula_of_time(prm.get("Chemical potential"), "Chemical potential");
  largest = prm.get_double("Largest swelling");
  find_rest();
}

template <int dim>
double FloryRehner<dim>::potential(const double time) const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return chemical_potential({time});
}

template <int dim>
std::pair<double, double> FloryRehner<dim>::free_stress(const double J, const double m) const
{
  const double stiffness = shear_of_network / mixing, stretch = std::pow(J, 2. / 3.);
  return {stiffness * (stretch - 1.) + mixing_stress(J, interaction) - m * J,
          2. / 3. * stiffness * stretch + mixing_slope(J, interaction) - m * J};
}

template <int dim>
double FloryRehner<dim>::free_swelling(const double m) const
{
  if (m == m_at_rest && swelling > 1.)
    return swelling;
  // The stress rises through 0 somewhere: first both sides of it, from the dry gel on, then Newton's method
  // between them.
  double low = 1e-12, high = nearly_dry;
  while (free_stress(high, m).first < 0.)
  {
    low = high;
    high *= 2.;
  }
  double J = std::sqrt(low * high);
  for (unsigned int i = 0; i < 200; ++i)
  {
    const auto [stress, slope] = free_stress(J, m);
    (stress < 0. ? low : high) = J;
    double next = J * std::exp(-stress / slope);
    if (!(next > low && next < high))
      next = std::sqrt(low * high);
    if (std::abs(next / J - 1.) < 1e-15)
      return next;
    J = next;
  }
  return J;
}

template <int dim>
void FloryRehner<dim>::find_rest()
{
  m_at_rest = potential(0.);
  if (!(m_at_rest <= 0.))
  {
    std::ostringstream text;
    text << "'Chemical potential' = '" << chemical_potential.text() << "' is " << m_at_rest
         << " at t = 0: it must be 0, that of the pure solvent, or less";
    throw InputError(text.str());
  }
  swelling = 1.;
  swelling = free_swelling(m_at_rest);
  mu = shear_of_network * std::pow(swelling, -1. / 3.);
  lambda = mixing * (mixing_slope(swelling, interaction) - m_at_rest * swelling) / swelling;
  if (!(3. * lambda + 2. * mu > 0.))
  {
    std::ostringstream text;
    text << "'Interaction' = '" << interaction
         << "' gives a gel that is not stable where it is swollen freely, by " << swelling << " times";
    throw InputError(text.str());
  }
}

template <int dim>
typename FloryRehner<dim>::Solvent
FloryRehner<dim>::solvent_in_step(const double m_old, const double m, const Outputs<dim> &out) const
{
  Solvent solvent;
  solvent.m_old = m_old;
  solvent.m = m;
  const bool limits = out.step_share && largest > 0. && m != m_old;
  if (out.energy || limits)
    solvent.free = free_swelling(m);
  if (limits)
    if (const double change = std::abs(std::log(solvent.free / free_swelling(m_old)));
        change > std::log1p(largest))
      *out.step_share = std::min(*out.step_share, std::log1p(largest) / change);
  for (unsigned int g = 0; g < n_gauss && out.supply && m != m_old; ++g)
    solvent.free_on_way[g] = free_swelling(m_old + gauss_place[g] * (m - m_old));
  return solvent;
}

template <int dim>
double FloryRehner<dim>::supply(const Solvent &solvent, const double J_old, const double J_new) const
{
  if (solvent.m == solvent.m_old)
    return 0.;
  double sum = 0.;
  for (unsigned int g = 0; g < n_gauss; ++g)
    sum += gauss_weight[g] *
           (solvent.free_on_way[g] - swelling * J_old * std::pow(J_new / J_old, gauss_place[g]));
  return mixing * (solvent.m - solvent.m_old) * sum / swelling;
}

template <int dim>
std::string FloryRehner<dim>::why_refused(const Inputs<dim> &point) const
{
  const double m = potential(point.time);
  if (m <= 0.)
    return "";
  std::ostringstream text;
  text << "cannot swell: 'Chemical potential' of its law 'Flory-Rehner' is " << m << " at t = " << point.time
       << " s; it must be 0, that of the pure solvent, or less";
  return text.str();
}

template <int dim>
std::size_t FloryRehner<dim>::update(const Inputs<dim> &in, const Outputs<dim> &out) const
{
  // A state that is only looked at has the chemical potential with which it came about.
  const double now = in.dt == 0. ? 0. : potential(in.time);
  if (!(now <= 0.))
    return 0;
  Solvent solvent; // the same for nearly all points
  const double at_rest = mixing_stress(swelling, interaction), stretch = std::pow(swelling, 2. / 3.);
  for (std::size_t q = 0; q < in.n_points; ++q)
  {
    const dealii::Tensor<2, dim> &F = in.deformation_gradient[q];
    const double J = dealii::determinant(F), J_t = J * swelling;
    if (!is_admissible(J) || !is_admissible(J_t))
      return q;
    const double *old = in.history_old + q * n_history();
    if (q == 0 || old[1] != solvent.m_old)
      solvent = solvent_in_step(old[1], in.dt == 0. ? old[1] : now, out);
    const double m = solvent.m, free = solvent.free;
    const dealii::SymmetricTensor<2, dim> b = left_cauchy_green(F);
    // All is told from the state at rest, where it vanishes exactly.
    const double pressure =
        mixing / swelling *
        (mixing_stress(J_t, interaction) - at_rest - m * (J_t - swelling) - (m - m_at_rest) * swelling);
    if (out.stress)
    {
      out.stress[q] = mu * b;
      for (unsigned int i = 0; i < dim; ++i)
        out.stress[q][i][i] += pressure - mu;
    }
    if (out.tangent)
      out.tangent[q] = isotropic_modulus<dim>(mixing / swelling * (mixing_slope(J_t, interaction) - m * J_t),
                                              mu - pressure);
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[q] = pressure;
    if (out.energy)
      out.energy[q] = 0.5 * shear_of_network / swelling *
                          (stretch * (dealii::trace(b) + 3 - dim) - 3. * std::pow(free, 2. / 3.) -
                           2. * std::log(J_t / free)) +
                      mixing / swelling * (mixing_energy(free, J_t, interaction) - m * (J_t - free));
    if (out.dissipation)
      out.dissipation[q] = 0.;
    if (out.supply)
      out.supply[q] = supply(solvent, old[0], J);
    if (out.history_new)
    {
      out.history_new[q * n_history()] = J;
      out.history_new[q * n_history() + 1] = m;
    }
  }
  return in.n_points;
}

template class FloryRehner<2>;
template class FloryRehner<3>;

namespace
{
[[maybe_unused]] const bool registered = register_law<FloryRehner>(
    "flory_rehner", "Gel in balance with a solvent, which it takes up and gives away.");
}
} // namespace softgrain::constitutive
