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
template <unsigned int n, class Visit>
void visit_natural_maps_of(const Problem &problem,
                           const std::vector<double> &compliance,
                           const std::vector<double> &impulses,
                           const std::vector<double> &velocities,
                           const Visit &visit)
{
  for (std::size_t i = 0; i < compliance.size(); ++i)
    if (compliance[i] > 0.)
      visit(i, natural_map<n>(&impulses[i * n], &velocities[i * n], problem.friction_of(i), compliance[i]));
}

/// Calls @p visit with the number and the natural_map() of every contact that has a compliance.
template <class Visit>
void visit_natural_maps(const Problem &problem,
                        const std::vector<double> &compliance,
                        const std::vector<double> &impulses,
                        const std::vector<double> &velocities,
                        const Visit &visit)
{
  if (problem.n_components == 1)
    visit_natural_maps_of<1>(problem, compliance, impulses, velocities, visit);
  else if (problem.n_components == 2)
    visit_natural_maps_of<2>(problem, compliance, impulses, velocities, visit);
  else
    visit_natural_maps_of<3>(problem, compliance, impulses, velocities, visit);
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
  double worst = 0.;
  visit_natural_maps(problem, compliance, impulses, velocities,
                     [&](std::size_t, const double here)
                     {
                       // not max(): a NaN must be seen, and stay
                       if (!(here <= worst) && !std::isnan(worst))
                         worst = here;
                     });
  return relative(worst, problem, compliance);
}

double siconos_residual(const Problem &problem,
                        const std::vector<double> &impulses,
                        const std::vector<double> &velocities)
{
  double sum = 0.;
  visit_natural_maps(problem, std::vector<double>(problem.n_contacts(), 1.), impulses, velocities,
                     [&](std::size_t, const double here) { sum += here * here; });
  const double error = std::sqrt(sum);
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
