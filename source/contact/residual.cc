// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/block_delassus.h>
#include <softgrain/contact/diagonal_delassus.h>
#include <softgrain/contact/mass_delassus.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <limits>
#include <string>

namespace softgrain::contact
{
namespace
{
template <unsigned int n>
double largest_natural_map(const Problem &problem,
                           const std::vector<double> &compliance,
                           const std::vector<double> &impulses,
                           const std::vector<double> &velocities)
{
  double worst = 0.;
  for (std::size_t i = 0; i < compliance.size(); ++i)
    if (compliance[i] > 0.)
    {
      const double here =
          natural_map<n>(&impulses[i * n], &velocities[i * n], problem.friction_of(i), compliance[i]);
      // not max(): a NaN must be seen
      if (!(here <= worst))
        worst = here;
      if (std::isnan(worst))
        return worst;
    }
  return worst;
}

template <unsigned int n>
double mean_natural_map(const Problem &problem,
                        const std::vector<double> &compliance,
                        const std::vector<double> &impulses,
                        const std::vector<double> &velocities)
{
  double sum = 0.;
  std::size_t n_carry = 0;
  for (std::size_t i = 0; i < compliance.size(); ++i)
    if (compliance[i] > 0.)
    {
      const double here =
          natural_map<n>(&impulses[i * n], &velocities[i * n], problem.friction_of(i), compliance[i]);
      sum += here * here; // of open ones, too: they may overlap
      n_carry += impulses[i * n] > 0.;
    }
  return std::sqrt(sum / std::max<std::size_t>(n_carry, 1));
}

template <unsigned int n>
double squared_natural_map(const Problem &problem,
                           const std::vector<double> &impulses,
                           const std::vector<double> &velocities)
{
  double sum = 0.;
  for (unsigned int i = 0; i < problem.n_contacts(); ++i)
  {
    const double here = natural_map<n>(&impulses[i * n], &velocities[i * n], problem.friction_of(i), 1.);
    sum += here * here;
  }
  return sum;
}

/// A velocity over the approach speed.
double relative(const double error, const Problem &problem, const std::vector<double> &compliance)
{
  if (error == 0.)
    return 0.;
  const double speed = approach_speed(problem, compliance);
  return speed > 0. ? error / speed : std::numeric_limits<double>::infinity();
}

double norm(const std::vector<double> &x)
{
  double sum = 0.;
  for (const double value : x)
    sum += value * value;
  return std::sqrt(sum);
}
} // namespace

template <class Operator>
std::vector<double> contact_compliance(const Operator &op)
{
  const unsigned int n = op.n_components();
  std::vector<double> compliance(op.n_contacts()), normal(op.n_contacts());
  double largest = 0.;
  for (std::size_t i = 0; i < compliance.size(); ++i)
  {
    double block[9];
    op.diagonal_block(i, block);
    for (unsigned int c = 0; c < n; ++c)
      compliance[i] += block[c * n + c] / n;
    for (unsigned int c = 0; c < n * n; ++c)
      if (!std::isfinite(block[c]))
        throw ComputationError("contact " + std::to_string(i) + ": the Delassus operator is not finite");
    normal[i] = block[0];
    largest = std::max(largest, normal[i]);
  }
  for (std::size_t i = 0; i < compliance.size(); ++i)
    if (!(normal[i] > 1e-20 * largest))
      compliance[i] = 0.;
  return compliance;
}

template std::vector<double> contact_compliance(const DiagonalDelassus &);
template std::vector<double> contact_compliance(const BlockDelassus &);
template std::vector<double> contact_compliance(const MassDelassus &);

double approach_speed(const Problem &problem, const std::vector<double> &compliance)
{
  double speed = 0.;
  for (std::size_t i = 0; i < compliance.size(); ++i)
    if (compliance[i] > 0.)
      speed = std::max(speed, -problem.free_velocity[i * problem.n_components]);
  return speed;
}

double natural_residual(const Problem &problem,
                        const std::vector<double> &compliance,
                        const std::vector<double> &impulses,
                        const std::vector<double> &velocities)
{
  const auto map = problem.n_components == 1   ? largest_natural_map<1>
                   : problem.n_components == 2 ? largest_natural_map<2>
                                               : largest_natural_map<3>;
  return relative(map(problem, compliance, impulses, velocities), problem, compliance);
}

double mean_natural_residual(const Problem &problem,
                             const std::vector<double> &compliance,
                             const std::vector<double> &impulses,
                             const std::vector<double> &velocities)
{
  const auto map = problem.n_components == 1   ? mean_natural_map<1>
                   : problem.n_components == 2 ? mean_natural_map<2>
                                               : mean_natural_map<3>;
  return relative(map(problem, compliance, impulses, velocities), problem, compliance);
}

double siconos_residual(const Problem &problem,
                        const std::vector<double> &impulses,
                        const std::vector<double> &velocities)
{
  const auto map = problem.n_components == 1   ? squared_natural_map<1>
                   : problem.n_components == 2 ? squared_natural_map<2>
                                               : squared_natural_map<3>;
  const double error = std::sqrt(map(problem, impulses, velocities));
  const double scale = std::max({norm(impulses), norm(velocities), norm(problem.free_velocity)});
  return error == 0. ? 0. : error / scale;
}

double prescribed_approach(const Problem &problem,
                           const std::vector<double> &compliance,
                           const std::vector<double> &velocities)
{
  double speed = 0.;
  for (std::size_t i = 0; i < compliance.size(); ++i)
    if (!(compliance[i] > 0.))
      speed = std::max(speed, -velocities[i * problem.n_components]);
  return speed;
}
} // namespace softgrain::contact
