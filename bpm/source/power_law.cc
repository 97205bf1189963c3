// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/bpm/power_law.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>

namespace softgrain::bpm
{
namespace
{
/// x^n for a small whole n: a handful of products instead of a logarithm and an exponential.
double whole_power(double x, unsigned int n)
{
  double result = 1.;
  for (; n > 0; n >>= 1)
  {
    if (n & 1)
      result *= x;
    x *= x;
  }
  return result;
}

[[maybe_unused]] const bool registered = Registry<Attraction>::instance().add(
    "power_law",
    "force F0 (1 + gap/a0)^-exponent up to a cutoff; exponent 7: the attraction of Lennard-Jones.",
    [] { return std::make_unique<PowerLaw>(); });
} // namespace

void PowerLaw::declare_parameters(dealii::ParameterHandler &prm) const
{
  using dealii::Patterns::Double;
  prm.declare_entry(
      "Force at contact", "100", Double(0.),
      "F0, the attraction of two primaries that touch, which is the largest; in space in N. Units: N/m.");
  prm.declare_entry("Exponent", "7", Double(1.01, 100.), "Exponent gamma of the force. Units: none.");
  declare_cutoff(prm);
}

void PowerLaw::declare_cutoff(dealii::ParameterHandler &prm)
{
  prm.declare_entry("Cutoff", "1", dealii::Patterns::Double(0., 10.),
                    "Gap beyond which there is no attraction. Units: sum of the two radii.");
}

void PowerLaw::parse_parameters(dealii::ParameterHandler &prm)
{
  largest_force = prm.get_double("Force at contact");
  exponent = prm.get_double("Exponent");
  cutoff = prm.get_double("Cutoff");
}

void PowerLaw::evaluate(
    const std::size_t n, const double *distance, const double *sum, double *force, double *energy) const
{
  const bool whole = exponent == std::floor(exponent) && exponent <= 32.;
  const unsigned int power = whole ? static_cast<unsigned int>(exponent) : 0;
  if (whole)
    for (std::size_t i = 0; i < n; ++i)
      force[i] = largest_force * whole_power(std::min(1., sum[i] / distance[i]), power);
  else
    for (std::size_t i = 0; i < n; ++i)
      force[i] = largest_force * std::pow(std::min(1., sum[i] / distance[i]), exponent);
  if (energy == nullptr)
    return;
  // U = -∫ F from the distance to the cutoff; below contact the force is constant.
  const double at_cutoff = std::pow(1. + cutoff, 1. - exponent);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double stretch = std::max(1., distance[i] / sum[i]);
    const double overlap = std::min(0., distance[i] - sum[i]);
    // F (d/a0) is F0 (d/a0)^(1 - γ), which saves a power
    energy[i] = -sum[i] / (exponent - 1.) * (force[i] * stretch - largest_force * at_cutoff) +
                largest_force * overlap;
  }
}
} // namespace softgrain::bpm
