// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/wall_position.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/wall.h>
#include <softgrain/geometry/box.h>
#include <softgrain/geometry/periodic_cell.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/model/state_file.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
constexpr std::size_t n_numbers = 10; // that the state of a wall is made of

bool keeps_slide(const Wall &wall)
{
  return wall.slide_speed != 0. || wall.offset != 0.;
}

FreeWallStep free_step(const double mass,
                       const double damping,
                       const double speed,
                       const double load,
                       const double impulse,
                       const double dt,
                       const double theta)
{
  // Damping acts on the velocity with which the wall moves, so a wall at rest bears its whole load, and any
  // coefficient is stable.
  FreeWallStep step;
  step.mass = mass + theta * dt * damping;
  step.free_speed = ((mass - (1. - theta) * dt * damping) * speed + dt * load + impulse) / step.mass;
  return step;
}

/// Whether a wall moves along its tangent at all.
bool goes_along(const WallDescription<2> &wall)
{
  return wall.drive->slides() || wall.drive->shears();
}

std::string tangential_key(const WallDescription<2> &wall)
{
  return wall.drive->shears() ? "Shear stress" : "Tangential velocity";
}
} // namespace

WallState<2> state_of(const Wall &wall)
{
  WallState<2> state;
  state.name = wall.description.name;
  state.point = wall.point();
  state.normal = wall.normal();
  state.position = wall_position(state.point, state.normal);
  state.velocity = wall.speed;
  state.slide_velocity = wall.slide_speed;
  state.repeats = is_side_of_cell(wall);
  state.offset = wall.offset;
  state.normal_force = 0. - wall.book.force * wall.normal();
  state.tangential_force = wall.book.force * wall.tangent();
  return state;
}

dealii::Tensor<1, 2> prescribed_velocity_of(const Wall &wall)
{
  return (wall.prescribed() ? wall.speed : 0.) * wall.description.normal +
         (slides_freely(wall) ? 0. : wall.slide_speed) * wall.tangent();
}

void put_pressure(Wall &wall, const double asked, const double length, const double share_of_damping)
{
  FreeMotion &free = wall.free;
  const WallDrive &drive = *wall.description.drive;
  free.pressure = free.pressure_before + (drive.looks_beside() ? 0.4 : 1.) * (asked - free.pressure_before);
  free.across.force = free.pressure * length;
  // Of the period 2 pi sqrt(mass / pressure) little is left: the wall settles about as fast as grains of its
  // mass rearrange under that pressure.
  free.across.damping = drive.inertia().damping.value_or(
      2. * std::sqrt(free.across.mass * std::abs(free.pressure)) * share_of_damping);
}

void put_shear(Wall &wall, const double asked, const double length)
{
  WallLoad &along = wall.free.along;
  along.force = asked * length;
  along.damping =
      wall.description.drive->inertia().damping.value_or(2. * std::sqrt(along.mass * std::abs(asked)));
}

double kinetic_energy_of(const Wall &wall)
{
  return 0.5 * (wall.free.across.mass * wall.speed * wall.speed +
                wall.free.along.mass * wall.slide_speed * wall.slide_speed);
}

namespace
{
/// The step of a wall as its drive sees it.
WallStep step_of(const Wall &wall, const double time, const double dt, const double stress_beside = 0.)
{
  return {time - wall.driven_since.time, dt, wall.travel - wall.driven_since.travel, stress_beside};
}
} // namespace

WallDemand demand_of(const Wall &wall, const double time, const double dt, const double stress_beside)
{
  return wall.description.drive->demand(step_of(wall, time, dt, stress_beside));
}

double demanded_slide(const Wall &wall, const double time, const double dt)
{
  const WallDrive &drive = *wall.description.drive;
  return drive.slides() ? drive.slide_velocity(step_of(wall, time, dt)) : 0.;
}

double demanded_shear(const Wall &wall, const double time, const double dt)
{
  return wall.description.drive->shear_stress(step_of(wall, time, dt));
}

