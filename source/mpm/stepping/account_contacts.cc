// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/account_contacts.h>
#include <softgrain/mpm/stepping/contact_work.h>
#include <softgrain/mpm/stepping/driven_work.h>
#include <softgrain/mpm/stepping/pressed_walls.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
void account_contacts(
    const Problem &problem, State &state, const Workspace &work, const FoundStep &step, const double dt)
{
  const std::vector<WallMotion<2>> &motion = step.motion;
  std::vector<dealii::Tensor<1, 2>> force_before;
  for (unsigned int w = 0; w < state.walls.size(); ++w)
  {
    force_before.push_back(state.walls[w].force);
    state.walls[w].force = 0.;
    state.walls[w].speed = motion[w].rate;
    state.walls[w].slide_speed = motion[w].slide;
  }
  std::vector<std::pair<dealii::Tensor<1, 2>, double>> felt_before; // by obstacles: force and torque
  for (Obstacle<2> &obstacle : state.obstacles)
  {
    felt_before.emplace_back(obstacle.force, obstacle.torque);
    obstacle.arrive();
  }
  const std::optional<CellMotion> cell = state.cell_motion(motion);
  dealii::Tensor<2, 2> virial;
  // From balance to balance forces change steadily: their work is that of the mean of both ends.
  const bool balanced = !problem.settings.scheme.inertia;
  const auto give = [&](Wall &wall, const dealii::Tensor<1, 2> &given)
  {
    wall.give(given, dt);
    state.balance.wall_impulse += given;
    wall.work += given * (balanced ? wall.velocity() : wall.prescribed_velocity());
  };
  state.balance.subgrid_energy = step.dents;
  state.balance.adhesion_work += step.adhesion_work;
  const auto &rows = work.contact.contact_rows();
  const unsigned int components = work.contact.n_components();
  const std::vector<double> &P = work.contact.impulses();
  const ContactWork contact(problem, state, work, dt, step.rate, motion);
  for (unsigned int r = 0; r < rows.size(); ++r)
    for (unsigned int c = 0; c < components; ++c)
    {
      if (!contact.acts(r, c))
        continue;
      const double impulse = P[r * components + c], acting = contact.acting(r, c);
      const dealii::Tensor<1, 2> given = impulse * rows[r].direction(c);
      if (rows[r].obstacle)
      {
        Obstacle<2> &obstacle = state.obstacles[rows[r].wall - state.walls.size()];
        obstacle.give(given, rows[r].place, dt);
        state.balance.wall_impulse += given;
        if (!balanced)
          obstacle.work += acting * (rows[r].partner_velocity * rows[r].direction(c));
      }
      else if (rows[r].wall != ContactRow<2>::none)
        give(state.walls[rows[r].wall], given);
      else if (rows[r].partner != ContactRow<2>::none && state.bodies[rows[r].partner].driven)
      {
        state.balance.wall_impulse += given;
        state.balance.driven_work += acting * (rows[r].direction(c) * work.drive[rows[r].partner]);
      }
      if (cell)
        virial += impulse / dt * outer_product(rows[r].direction(c), rows[r].branch);
      if (c == 0 && !balanced)
      {
        const double pulled = contact.adhesion_work(r);
        state.balance.adhesion_work += pulled;
        state.balance.contact_loss += pulled - rows[r].work_beyond;
      }
      // From balance to balance normal forces do no work: gaps are closed at both ends. What rows that have
      // moved in between would say is rounding in a smooth step, and meaningless where grains rearrange.
      if (c > 0 || !balanced)
        state.balance.contact_loss -= acting * contact.parting(r, c);
    }
  if (cell)
  {
    load_sides(state.walls, cell->cell, virial);
    for (Wall &wall : state.walls)
      if (wall.repeats())
        wall.work -= dt * (wall.force * (balanced ? wall.velocity() : wall.prescribed_velocity()));
  }
  std::vector<DrivenWork> driven;
  for (unsigned int o = 0; balanced && o < state.obstacles.size(); ++o)
  {
    Obstacle<2> &obstacle = state.obstacles[o];
    const ObstacleMotion<2> &way = obstacle.way;
    if (way.dt == 0.)
      continue;
    const dealii::Tensor<1, 2> shift = way.end.shift - way.start.shift;
    const double angle = way.end.angle - way.start.angle;
    obstacle.work -= 0.5 * (felt_before[o].first + obstacle.force) * shift +
                     0.5 * (felt_before[o].second + obstacle.torque) * angle;
    driven.push_back({&obstacle.work, 0.5 * std::abs((obstacle.force - felt_before[o].first) * shift +
                                                     (obstacle.torque - felt_before[o].second) * angle)});
  }
  if (balanced)
    for (unsigned int w = 0; w < state.walls.size(); ++w)
    {
      Wall &wall = state.walls[w];
      double change = 0.5 * dt * wall.speed * (wall.force - force_before[w]) * wall.description.normal;
      if (wall.slide_speed != 0.)
        change += 0.5 * dt * wall.slide_speed * (wall.force - force_before[w]) * wall.tangent();
      wall.work += change;
      driven.push_back({&wall.work, std::abs(change)});
    }
  if (const double share = give_kinks(step.kinks, driven); share > 0.)
    state.balance.contact_loss += share * step.kinks.of_slides;
  for (const FreeWall<2> &free : work.contact.free_walls.list)
    account_free_wall(problem, state, free, free.slides() ? motion[free.wall].slide : motion[free.wall].rate,
                      dt, problem.settings.scheme.implicit);
}
} // namespace softgrain::mpm
