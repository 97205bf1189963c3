// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/wall_position.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/wall.h>
#include <softgrain/geometry/box.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/scene/cell_checks.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
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

/// Gives a wall the masses with which its drive moves it.
template <int dim>
void weigh(Wall<dim> &wall)
{
  const double mass = wall.description.drive->inertia().mass.value_or(wall.free.usual_mass);
  wall.free.across.mass = wall.prescribed() ? 0. : mass;
  wall.free.along.mass = slides_freely(wall) ? mass : 0.;
}
} // namespace

template <int dim>
WallState<dim> state_of(const Wall<dim> &wall)
{
  WallState<dim> state;
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

dealii::Tensor<1, 2> prescribed_velocity_of(const Wall<2> &wall)
{
  return (wall.prescribed() ? wall.speed : 0.) * wall.description.normal +
         (slides_freely(wall) ? 0. : wall.slide_speed) * wall.tangent();
}

template <int dim>
void put_pressure(Wall<dim> &wall, const double asked, const double size, const double share_of_damping)
{
  FreeMotion &free = wall.free;
  const WallDrive &drive = *wall.description.drive;
  free.pressure = free.pressure_before + (drive.looks_beside() ? 0.4 : 1.) * (asked - free.pressure_before);
  free.across.force = free.pressure * size;
  // Little is left of the period 2 pi sqrt(mass / pressure), in space that with the pressure times a length:
  // the wall settles about as fast as grains of its mass rearrange under that pressure.
  const double stiffness = std::abs(free.pressure) * (dim == 2 ? 1. : std::sqrt(size));
  free.across.damping =
      drive.inertia().damping.value_or(2. * std::sqrt(free.across.mass * stiffness) * share_of_damping);
}

void put_shear(Wall<2> &wall, const double asked, const double length)
{
  WallLoad &along = wall.free.along;
  along.force = asked * length;
  along.damping =
      wall.description.drive->inertia().damping.value_or(2. * std::sqrt(along.mass * std::abs(asked)));
}

template <int dim>
double kinetic_energy_of(const Wall<dim> &wall)
{
  return 0.5 * (wall.free.across.mass * wall.speed * wall.speed +
                wall.free.along.mass * wall.slide_speed * wall.slide_speed);
}

namespace
{
/// The step of a wall as its drive sees it.
template <int dim>
WallStep step_of(const Wall<dim> &wall, const double time, const double dt, const double stress_beside = 0.)
{
  return {time - wall.driven_since.time, dt, wall.travel - wall.driven_since.travel, stress_beside};
}
} // namespace

template <int dim>
WallDemand demand_of(const Wall<dim> &wall, const double time, const double dt, const double stress_beside)
{
  return wall.description.drive->demand(step_of(wall, time, dt, stress_beside));
}

template <int dim>
double demanded_slide(const Wall<dim> &wall, const double time, const double dt)
{
  const WallDrive &drive = *wall.description.drive;
  return drive.slides() ? drive.slide_velocity(step_of(wall, time, dt)) : 0.;
}

template <int dim>
void plan(Wall<dim> &wall, const double time, const double dt)
{
  wall.speed = demand_of(wall, time, dt).velocity;
  wall.slide_speed = demanded_slide(wall, time, dt);
}

double demanded_shear(const Wall<2> &wall, const double time, const double dt)
{
  return wall.description.drive->shear_stress(step_of(wall, time, dt));
}

template <int dim>
FreeWallStep free_wall_step(const Wall<dim> &wall, const double dt, const double theta, const double impulse)
{
  return free_step(wall.free.across.mass, wall.free.across.damping, wall.speed, wall.free.across.force,
                   impulse, dt, theta);
}

FreeWallStep free_slide_step(const Wall<2> &wall, const double dt, const double theta, const double impulse)
{
  return free_step(wall.free.along.mass, wall.free.along.damping, wall.slide_speed, wall.free.along.force,
                   impulse, dt, theta);
}

namespace
{
double size_of(const Shape<2> &shape)
{
  return shape.area();
}

double size_of(const Shape<3> &shape)
{
  return shape.volume();
}

/// What walls that are free weigh if nothing is given: a tenth of what moves [kg/m; kg].
template <int dim>
double usual_mass(const Scene<dim> &scene)
{
  double mass = 0.;
  for (const BodyDescription<dim> &body : scene.bodies)
    if (!body.driven)
      mass += scene.materials[body.material].density * size_of(*body.shape);
  return 0.1 * mass;
}
} // namespace

template <int dim>
std::vector<Wall<dim>> make_walls(const Scene<dim> &scene)
{
  const double mass = usual_mass(scene);
  std::vector<Wall<dim>> walls;
  for (const WallDescription<dim> &description : scene.walls)
  {
    Wall<dim> &wall = walls.emplace_back();
    wall.description = description;
    wall.free.usual_mass = mass;
    weigh(wall);
  }
  return walls;
}

double stress_beside(const std::vector<Wall<2>> &walls, const std::size_t w)
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

template <int dim>
void take_drives(std::vector<Wall<dim>> &walls,
                 const std::vector<std::shared_ptr<const WallDrive>> &drives,
                 const double time,
                 const bool inertia)
{
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    if (!drives[w])
      continue;
    Wall<dim> &wall = walls[w];
    const double energy_before = kinetic_energy_of(wall);
    wall.description.drive = drives[w];
    wall.driven_since.time = time;
    wall.driven_since.travel = wall.travel;
    weigh(wall);
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
  for (const WallDescription<2> &wall : scene.walls)
    if ((wall.drive->slides() || wall.drive->shears()) && !repeats(wall) && wall.friction == 0.)
    {
      const std::string at = "Walls/" + wall.name + "/";
      throw InputError("'" + at + tangential_key(wall) + "' has no effect without friction: set '" + at +
                       "Friction', or leave it out");
    }
  check_motion_of_sides(scene.walls);
}

template <int dim>
std::vector<WallState<dim>> states_of(const std::vector<Wall<dim>> &walls)
{
  std::vector<WallState<dim>> states;
  for (const Wall<dim> &wall : walls)
    states.push_back(state_of(wall));
  return states;
}

double pressed_length(const std::vector<Wall<2>> &walls, const std::size_t w)
{
  return length_between_neighbours_2d(states_of(walls), w);
}

template void put_pressure(Wall<2> &, double, double, double);
template void put_pressure(Wall<3> &, double, double, double);
template FreeWallStep free_wall_step(const Wall<2> &, double, double, double);
template FreeWallStep free_wall_step(const Wall<3> &, double, double, double);
template WallState<2> state_of(const Wall<2> &);
template double kinetic_energy_of(const Wall<2> &);
template WallDemand demand_of(const Wall<2> &, double, double, double);
template double demanded_slide(const Wall<2> &, double, double);
template void plan(Wall<2> &, double, double);
template std::vector<Wall<2>> make_walls(const Scene<2> &);
template void
take_drives(std::vector<Wall<2>> &, const std::vector<std::shared_ptr<const WallDrive>> &, double, bool);
template std::vector<WallState<2>> states_of(const std::vector<Wall<2>> &);
template WallState<3> state_of(const Wall<3> &);
template double kinetic_energy_of(const Wall<3> &);
template WallDemand demand_of(const Wall<3> &, double, double, double);
template double demanded_slide(const Wall<3> &, double, double);
template void plan(Wall<3> &, double, double);
template std::vector<Wall<3>> make_walls(const Scene<3> &);
template void
take_drives(std::vector<Wall<3>> &, const std::vector<std::shared_ptr<const WallDrive>> &, double, bool);
template std::vector<WallState<3>> states_of(const std::vector<Wall<3>> &);
} // namespace softgrain
