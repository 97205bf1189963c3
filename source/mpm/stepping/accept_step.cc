// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/stepping/accept_step.h>
#include <softgrain/mpm/stepping/account_contacts.h>
#include <softgrain/mpm/stepping/account_loads.h>
#include <softgrain/mpm/stepping/cell_work.h>
#include <softgrain/mpm/stepping/keep_points.h>
#include <softgrain/mpm/stepping/step_rows.h>
#include <softgrain/mpm/stepping/time_integrator.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace softgrain::mpm
{
namespace
{
/// What has become of the contacts, for laws that remember.
void note_contacts(State &state,
                   const Workspace &work,
                   const std::vector<Eigen::VectorXd> &increment,
                   const std::vector<WallMotion<2>> &motion,
                   const double dt)
{
  constexpr double near_limit = 1. - 1e-6; // of friction: solvers have tolerances
  const auto &rows = work.contact.contact_rows();
  const unsigned int components = work.contact.n_components();
  const std::vector<double> gaps = end_gaps(state, work, increment, motion, dt), &P = work.contact.impulses();
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    const double closing = P[r * components] + dt * rows[r].law.pull;
    const bool slides = components > 1 && closing > 0. && rows[r].law.friction > 0. &&
                        std::abs(P[r * components + 1]) >= near_limit * rows[r].law.friction * closing;
    state.adhesion.note(rows[r].key, rows[r].gap, {gaps[r], closing > 0., slides, dt});
  }
}

/// What nodes do, of all bodies; @p cell takes them along.
void move_bodies(const Problem &problem,
                 State &state,
                 const Workspace &work,
                 FoundStep &step,
                 const std::optional<CellMotion<2>> &cell)
{
  const double dt = step.plan.dt;
  for (Body<2> &body : state.bodies)
    if (body.rigid.driven)
    {
      body.translate(dt * work.drive[body.index]);
      move_boundary(body);
    }
  std::vector<dealii::Point<2>> centers;
  if (cell && cell->deforms())
    for (const Body<2> &body : state.bodies)
      centers.push_back(body.center());
  for_moving(state.bodies,
             [&](Body<2> &body)
             {
               Eigen::VectorXd &v = step.velocity[body.index];
               body.nodes.kept = problem.settings.scheme.integrator->kept(
                   {body, step.plan, v, step.rate[body.index], step.external[body.index]});
               std::swap(body.nodes.internal_force, step.internal_force[body.index]);
               body.nodes.displacement += step.increment[body.index];
               if (cell && cell->deforms())
                 body.translate(dt * cell->velocity(centers[body.index]));
               if (body.nodes.velocity.size() > 0)
                 std::swap(body.nodes.velocity, v);
               if (body.field.markers().size() > 0)
                 move_boundary(body);
             });
}

/// What points of owned bodies do, and what their laws have lost and got.
void move_points(const Problem &problem, State &state, const Workspace &work)
{
  std::vector<double> law_loss(state.bodies.size(), 0.), law_supply = law_loss;
  work.share.for_mine(
      state.bodies,
      [&](Body<2> &body)
      {
        const WorkOfLaw of_law = keep_points(work.trial[body.index], body);
        law_loss[body.index] = of_law.loss;
        law_supply[body.index] = of_law.supply;
      },
      [&](BodyShare::Message &message)
      {
        message.add(law_loss);
        message.add(law_supply);
        for (Body<2> &body : state.bodies)
          if (!body.rigid.driven && problem.settings.meets_by_rays())
            message.add_outline(body);
      });
  for (const double lost : law_loss)
    state.balance.losses.add(loss::law, lost);
  for (const double supply : law_supply)
    state.balance.growth_work += supply;
}

void move_walls(State &state, const FoundStep &step, const std::optional<CellMotion<2>> &cell)
{
  const double dt = step.plan.dt;
  for (unsigned int w = 0; w < state.walls.size(); ++w)
  {
    state.walls[w].travel += dt * step.motion[w].velocity;
    accept_pressure(state.walls[w]);
  }
  for_sides(state.walls, [&](Wall<2> &side) { side.offset = cell->offset_after(dt); });
}
} // namespace

void accept_step(const Problem &problem, State &state, Workspace &work, FoundStep &step)
{
  const double dt = step.plan.dt;
  state.balance.losses.add(step.losses);
  state.balance.sums.add(step.sums);
  state.resistance = step.resistance;
  account_contacts(problem, state, work, step);
  if (state.adhesion.remembers())
  {
    if (!problem.settings.meets_by_rays()) // rays have memories of their own
      note_contacts(state, work, step.increment, step.motion, dt);
    state.adhesion.finish_step();
  }
  account_loads(state, work, step);
  const std::optional<CellMotion<2>> cell = state.cell_motion(step.motion);
  move_bodies(problem, state, work, step, cell);
  move_points(problem, state, work);
  if (cell && !step.balanced)
  {
    const CellWork<2> done = measure_against_cell(*cell, dt, state.bodies);
    state.balance.momentum.of_loads += done.impulse;
    state.balance.cell_work += done.work;
  }
  move_walls(state, step, cell);
  if (!step.plan.held)
    state.time += dt;
  state.memory = work.contact.memory(dt);
}
} // namespace softgrain::mpm
