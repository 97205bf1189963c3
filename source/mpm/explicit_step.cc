// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/assembly.h>
#include <softgrain/mpm/external_force.h>
#include <softgrain/mpm/world.h>

#include <sstream>

namespace softgrain::mpm
{
namespace
{
using Vectors = std::vector<Eigen::VectorXd>;

/// Contact impulses on the free velocities @p v; they become the velocities at the end of the step.
void solve_contacts(
    World &world, const double dt, const std::vector<WallMotion<2>> &motion, Vectors &v, StepOutcome &outcome)
{
  {
    dealii::TimerOutput::Scope section(*world.timer, "contact search");
    std::vector<ContactRow<2>> rows;
    world.geometry->find({world.bodies, motion, world.scene.friction, dt, world.lattice->cell_size()}, rows);
    world.contact.reinit(std::move(rows), world.bodies);
  }
  if (world.contact.empty())
    return;
  dealii::TimerOutput::Scope section(*world.timer, "contact solve");
  world.contact.lump(world.bodies);
  std::vector<double> q = world.contact.relative_velocity(world.bodies, v);
  const auto &rows = world.contact.contact_rows();
  const unsigned int components = world.contact.n_components();
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    if (rows[r].partner == ContactRow<2>::none)
      q[r * components] -= motion[rows[r].wall].velocity;
    // An open gap may close, but no further; a closed one holds at velocity level.
    if (rows[r].gap > 0.)
      q[r * components] += rows[r].gap / dt;
  }
  const contact::SolverReport report = world.contact.solve(std::move(q), world.settings.contact_solver);
  outcome.contact_sweeps = report.sweeps;
  outcome.contact_residual = report.residual;
  if (!report.converged)
  {
    std::ostringstream text;
    text << "the contact solver left a residual of " << report.residual << " after " << report.sweeps
         << " sweeps ('Contact/Maximum sweeps')";
    outcome.reason = text.str();
    return;
  }
  for (unsigned int b = 0; b < world.bodies.size(); ++b)
    if (!world.bodies[b].driven)
    {
      Eigen::VectorXd impulse = Eigen::VectorXd::Zero(v[b].size());
      world.contact.add_impulses(b, world.contact.impulses(), impulse);
      for (unsigned int i = 0; i < world.bodies[b].mass.size(); ++i)
        v[b].segment<2>(2 * i) += impulse.segment<2>(2 * i) / world.bodies[b].mass[i];
    }
}
} // namespace

StepOutcome explicit_step(World &world, const double dt)
{
  StepOutcome outcome;
  const std::vector<WallMotion<2>> motion = world.wall_motion(dt);
  const unsigned int n_bodies = world.bodies.size();
  Vectors v(n_bodies), external(n_bodies), increment(n_bodies);
  for (Wall &wall : world.walls)
    if (wall.body != ContactRow<2>::none)
      world.bodies[wall.body].drive = motion[&wall - world.walls.data()].velocity * wall.description.normal;
  for (unsigned int b = 0; b < n_bodies; ++b)
  {
    Body<2> &body = world.bodies[b];
    v[b] = body.velocity;
    if (body.driven)
      continue;
    if (!external_force(body, world.scene.gravity, world.time, external[b]))
      external[b].resize(0);
    for (unsigned int i = 0; i < body.mass.size(); ++i)
    {
      v[b].segment<2>(2 * i) += dt / body.mass[i] * body.internal_force.segment<2>(2 * i);
      if (external[b].size() > 0)
        v[b].segment<2>(2 * i) += dt / body.mass[i] * external[b].segment<2>(2 * i);
    }
  }
  solve_contacts(world, dt, motion, v, outcome);
  if (!outcome.reason.empty())
    return outcome;

  dealii::TimerOutput::Scope section(*world.timer, "stress and forces");
  Vectors forces(n_bodies);
  for (unsigned int b = 0; b < n_bodies; ++b)
  {
    Body<2> &body = world.bodies[b];
    increment[b] = dt * v[b];
    if (body.driven)
      continue;
    const double half_dt = world.settings.grid_update == GridUpdate::every_step ? 0.5 * dt : 0.;
    const StressOutcome stress = evaluate_stress(body, Eigen::VectorXd(body.displacement + increment[b]),
                                                 increment[b], half_dt, {false, true});
    if (!stress.good())
    {
      std::ostringstream text;
      text << "a material point of body '" << body.name << "' turned inside out near ("
           << body.points[stress.bad_point].position()
           << ") m of its grid; a smaller 'Time/Time step' or 'Mesh/Cell size' may help";
      outcome.reason = text.str();
      return outcome;
    }
    internal_force(body, forces[b]);
  }
  for (unsigned int b = 0; b < n_bodies; ++b)
    if (!world.bodies[b].driven)
      std::swap(world.bodies[b].internal_force, forces[b]);
  if (!world.contact.empty())
    for (const double g : end_gaps(world, increment, motion, dt))
      outcome.max_penetration = std::max(outcome.max_penetration, -g);
  // Impulses act between the velocities before and after: their work is that of the mean, which makes the
  // energy balance of symplectic Euler exact up to the stored energy.
  Vectors rate(n_bodies);
  for (unsigned int b = 0; b < n_bodies; ++b)
    rate[b] = 0.5 * (world.bodies[b].velocity + v[b]);
  accept_step(world, dt, v, increment, rate, motion, external);
  outcome.accepted = true;
  return outcome;
}
} // namespace softgrain::mpm