FreeWallStep free_wall_step(const Wall &wall, const double dt, const double theta, const double impulse)
{
  return free_step(wall.free.across.mass, wall.free.across.damping, wall.speed, wall.free.across.force,
                   impulse, dt, theta);
}

FreeWallStep free_slide_step(const Wall &wall, const double dt, const double theta, const double impulse)
{
  return free_step(wall.free.along.mass, wall.free.along.damping, wall.slide_speed, wall.free.along.force,
                   impulse, dt, theta);
}

std::vector<Wall> make_walls(const Scene<2> &scene)
{
  double mass = 0.;
  for (const BodyDescription<2> &body : scene.bodies)
    if (!body.driven)
      mass += scene.materials[body.material].density * body.shape->area();
  std::vector<Wall> walls;
  for (const WallDescription<2> &description : scene.walls)
  {
    walls.emplace_back();
    walls.back().description = description;
    walls.back().free.usual_mass = 0.1 * mass;
    if (!walls.back().prescribed())
      walls.back().free.across.mass = description.drive->inertia().mass.value_or(0.1 * mass);
    if (description.drive->shears())
      walls.back().free.along.mass = description.drive->inertia().mass.value_or(0.1 * mass);
  }
  return walls;
}

double stress_beside(const std::vector<Wall> &walls, const std::size_t w)
{
  double sum = 0.;
  unsigned int n = 0;
  for (std::size_t v = 0; v < walls.size(); ++v)
    if (std::abs(walls[v].normal() * walls[w].normal()) < 1e-12)
    {
      const double length = pressed_length(walls, v);
      if (length <= 0.)
        continue;
      sum -= walls[v].book.force * walls[v].normal() / length;
      ++n;
    }
  return n > 0 ? sum / n : 0.;
}

void take_drives(std::vector<Wall> &walls,
                 const std::vector<std::shared_ptr<const WallDrive>> &drives,
                 const double time,
                 const bool inertia)
{
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    if (!drives[w])
      continue;
    Wall &wall = walls[w];
    const double energy_before = kinetic_energy_of(wall);
    wall.description.drive = drives[w];
    wall.driven_since.time = time;
    wall.driven_since.travel = wall.travel;
    wall.free.across.mass = wall.prescribed() ? 0. : drives[w]->inertia().mass.value_or(wall.free.usual_mass);
    wall.free.along.mass =
        slides_freely(wall) ? drives[w]->inertia().mass.value_or(wall.free.usual_mass) : 0.;
    if (inertia)
      wall.book.work += kinetic_energy_of(wall) - energy_before;
  }
}

void check_free_walls(const Scene<2> &scene)
{
  for (std::size_t w = 0; w < scene.walls.size(); ++w)
    if (!scene.walls[w].drive->prescribed() && length_between_neighbours_2d(scene.walls, w) <= 0.)
      throw InputError("'Walls/" + scene.walls[w].name + "/Drive' = '" + scene.walls[w].drive_name +
                       "' needs two walls beside it, at right angles, between which the pressure acts");
    else if (scene.walls[w].drive->shears() && length_between_neighbours_2d(scene.walls, w) <= 0.)
      throw InputError("'Walls/" + scene.walls[w].name +
                       "/Shear stress' needs two walls beside it, at right angles, between which it acts");
  for (const WallDescription<2> &wall : scene.walls)
    for (const WallDescription<2> &other : scene.walls)
      if (wall.drive->looks_beside() && std::abs(wall.normal * other.normal) < 1e-12)
      {
        const std::size_t o = &other - scene.walls.data();
        const std::string is = "'Walls/" + wall.name + "/Drive' = '" + wall.drive_name + "' ";
        if (length_between_neighbours_2d(scene.walls, o) <= 0.)
          throw InputError(is + "needs a wall that faces it, so that there is a stress on wall '" +
                           other.name + "'");
        if (other.drive->looks_beside())
          throw InputError(is + "follows the stress on wall '" + other.name +
                           "', which must not follow in turn: choose another drive for one of them");
      }
}

