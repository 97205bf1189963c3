// SPDX-License-Identifier: LGPL-2.1-or-later
// How walls and obstacles in space move, and what they do.
#include <softgrain/driving/obstacle_partner.h>
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/driving/wall_partner.h>
#include <softgrain/mpm/contact/obstacle_solid.h>
#include <softgrain/mpm/model/space_model.h>
#include <softgrain/scene/wall_drive.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
/// Mean over a step from @p time on; of a wall under a load where it began.
WallMotion<3> motion_of(Wall<3> wall, const double time, const double dt)
{
  const bool free = is_free(wall, Freedom::across);
  WallMotion<3> motion{free ? wall.description.point : wall.point(), wall.normal(), 0.};
  motion.plane = is_plane(wall);
  if (free || dt == 0.)
    return motion;
  plan(wall, time, dt);
  motion.velocity = wall.speed;
  motion.slide = wall.slide_speed;
  return motion;
}

/// Wall @p w under a load in a step of @p dt, in which an area of @p area bears its pressure. A light one
/// that nothing bears would fly through all of the box: a step in which it has gone as far as the settings
/// allow is made in shorter ones.
WallWithMass with_mass(Wall<3> wall,
                       const unsigned int w,
                       const double area,
                       const double time,
                       const double dt,
                       const Settings &settings)
{
  put_pressure(wall, demand_of(wall, time, dt).pressure, area);
  const FreeWallStep step = free_wall_step(wall, dt, settings.scheme.theta);
  FreeWall<3> free;
  free.wall = w;
  free.normal = free.way = wall.normal();
  free.mass = step.mass;
  free.free_speed = step.free_speed;
  free.start_speed = wall.speed;
  free.stop_flight(settings.wall_motion * settings.cell_size / dt);
  return {free, wall.free.across};
}

/// The pressure on a wall under a load at the end of a step [Pa].
std::optional<double> pressure_on(const Wall<3> &wall, const double time, const double dt)
{
  if (!is_free(wall, Freedom::across))
    return std::nullopt;
  return demand_of(wall, time + dt, 0.).pressure;
}
} // namespace

void SpaceModel::take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives)
{
  softgrain::take_drives(driven, drives, state.time, !at_rest());
  for (std::size_t w = 0; w < driven.size(); ++w)
    if (drives[w])
      begin_under_load(w);
}

void SpaceModel::begin_under_load(const std::size_t w)
{
  state.loaded[w].way = driven[w].travel;
  state.loaded[w].speed = driven[w].speed;
}

double SpaceModel::fastest_obstacle(const double dt) const
{
  double speed = 0.;
  for (const Obstacle<3> &obstacle : state.obstacles)
    speed = std::max(speed, ObstacleSolid(obstacle, obstacle.motion(state.time, dt)).largest_way() / dt);
  return speed;
}

SpaceMotion SpaceModel::motion(const double dt) const
{
  SpaceMotion motion;
  motion.cell_offset = state.cell_offset;
  for (const Wall<3> &wall : driven)
  {
    motion.walls.push_back(motion_of(wall, state.time, dt));
    motion.pressure.push_back(pressure_on(wall, state.time, dt));
    const double begin = begin_of_load(wall, state.time, dt > 0. ? 0. : last_dt);
    motion.pressure_at_start.push_back(pressure_on(wall, begin, 0.).value_or(0.));
  }
  if (!at_rest())
  {
    const std::vector<WallMotion<3>> now = walls_now(motion, state.loaded);
    for (std::size_t w = 0; w < driven.size(); ++w)
      motion.free.push_back(motion.pressure[w]
                                ? with_mass(driven[w], w, pressed_area(now, w), state.time, dt, settings)
                                : WallWithMass());
  }
  for (const Obstacle<3> &obstacle : state.obstacles)
    motion.obstacles.push_back(obstacle.motion(state.time, dt));
  return motion;
}

void SpaceModel::book_wall(const std::size_t w,
                           const SpaceMotion &motion,
                           const double dt,
                           double &of_load,
                           std::vector<DrivenWork> &works)
{
  Wall<3> &wall = driven[w];
  const WallMotion<3> &moves = motion.walls[w];
  const dealii::Tensor<1, 3> before =
      at_rest() ? dealii::Tensor<1, 3>() - wall.book.force : state.wall_force[w];
  const bool loaded = motion.pressure[w].has_value();
  wall.speed = loaded ? (state.loaded[w].way - wall.travel) / dt : moves.velocity;
  wall.slide_speed = moves.slide;
  const dealii::Tensor<1, 3> way = dt * wall.velocity();
  if (!loaded)
  {
    wall.travel += dt * wall.speed;
    wall.book.work += 0.5 * (before + state.wall_force[w]) * way;
  }
  else if (!at_rest())
    wall.speed = state.loaded[w].speed;
  works.push_back(
      {loaded ? &of_load : &wall.book.work, 0.5 * std::abs((state.wall_force[w] - before) * way)});
  wall.book.force = dealii::Tensor<1, 3>() - state.wall_force[w];
}

void SpaceModel::follow_step()
{
  for_sides(driven, [this](Wall<3> &side) { side.offset = state.cell_offset; });
  for (std::size_t w = 0; w < driven.size(); ++w)
  {
    if (!is_free(driven[w], Freedom::across))
      continue;
    driven[w].travel = state.loaded[w].way;
    driven[w].book.work += state.loaded[w].work;
    state.loaded[w].work = 0.;
  }
}

void SpaceModel::book(const SpaceMotion &motion, const double dt)
{
  std::vector<DrivenWork> works;
  std::vector<double> of_loads(driven.size(), 0.); // what the mean lacks is part of their work already
  for (std::size_t w = 0; w < driven.size(); ++w)
    book_wall(w, motion, dt, of_loads[w], works);
  follow_step();
  if (!at_rest())
    return;
  book_obstacles(motion, works);
  state.losses.rubbed += give_kinks(state.kinks, works) * state.kinks.of_slides;
  for (const double given : of_loads)
    state.losses.regularisation -= given;
}

// From balance to balance; with inertia the step has told their work.
void SpaceModel::book_obstacles(const SpaceMotion &motion, std::vector<DrivenWork> &works)
{
  for (unsigned int o = 0; o < state.obstacles.size(); ++o)
  {
    const Obstacle<3> &before = before_step.progress.obstacles[o];
    state.obstacles[o].way = motion.obstacles[o];
    book_obstacle(state.obstacles[o], before.force, before.torque, works);
  }
}
} // namespace softgrain::mpm
