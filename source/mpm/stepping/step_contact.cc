// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/row_velocity.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/step_contact.h>

#include <algorithm>
#include <filesystem>

namespace softgrain::mpm
{
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

void StepContact::condense()
{
  dealii::TimerOutput::Scope section(*work.timer, "condensation");
  work.contact.condense(work.share, state.bodies, work.solvers);
}

std::string StepContact::solve_condensed(const Vectors &trial, const Vectors &direction)
{
  free.resize(trial.size());
  for (unsigned int b = 0; b < trial.size(); ++b)
    if (!state.bodies[b].rigid.driven && work.share.mine(b))
      free[b] = trial[b] + direction[b];
  return solve(free, false);
}

std::string StepContact::solve_lumped(const Vectors &trial)
{
  work.contact.lump(state.bodies, plan.dt);
  // The momentum balance at the present iterate, solved for the contact velocities with the masses alone.
  Vectors v = trial;
  for (unsigned int b = 0; b < trial.size(); ++b)
    if (!state.bodies[b].rigid.driven && work.share.mine(b))
    {
      const Eigen::VectorXd R = equations.unbalanced(b);
      for (unsigned int i = 0; i < state.bodies[b].nodes.mass.size(); ++i)
        v[b].segment<2>(2 * i) += R.segment<2>(2 * i) / state.bodies[b].nodes.mass[i];
    }
  return solve(v, true);
}

std::string StepContact::solve(const Vectors &v, const bool relative)
{
  dealii::TimerOutput::Scope section(*work.timer, "contact solve");
  const double theta = problem.settings.scheme.theta;
  const contact::SolverSettings &settings = problem.settings.contact_solver;
  const double allowed = 100. * settings.tolerance;
  // Where theta is 1 a closed gap opens, else it stays as it is.
  const Opening opening{theta == 1., problem.lattice->cell_size()};
  const contact::SolverReport report = work.contact.solve(
      row_velocity(state, work, v, motion, equations.start_relative, theta, plan.dt, opening, relative),
      settings, relative);
  outcome.contact_sweeps += report.sweeps;
  outcome.contact_residual = report.residual;
  // Rows denser than the nodes make W nearly singular, and with friction the sweeps may stand still a
  // little above the tolerance: the step is then right to five digits, its residual is reported, and
  // cutting it would not help.
  is_converged = report.converged || report.limited_by_rounding || report.residual <= allowed;
  if (is_converged)
    return "";
  if (!problem.settings.failed_problem_directory.empty())
  {
    std::filesystem::create_directories(problem.settings.failed_problem_directory);
    work.contact.save_problem(problem.settings.failed_problem_directory + "/contact-" +
                                  short_number(state.time) + ".h5",
                              "time " + short_number(state.time) + " s, step " + short_number(plan.dt) + " s",
                              problem.settings.contact_solver);
  }
  return not_solved(report);
}
} // namespace softgrain::mpm