void check_sliding_walls(const Scene<2> &scene)
{
  const auto repeats = [](const WallDescription<2> &wall)
  { return wall.type == WallDescription<2>::Type::periodic; };
  bool both[2] = {false, false};
  for (const WallDescription<2> &wall : scene.walls)
    if (repeats(wall))
      both[axis_of(wall.normal)] = true;
  for (const WallDescription<2> &wall : scene.walls)
  {
    const std::string at = "'Walls/" + wall.name + "/";
    if (goes_along(wall) && repeats(wall) && !(axis_of(wall.normal) == 1 && both[0]))
      throw InputError(at + tangential_key(wall) +
                       "' is not allowed with 'Type' = 'periodic' but at top and bottom of a "
                       "cell that repeats along x and y");
    if (goes_along(wall) && !repeats(wall) && wall.friction == 0.)
      throw InputError(at + tangential_key(wall) + "' has no effect without friction: set '" + at.substr(1) +
                       "Friction', or leave it out");
    for (const WallDescription<2> &other : scene.walls)
      if (&wall != &other && repeats(wall) && repeats(other) && wall.drive->shears() && goes_along(other))
        throw InputError(at + "Shear stress' is not allowed where 'Walls/" + other.name + "/" +
                         tangential_key(other) + "' moves the side that faces it");
      else if (&wall != &other && repeats(wall) && repeats(other) && !wall.drive->prescribed() &&
               !other.drive->prescribed() && axis_of(wall.normal) == axis_of(other.normal))
        throw InputError(at + "Drive' = '" + wall.drive_name + "' is not allowed where 'Walls/" + other.name +
                         "/Drive' = '" + other.drive_name +
                         "' moves the side that faces it: of two periodic walls one may be free to move");
  }
}

std::vector<WallState<2>> states_of(const std::vector<Wall> &walls)
{
  std::vector<WallState<2>> states;
  for (const Wall &wall : walls)
    states.push_back(state_of(wall));
  return states;
}

double pressed_length(const std::vector<Wall> &walls, const std::size_t w)
{
  return length_between_neighbours_2d(states_of(walls), w);
}

void save_walls(StateWriter &out, const std::string &name, const std::vector<Wall> &walls)
{
  std::vector<double> numbers;
  for (const Wall &wall : walls)
    numbers.insert(numbers.end(), {wall.travel, wall.speed, wall.book.force[0], wall.book.force[1],
                                   wall.book.impulse[0], wall.book.impulse[1], wall.free.pressure_before,
                                   wall.driven_since.time, wall.driven_since.travel, wall.book.work});
  out.write(name, numbers);
  if (std::none_of(walls.begin(), walls.end(), keeps_slide))
    return;
  std::vector<double> sliding;
  for (const Wall &wall : walls)
    sliding.insert(sliding.end(), {wall.slide_speed, wall.offset});
  out.write(name + "_sliding", sliding);
}

void load_walls(const StateReader &in, const std::string &name, std::vector<Wall> &walls)
{
  const std::vector<double> numbers = in.read_doubles(name, n_numbers * walls.size());
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    const double *v = &numbers[n_numbers * w];
    walls[w].travel = v[0];
    walls[w].speed = v[1];
    walls[w].book.force = dealii::Tensor<1, 2>({v[2], v[3]});
    walls[w].book.impulse = dealii::Tensor<1, 2>({v[4], v[5]});
    walls[w].free.pressure = walls[w].free.pressure_before = v[6];
    walls[w].driven_since.time = v[7];
    walls[w].driven_since.travel = v[8];
    walls[w].book.work = v[9];
  }
  if (!in.contains(name + "_sliding"))
    return;
  const std::vector<double> sliding = in.read_doubles(name + "_sliding", 2 * walls.size());
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    walls[w].slide_speed = sliding[2 * w];
    walls[w].offset = sliding[2 * w + 1];
  }
}
} // namespace softgrain
