// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/newton_search.h>
#include <softgrain/mpm/stepping/refused_step.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
NewtonSearch::NewtonSearch(const Problem &problem,
                           const State &state,
                           const Workspace &work,
                           StepEquations &equations)
    : problem(problem), state(state), work(work), equations(equations)
{
}

bool NewtonSearch::converged() const
{
  const Settings &settings = problem.settings;
  const double residual = equations.residual();
  // Below its rounding nothing is found, whatever is asked for.
  const bool rounded = stands_still && equations.at_rounding();
  if (residual > settings.residual_tolerance && !rounded)
    return false;
  // Lumped contact is an iteration of its own: the bulk may be balanced while the contact velocities are
  // not yet right.
  if (!work.contact.empty() && settings.coupling == ContactCoupling::lumped)
    // (3.22) down to the rounding of the velocities; a step that starts near its solution has a small first
    // increment.
    return last_length <=
           std::max(settings.displacement_tolerance * first_length, 1e-10 * equations.trial_length());
  // (3.22), with the velocity increment in place of the displacement increment: they differ by theta dt. In
  // free flight the first increment is rounding already.
  return last_length <= 1e-10 * equations.trial_length() ||
         (last_length <= settings.displacement_tolerance * first_length &&
          std::abs(last_work) <= settings.energy_tolerance * std::abs(first_work)) ||
         residual <= 0.1 * settings.residual_tolerance || rounded;
}

std::string NewtonSearch::go(Vectors &trial,
                             const Vectors &direction,
                             const StepEquations::Slope &slope,
                             const bool first)
{
  last_length = slope.length;
  last_work = slope.work;
  if (first)
  {
    first_length = last_length;
    first_work = last_work;
  }
  x.resize(trial.size());
  from.resize(trial.size());
  for (unsigned int b = 0; b < trial.size(); ++b)
    if (!state.bodies[b].rigid.driven && work.share.mine(b))
    {
      x[b] = trial[b];
      from[b] = equations.increment[b];
    }
  double best = std::numeric_limits<double>::max();
  for (double alpha = 1.; alpha > 0.01; alpha *= 0.5)
  {
    if (!equations.evaluate_on_way({x, direction, from}, alpha, trial))
      continue;
    const double now = equations.unbalanced_norm();
    best = std::min(best, now);
    if (now <= (1. - 1e-4 * alpha) * slope.merit ||
        equations.residual() <= problem.settings.residual_tolerance)
    {
      // Factors that leave so little of the imbalance once do so again, for a fraction of the work. With
      // lumped contact iterations go on long after the bulk is balanced.
      factors_serve =
          now <= 0.03 * slope.merit || (problem.settings.coupling == ContactCoupling::lumped &&
                                        equations.residual() <= problem.settings.residual_tolerance);
      stands_still = now > 0.1 * slope.merit;
      return "";
    }
  }
  return best == std::numeric_limits<double>::max() ? equations.why_not()
                                                    : end_of_search(trial, direction, best / slope.merit);
}

std::string NewtonSearch::end_of_search(Vectors &trial, const Vectors &direction, const double least)
{
  if (!equations.evaluate_on_way({x, direction, from}, 0., trial))
    return equations.why_not();
  stands_still = true;
  factors_serve = false;
  if (equations.at_rounding())
    return "";
  return "the line search found no residual below " + short_number(least * equations.residual()) +
         ", and 'Newton/Residual tolerance' is " + short_number(problem.settings.residual_tolerance);
}
} // namespace softgrain::mpm
