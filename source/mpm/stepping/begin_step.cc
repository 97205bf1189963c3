// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/mpm/stepping/begin_step.h>
#include <softgrain/mpm/stepping/pressed_walls.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
std::vector<WallMotion<2>>
begin_step(const Problem &problem, State &state, Workspace &work, const StepPlan &plan)
{
  press_walls(problem, state, work, plan);
  return wall_motion(state, work, plan);
}

std::vector<WallMotion<2>> wall_motion(State &state, Workspace &work, const StepPlan &plan)
{
  const std::vector<Wall<2>> &walls = state.walls;
  for (Obstacle<2> &obstacle : state.obstacles)
    obstacle.plan(state.time, plan.held ? 0. : plan.dt);
  std::vector<WallMotion<2>> motion;
  for (const Wall<2> &wall : walls)
  {
    const WallRates told = plan.held ? WallRates() : told_rates(wall, state.time, plan.dt);
    motion.push_back({wall.point(), wall.normal(), told.speed, is_plane(wall), told.speed,
                      std::abs(told.speed), told.slide});
  }
  for (const FreeWall<2> &free : work.contact.free_walls.list)
    if (!free.slides() || free.is_side())
      motion[free.wall].fastest = std::max(motion[free.wall].fastest, free.fastest());
  drive_slabs(state, motion, work);
  return motion;
}

void drive_slabs(const State &state, const std::vector<WallMotion<2>> &motion, Workspace &work)
{
  for_slabs(state.walls, [&](const std::size_t w, const unsigned int body)
            { work.drive[body] = motion[w].mean_velocity(); });
}
} // namespace softgrain::mpm
