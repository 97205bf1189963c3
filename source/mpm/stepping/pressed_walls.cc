// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/stepping/begin_step.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/wall_imbalance.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
/// Resists a wall without inertia by a spring that starts from nothing in every step, as bodies are, and lets
/// it go no further than the settings allow.
void resist(
    const Problem &problem, const State &state, const StepPlan &plan, const double load, FreeWall<2> &free)
{
  const Settings &settings = problem.settings;
  const double dt = plan.dt, stiffness = 10. * plan.regularisation * softest(state.bodies);
  free.mass = stiffness * dt * dt;
  free.free_speed = dt * load / free.mass;
  free.start_speed = 0.;
  free.stop = settings.wall_motion * problem.lattice->cell_size() / dt *
              std::min(1., settings.regularisation / plan.regularisation);
}

/// With inertia: a light wall that nothing bears would fly through all of the box in a long step. It goes no
/// further than the settings allow, or twice as far as it does already; a step at whose end it is there is
/// made in shorter ones.
void stop_flight(const Problem &problem, const double dt, FreeWall<2> &free)
{
  if (problem.settings.scheme.solves_equations())
    free.stop_flight(problem.settings.wall_motion * problem.lattice->cell_size() / dt);
}

/// A wall of the step that is free in a direction.
FreeWall<2> free_wall(const State &state, const unsigned int w, const Freedom direction)
{
  FreeWall<2> free;
  free.wall = w;
  free.normal = state.walls[w].normal();
  free.way = way_of(state.walls[w], direction);
  free.length = length_across(state.walls, w);
  free.slab = state.walls[w].body;
  return free;
}

/// Makes a wall that is free in a direction an unknown of the step.
void add_free_wall(const Problem &problem,
                   State &state,
                   Workspace &work,
                   const StepPlan &plan,
                   const unsigned int w,
                   const Freedom direction)
{
  Wall<2> &wall = state.walls[w];
  FreeWall<2> free = free_wall(state, w, direction);
  const TimeScheme &scheme = problem.settings.scheme;
  if (scheme.ends_in_balance())
    resist(problem, state, plan, load_on(wall, direction).force, free);
  else
  {
    const FreeWallStep step = free_step(wall, direction, plan.dt, scheme.theta);
    free.mass = step.mass;
    free.free_speed = step.free_speed;
    free.start_speed = speed_of(wall, direction);
    stop_flight(problem, plan.dt, free);
  }
  free.speed = free.start_speed;
  work.contact.free_walls.list.push_back(free);
}
} // namespace

void press_walls(const Problem &problem, State &state, Workspace &work, const StepPlan &plan)
{
  // Balance is at the end of a step, motion takes the mean.
  const bool at_end = problem.settings.scheme.ends_in_balance();
  const double time = state.time + (at_end && !plan.held ? plan.dt : 0.), over = at_end ? 0. : plan.dt;
  work.contact.free_walls.list.clear();
  for (unsigned int w = 0; w < state.walls.size(); ++w)
    for (const Freedom direction : freedoms_of(state.walls[w]))
    {
      put_stress(state.walls, w, direction, time, over);
      add_free_wall(problem, state, work, plan, w, direction);
    }
}

void follow_free_walls(const Problem &problem, const Workspace &work, std::vector<WallMotion<2>> &motion)
{
  const TimeScheme &scheme = problem.settings.scheme;
  for (const FreeWall<2> &free : work.contact.free_walls.list)
  {
    WallMotion<2> &here = motion[free.wall];
    if (free.slides())
    {
      here.slide = scheme.over_step(free.start_speed, free.speed);
      continue;
    }
    here.velocity = scheme.over_step(free.start_speed, free.speed);
    here.rate = scheme.at_work(free.start_speed, free.speed);
  }
}

void settle_free_walls(const Problem &problem,
                       const State &state,
                       Workspace &work,
                       std::vector<WallMotion<2>> &motion)
{
  follow_free_walls(problem, work, motion);
  drive_slabs(state, motion, work);
}

void account_free_wall(
    const Problem &problem, State &state, const FreeWall<2> &free, const double rate, const double dt)
{
  Wall<2> &wall = state.walls[free.wall];
  const Freedom direction = freedom_of(free);
  const TimeScheme &scheme = problem.settings.scheme;
  speed_of(wall, direction) = scheme.ends_in_balance() ? rate : free.speed;
  if (scheme.ends_in_balance())
    return;
  const WallLoad &load = load_on(wall, direction);
  const double moving = scheme.over_step(free.start_speed, free.speed);
  wall.book.work += dt * load.force * rate;
  state.balance.wall_damping_loss += dt * load.damping * moving * rate;
  state.balance.losses.add(loss::scheme, scheme.loss_of_wall(load.mass, free.speed - free.start_speed));
}

namespace
{
WallImbalance worst_wall(const Problem &problem, const State &state)
{
  WallImbalance worst;
  const double floor = 1e-6 * softest(state.bodies) * problem.lattice->cell_size();
  for (unsigned int w = 0; w < state.walls.size(); ++w)
  {
    const Wall<2> &wall = state.walls[w];
    // Walls beside it have moved: length and stress are others.
    for (const Freedom direction : freedoms_of(wall))
      worst.compare(w, direction == Freedom::along, -1. * (wall.book.force * way_of(wall, direction)),
                    asked_stress(state.walls, w, direction, state.time, 0.) * pressed_length(state.walls, w),
                    floor);
  }
  return worst;
}
} // namespace

double unbalanced_walls(const Problem &problem, const State &state)
{
  return worst_wall(problem, state).share;
}

std::string least_balanced_wall(const Problem &problem, const State &state)
{
  const WallImbalance worst = worst_wall(problem, state);
  return worst.share > 0. ? worst.in_words(state.walls[worst.wall].description.name, "N/m") : "";
}

bool walls_are_on_their_way(const Workspace &work)
{
  const auto &list = work.contact.free_walls.list;
  return std::any_of(list.begin(), list.end(), [](const FreeWall<2> &free) { return free.at_stop(); });
}

double slid_on_their_way(const Workspace &work, const double dt)
{
  double way = 0.;
  for (const FreeWall<2> &free : work.contact.free_walls.list)
    if (free.slides() && free.at_stop())
      way = std::max(way, dt * std::abs(free.speed));
  return way;
}

void check_room_of_walls(const Problem &problem, const State &state, const double slid)
{
  const double room = problem.settings.mesh_lower.distance(problem.settings.mesh_upper);
  for (const Wall<2> &wall : state.walls)
    if (is_free(wall, Freedom::along) && slid > room)
    {
      std::ostringstream message;
      message << "at time " << state.time << " s nothing bears the shear stress of wall '"
              << wall.description.name << "': it has slid " << slid << " m";
      throw ComputationError(message.str());
    }
  for (unsigned int w = 0; w < state.walls.size(); ++w)
    if (is_free(state.walls[w], Freedom::across) &&
        (pressed_length(state.walls, w) <= 0. || std::abs(state.walls[w].travel) > room))
    {
      std::ostringstream message;
      message << "at time " << state.time << " s nothing bears the pressure of wall '"
              << state.walls[w].description.name << "': it has gone " << state.walls[w].travel << " m";
      throw ComputationError(message.str());
    }
}
} // namespace softgrain::mpm
