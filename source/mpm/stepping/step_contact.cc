// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/row_velocity.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/step_contact.h>

#include <algorithm>
#include <filesystem>

namespace softgrain::mpm
{
namespace
{
/// Of a contact problem in an iteration that is not the last, relative to the speed of approach.
constexpr double passable_residual = 0.1;
constexpr double finest_tolerance = 1e-7;    ///< of a contact problem, to which Newton brings it
constexpr unsigned int rough_iterations = 8; ///< in which that will do
} // namespace

StepContact::StepContact(const Problem &problem,
                         const State &state,
                         Workspace &work,
                         const StepPlan &plan,
                         const std::vector<WallMotion<2>> &motion,
                         const StepEquations &equations,
                         StepOutcome &outcome)
    : problem(problem)
    , state(state)
    , work(work)
    , plan(plan)
    , motion(motion)
    , equations(equations)
    , outcome(outcome)
{
}

void StepContact::condense(const bool new_factors)
{
  if (!new_factors && !condensed_is_old)
    return;
  dealii::TimerOutput::Scope section(*work.timer, "condensation");
  work.contact.condense(work.share, state.bodies, work.solvers, problem.subgrid(), plan.dt,
                        problem.settings.scheme.theta);
  condensed_is_old = false;
}

std::string StepContact::solve_condensed(const Vectors &trial, const Vectors &direction)
{
  free.resize(trial.size());
  for (unsigned int b = 0; b < trial.size(); ++b)
    if (equations.moves(b) && work.share.mine(b))
      free[b] = trial[b] + direction[b];
  return solve(free, false);
}

std::string StepContact::solve_lumped(const Vectors &trial)
{
  work.contact.lump(state.bodies, plan.dt);
  // The momentum balance at the present iterate, solved for the contact velocities with the masses alone.
  Vectors v = trial;
  for (unsigned int b = 0; b < trial.size(); ++b)
    if (equations.moves(b) && work.share.mine(b))
    {
      const Eigen::VectorXd R = equations.unbalanced(b);
      for (unsigned int i = 0; i < state.bodies[b].mass.size(); ++i)
        v[b].segment<2>(2 * i) += R.segment<2>(2 * i) / state.bodies[b].mass[i];
    }
  return solve(v, true);
}

// Without inertia nothing gets a velocity.
Opening StepContact::opening() const
{
  const Settings &settings = problem.settings;
  return {settings.scheme.theta == 1. || settings.rows_follow(),
          settings.scheme.inertia ? problem.lattice->cell_size() : 0.};
}

std::string StepContact::solve(const Vectors &v, const bool relative)
{
  dealii::TimerOutput::Scope section(*work.timer, "contact solve");
  const double theta = problem.settings.scheme.theta;
  contact::SolverSettings settings = problem.settings.contact_solver;
  // The iterations that come bring other rows and other problems; the last one must be solved.
  if (problem.settings.rows_follow() && outcome.newton_iterations < rough_iterations)
    settings.passable = passable_residual;
  const double allowed = 100. * problem.settings.contact_solver.tolerance;
  if (problem.settings.rows_follow() && problem.settings.scheme.inertia)
  {
    settings.passable_mean = allowed;
    // Every iteration has other rows: what one leaves open, the next does not mend.
    if (outcome.newton_iterations > 0)
      settings.tolerance =
          std::min(settings.tolerance, std::max(finest_tolerance, 0.1 * outcome.newton_residual));
  }
  const contact::SolverReport report = work.contact.solve(
      row_velocity(state, work, v, motion, equations.start_relative, theta, plan.dt, opening(), relative),
      settings, relative);
  outcome.contact_sweeps += report.sweeps;
  outcome.contact_residual = report.residual;
  // Rows denser than the nodes make W nearly singular, and with friction the sweeps may stand still a
  // little above the tolerance: the step is then right to five digits, its residual is reported, and
  // cutting it would not help. Likewise where all contacts are right to five digits in the mean, but one
  // neither sticks nor slides.
  is_converged =
      report.converged || report.limited_by_rounding || report.came_back || report.residual <= allowed;
  if (is_converged || report.residual <= settings.passable)
    return "";
  if (!problem.settings.failed_problem_directory.empty())
  {
    std::filesystem::create_directories(problem.settings.failed_problem_directory);
    work.contact.save_problem(problem.settings.failed_problem_directory + "/contact-" +
                                  short_number(state.time) + ".h5",
                              "time " + short_number(state.time) + " s, step " + short_number(plan.dt) + " s",
                              problem.settings.contact_solver);
  }
  return "the contact solver left a residual of " + short_number(report.residual) + " after " +
         std::to_string(report.sweeps) + " sweeps ('Contact/Maximum sweeps')";
}
} // namespace softgrain::mpm
