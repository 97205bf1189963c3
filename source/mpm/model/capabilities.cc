// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/mpm/model/capabilities.h>
#include <softgrain/mpm/stepping/time_integrator.h>
#include <softgrain/scene/motion_at_start.h>
#include <softgrain/scene/obstacle_drive.h>
#include <softgrain/scene/wall_drive.h>

#include <cmath>
#include <functional>

namespace softgrain::mpm
{
namespace
{
/// A row of the table: something that a scene may ask for, and who can do it.
template <int dim>
struct Capability
{
  /// Where a scene asks for it, "'Walls/top/Mass'"; empty: nowhere.
  std::function<std::string(const Scene<dim> &, const Settings &)> asked;
  bool (*is_there)(const Settings &);
  const char *otherwise; ///< what is said behind it where it is not; SCHEME stands for the name of the scheme
};

bool has_inertia(const Settings &settings)
{
  return !settings.scheme.ends_in_balance();
}

bool looks_for_balance(const Settings &settings)
{
  return has_inertia(settings) || settings.max_held_steps > 0;
}

bool knows_space(const Settings &settings)
{
  return settings.scheme.integrator->in_space();
}

bool meets_by_rays(const Settings &settings)
{
  return settings.meets_by_rays();
}

bool sees_cells(const Settings &settings)
{
  return settings.follows_contact();
}

std::string inertia_of_walls(const Scene<2> &scene, const Settings &)
{
  for (const WallDescription<2> &wall : scene.walls)
  {
    const WallInertia given = wall.drive->inertia();
    if (given.mass || given.damping)
      return "'Walls/" + wall.name + (given.mass ? "/Mass'" : "/Damping'");
  }
  return "";
}

std::string pressed_walls(const Scene<2> &scene, const Settings &)
{
  for (const WallDescription<2> &wall : scene.walls)
    if (is_free(wall, Freedom::across))
      return "'Quasi-static/Held steps' = '0' is not allowed with the pressure on wall '" + wall.name + "'";
  return "";
}

template <int dim>
std::string loads_of_velocity(const Scene<dim> &scene, const Settings &)
{
  for (const auto &load : scene.loads)
    if (load->sees_velocity())
      return "'Loads/" + load->key() + "'";
  return "";
}

template <int dim>
std::string motion_at_start(const Scene<dim> &scene, const Settings &)
{
  for (const BodyDescription<dim> &body : scene.bodies)
    if (!body.driven)
    {
      if (body.angular_velocity != 0.)
        return "'Bodies/" + body.name + "/Angular velocity'";
      if (starts_in_motion(body))
        return "'Bodies/" + body.name + "/Velocity' = '" + body.velocity + "'";
    }
  return "";
}

std::string space(const Scene<3> &, const Settings &)
{
  return "'Time/Scheme' = 'SCHEME' is not allowed with 'Dimension' = '3'";
}

std::string obstacles(const Scene<2> &scene, const Settings &settings)
{
  return scene.obstacles.empty()
             ? ""
             : "'Contact/Geometry' = '" + settings.contact_geometry +
                   "' is not allowed where the scene has 'Obstacles/" + scene.obstacles.front().name + "'";
}

template <int dim>
std::string free_obstacles(const Scene<dim> &scene, const Settings &)
{
  for (const ObstacleDescription<dim> &obstacle : scene.obstacles)
    if (obstacle.drive != nullptr && obstacle.drive->is_free())
      return "'Obstacles/" + obstacle.name + "/Drive'";
  return "";
}

std::string walls_along_bodies(const Scene<2> &scene, const Settings &)
{
  for (const WallDescription<2> &wall : scene.walls)
    if (wall.drive->shears() || wall.drive->slides())
      return "'Walls/" + wall.name + (wall.drive->shears() ? "/Shear stress'" : "/Tangential velocity'");
    else if (wall.type == WallDescription<2>::Type::periodic)
      return "'Walls/" + wall.name + "/Type' = 'periodic'";
  return "";
}

std::string cells_in_space(const Scene<3> &scene, const Settings &)
{
  for (const WallDescription<3> &wall : scene.walls)
    if (wall.type == WallDescription<3>::Type::periodic)
      return "'Walls/" + wall.name + "/Type' = 'periodic'";
  return "";
}

constexpr const char *no_velocity =
    " is not allowed with 'Time/Scheme' = 'SCHEME', where velocities have no meaning: leave it at 0, or give "
    "a 'Body force'";
constexpr const char *no_inertia =
    " is not allowed with 'Time/Scheme' = 'SCHEME', where nothing has inertia: set it to 'told'";
constexpr const char *no_motion =
    " has no effect with 'Time/Scheme' = 'SCHEME', where nothing has inertia: leave it at 0";

const std::vector<Capability<2>> in_the_plane = {
    {inertia_of_walls, has_inertia, " has no effect with 'Time/Scheme' = 'SCHEME': leave it at automatic"},
    {pressed_walls, looks_for_balance, ", which is found in held steps: it must be greater than 0"},
    {loads_of_velocity<2>, has_inertia, no_velocity},
    {motion_at_start<2>, has_inertia, no_motion},
    {obstacles, meets_by_rays, ": it sees planes only"},
    {free_obstacles<2>, has_inertia, no_inertia},
    {walls_along_bodies, sees_cells, " needs 'Contact/Geometry' = 'rays' and an implicit 'Time/Scheme'"}};

const std::vector<Capability<3>> in_space = {
    {space, knows_space, ": it must be 'quasi_static', 'moreau_jean' or 'explicit'"},
    {cells_in_space, sees_cells, " needs an implicit 'Time/Scheme'"},
    {loads_of_velocity<3>, has_inertia, no_velocity},
    {free_obstacles<3>, has_inertia, no_inertia},
    {motion_at_start<3>, has_inertia, no_motion}};

template <int dim>
void check(const std::vector<Capability<dim>> &table, const Scene<dim> &scene, const Settings &settings)
{
  for (const Capability<dim> &row : table)
  {
    if (row.is_there(settings))
      continue;
    const std::string asked = row.asked(scene, settings);
    if (asked.empty())
      continue;
    std::string message = asked + row.otherwise;
    const std::string blank = "SCHEME";
    if (const auto place = message.find(blank); place != std::string::npos)
      message.replace(place, blank.size(), settings.scheme.name);
    throw InputError(message);
  }
}
} // namespace

void check_capabilities(const Scene<2> &scene, const Settings &settings)
{
  check(in_the_plane, scene, settings);
}

void check_capabilities(const Scene<3> &scene, const Settings &settings)
{
  check(in_space, scene, settings);
}
} // namespace softgrain::mpm
