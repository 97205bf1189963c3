// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/newton_search.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
NewtonSearch::NewtonSearch(const Problem &problem, const Workspace &work, StepEquations &equations)
    : problem(problem), work(work), equations(equations)
{
}

bool NewtonSearch::converged(const Vectors &trial, const double residual) const
{
  const Settings &settings = problem.settings;
  if (residual > settings.residual_tolerance)
    return false;
  if (!settings.scheme.inertia)
    return true;
  // Lumped contact is an iteration of its own: the bulk may be balanced while the contact velocities are
  // not yet right.
  if (!work.contact.empty() && settings.coupling == ContactCoupling::lumped)
    // (3.22) down to the rounding of the velocities; a step that starts near its solution has a small first
    // increment.
    return last_length <= std::max(settings.displacement_tolerance * first_length, 1e-10 * length(trial));
  // (3.22), with the velocity increment in place of the displacement increment: they differ by theta dt. In
  // free flight the first increment is rounding already.
  return last_length <= 1e-10 * length(trial) ||
         (last_length <= settings.displacement_tolerance * first_length &&
          std::abs(last_work) <= settings.energy_tolerance * std::abs(first_work)) ||
         residual <= 0.1 * settings.residual_tolerance;
}

double NewtonSearch::length(const Vectors &v) const
{
  double sum = 0.;
  for (unsigned int b = 0; b < v.size(); ++b)
    if (equations.moves(b))
      sum += v[b].squaredNorm();
  return std::sqrt(sum);
}

std::string NewtonSearch::go(Vectors &trial, const Vectors &direction, const bool first)
{
  double work_done = 0., merit = 0.;
  for (unsigned int b = 0; b < trial.size(); ++b)
    if (equations.moves(b))
    {
      const Eigen::VectorXd R = equations.unbalanced(b);
      work_done += direction[b].dot(R);
      merit += R.squaredNorm();
    }
  last_length = length(direction);
  last_work = work_done;
  if (first)
  {
    first_length = last_length;
    first_work = last_work;
  }
  merit = std::sqrt(merit);
  const Vectors x = trial, from = equations.increment;
  double best = std::numeric_limits<double>::max();
  for (double alpha = 1.; alpha > 0.01; alpha *= 0.5)
  {
    for (unsigned int b = 0; b < trial.size(); ++b)
      if (equations.moves(b))
        trial[b] = equations.go(b, x[b], alpha, direction[b], from[b]);
    if (!equations.evaluate(trial))
      continue;
    const double now = equations.unbalanced_norm();
    best = std::min(best, now);
    if (now <= (1. - 1e-4 * alpha) * merit || equations.residual() <= problem.settings.residual_tolerance ||
        still_goes_down(direction, work_done))
    {
      // Factors that leave so little of the imbalance once do so again, for a fraction of the work. With
      // lumped contact iterations go on long after the bulk is balanced.
      factors_serve = now <= 0.03 * merit || (problem.settings.coupling == ContactCoupling::lumped &&
                                              equations.residual() <= problem.settings.residual_tolerance);
      return "";
    }
  }
  return best == std::numeric_limits<double>::max() ? equations.why_not()
                                                    : "the line search found no smaller residual";
}

/// Without inertia a step looks for least energy. With pressure that follows, the matrix is not the
/// derivative and the imbalance may grow on the way down: good is what does not go far uphill again.
/// @param work_at_start of the imbalance along the direction
bool NewtonSearch::still_goes_down(const Vectors &direction, const double work_at_start) const
{
  if (problem.settings.scheme.inertia || !equations.pressure_follows() || work_at_start <= 0.)
    return false;
  double at_end = 0.;
  for (unsigned int b = 0; b < direction.size(); ++b)
    if (equations.moves(b))
      at_end += direction[b].dot(equations.unbalanced(b));
  return at_end >= -0.5 * work_at_start;
}
} // namespace softgrain::mpm
