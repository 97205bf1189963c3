// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_memory.h>
#include <softgrain/mpm/contact/row_velocity.h>
#include <softgrain/mpm/stepping/accept_step.h>
#include <softgrain/mpm/stepping/begin_step.h>
#include <softgrain/mpm/stepping/contact_work.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/judge_step.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/ray_rows.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/step_rows.h>
#include <softgrain/mpm/stepping/stress.h>

#include <algorithm>
#include <optional>

namespace softgrain::mpm
{
namespace
{
using Vectors = std::vector<Eigen::VectorXd>;

/// Contact impulses on the free velocities @p v; they become the velocities at the end of the step.
void solve_contacts(const Problem &problem,
                    const State &state,
                    Workspace &work,
                    const double dt,
                    const std::vector<WallMotion<2>> &motion,
                    Vectors &v,
                    StepOutcome &outcome)
{
  if (work.contact.empty())
    return;
  dealii::TimerOutput::Scope section(*work.timer, "contact solve");
  work.contact.lump(state.bodies, dt);
  // An open gap may close, but no further; a closed one holds at velocity level.
  std::vector<double> free_velocity = row_velocity(state, work, v, motion, {}, 1., dt, {});
  take_back_softness(work.contact, dt, free_velocity);
  const contact::SolverReport report =
      work.contact.solve(std::move(free_velocity), problem.settings.contact_solver);
  outcome.contact_sweeps = report.sweeps;
  outcome.contact_residual = report.residual;
  if (!report.converged)
  {
    outcome.reason = not_solved(report);
    return;
  }
  for_moving(state.bodies,
             [&](const Body<2> &body)
             {
               Eigen::VectorXd impulse = Eigen::VectorXd::Zero(v[body.index].size());
               work.contact.add_impulses(body.index, impulse);
               for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
                 v[body.index].segment<2>(2 * i) += impulse.segment<2>(2 * i) / body.nodes.mass[i];
             });
}

/// What forces and loads do to the velocities @p v in a step, without contact.
void push_freely(const State &state, const double dt, const Vectors &external, Vectors &v)
{
  for_moving(state.bodies,
             [&](const Body<2> &body)
             {
               const Eigen::VectorXd &load = external[body.index];
               for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
               {
                 auto velocity = v[body.index].segment<2>(2 * i);
                 velocity += dt / body.nodes.mass[i] * body.nodes.internal_force.segment<2>(2 * i);
                 if (load.size() > 0)
                   velocity += dt / body.nodes.mass[i] * load.segment<2>(2 * i);
               }
             });
}

/// Internal forces at the end of the step. @return why they are not found or not taken
std::string find_forces(const Problem &problem,
                        const State &state,
                        Workspace &work,
                        const double dt,
                        const Vectors &increment,
                        Vectors &forces,
                        StepOutcome &outcome)
{
  std::vector<StressOutcome> stress(state.bodies.size());
  const double half_dt = problem.settings.grid_update == GridUpdate::every_step ? 0.5 * dt : 0.;
  SharedOutcomes outcomes(work.share, stress);
  work.share.for_mine(
      state.bodies,
      [&](const Body<2> &body)
      {
        const unsigned int b = body.index;
        stress[b] = evaluate_stress(body, Eigen::VectorXd(body.nodes.displacement + increment[b]),
                                    increment[b], {half_dt, false, 0., dt, state.time + dt}, work.trial[b]);
        if (stress[b].good())
          internal_force(body, work.trial[b], forces[b]);
      },
      [&](BodyShare::Message &message)
      {
        message.add(state.bodies, forces);
        outcomes.add_to(message);
      });
  outcomes.take();
  for (const Body<2> &body : state.bodies)
    if (!stress[body.index].good())
      return why_not(body, stress[body.index]);
  heed_laws(state.bodies, stress, outcome);
  return outcome.law_asks ? outcome.reason : "";
}
} // namespace

StepOutcome explicit_step(const Problem &problem, State &state, Workspace &work, const double dt)
{
  StepOutcome outcome;
  const StepPlan plan{dt, false, 0.};
  std::vector<WallMotion<2>> motion = begin_step(problem, state, work, plan);
  const unsigned int n_bodies = state.bodies.size();
  const LoadTimes loads{state.time, state.time, dt, true};
  Vectors v(n_bodies), increment(n_bodies), external = external_forces(state.bodies, work.share, loads);
  for (const Body<2> &body : state.bodies)
    v[body.index] = body.nodes.velocity;
  std::optional<RayRows> rays;
  if (problem.settings.meets_by_rays())
  {
    renew_outlines(state.bodies, work.outlines, state.frames);
    rays.emplace(problem, state, work, dt, motion).find();
  }
  else
    find_rows(problem, state, work, motion, dt);
  push_freely(state, dt, external, v);
  outcome.reason = or_why_it_failed(
      [&]()
      {
        solve_contacts(problem, state, work, dt, motion, v, outcome);
        return outcome.reason;
      });
  if (!outcome.reason.empty())
    return outcome;
  settle_free_walls(problem, state, work, motion);

  dealii::TimerOutput::Scope section(*work.timer, "stress and forces");
  Vectors forces(n_bodies);
  for (unsigned int b = 0; b < n_bodies; ++b)
    increment[b] = dt * v[b];
  outcome.reason = find_forces(problem, state, work, dt, increment, forces, outcome);
  if (!outcome.reason.empty())
    return outcome;
  if (!work.contact.empty())
    for (const double g : end_gaps(state, work, increment, motion, dt))
      outcome.max_penetration = std::max(outcome.max_penetration, -g);
  outcome.reason = judge_step(problem, state, work, motion, dt, increment, outcome);
  if (!outcome.reason.empty())
    return outcome;
  // Impulses act between the velocities before and after: their work is that of the mean, which makes the
  // energy balance of symplectic Euler exact up to the stored energy.
  Vectors rate(n_bodies);
  for (unsigned int b = 0; b < n_bodies; ++b)
    rate[b] = 0.5 * (state.bodies[b].nodes.velocity + v[b]);
  const ContactWork contact(state, work, dt, rate, motion, false);
  outcome.reason = why_contact_gives(problem, state, work, contact, increment);
  if (!outcome.reason.empty())
    return outcome;
  FoundStep found{plan, motion, v, forces, increment, rate, external, loads};
  if (rays)
    state.frames = rays->frames_after();
  accept_step(problem, state, work, found);
  outcome.accepted = true;
  return outcome;
}
} // namespace softgrain::mpm
