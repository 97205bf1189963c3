// SPDX-License-Identifier: LGPL-2.1-or-later
// What walls in space may be.
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/scene/cell_checks.h>
#include <softgrain/scene/contact_pairs.h>
#include <softgrain/scene/space_checks.h>
#include <softgrain/scene/wall_drive.h>

#include <cmath>
#include <sstream>

namespace softgrain
{
namespace
{
/// Bonded particles have none.
std::string scheme_of(const ParameterSection &parameters)
{
  return value_in(parameters, "", "Model") == "bpm" ? "" : value_in(parameters, "Time", "Scheme");
}

/// A pressure acts on what lies between four walls beside it.
void check_pressed(const Scene<3> &scene,
                   const WallDescription<3> &wall,
                   const std::string &scheme,
                   Mistakes &mistakes)
{
  const std::string section = "'Walls/" + wall.name;
  const bool at_rest = scheme == "quasi_static";
  if (wall.drive_name != "pressure" || !(at_rest || scheme == "moreau_jean"))
  {
    mistakes.add(InputError(
        section + "/Drive' = '" + wall.drive_name +
        "' is not allowed with 'Dimension' = '3': it must be one that says how the wall moves, 'velocity' or "
        "'position'" +
        (scheme.empty() ? "" : ", or with 'Time/Scheme' = 'quasi_static' or 'moreau_jean' also 'pressure'")));
    return;
  }
  if (repeats(wall) && !at_rest)
  {
    mistakes.add(InputError(section +
                            "/Drive' = 'pressure' is not allowed with 'Type' = 'periodic' and "
                            "'Time/Scheme' = '" +
                            scheme + "', where it is not there yet: it must be 'velocity' or 'position'"));
    return;
  }
  unsigned int beside = 0;
  for (const WallDescription<3> &other : scene.walls)
    beside += std::abs(other.normal * wall.normal) < 1e-9;
  if (beside != 4)
    mistakes.add(InputError(section +
                            "/Drive' = 'pressure' needs an area to act on: there must be four walls "
                            "beside it, at right angles to it and to each other, and there are " +
                            std::to_string(beside)));
}

void check_walls(const Scene<3> &scene, const std::string &scheme, Mistakes &mistakes)
{
  for (const WallDescription<3> &wall : scene.walls)
  {
    const std::string section = "'Walls/" + wall.name;
    if (wall.type == WallDescription<3>::Type::material_points || (repeats(wall) && scheme.empty()))
      mistakes.add(InputError(section + "/Type' is not allowed with 'Dimension' = '3'" +
                              (scheme.empty() ? " and 'Model' = 'bpm': it must be 'plane'"
                                              : ": it must be 'plane' or 'periodic'")));
    if (!wall.drive->prescribed())
      check_pressed(scene, wall, scheme, mistakes);
    if (repeats(wall))
      continue;
    // The first body tells enough: often the wall is wrong, and many lie behind it.
    for (const BodyDescription<3> &body : scene.bodies)
    {
      const auto [nearest, farthest] = body.shape->distances_from_plane(wall.point, wall.normal);
      if (nearest < -1e-9 * (farthest - nearest))
      {
        std::ostringstream text;
        text << "'Bodies/" << body.name << "' reaches " << -nearest << " m behind wall '" << wall.name
             << "': it must lie on its inner side at the start";
        mistakes.add(InputError(text.str()));
        break;
      }
    }
  }
}

/// What slides must rub against something.
void check_slides(const Scene<3> &scene, Mistakes &mistakes)
{
  const ContactPairs pairs(scene);
  for (unsigned int w = 0; w < scene.walls.size(); ++w)
  {
    bool rubs = false;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      rubs = rubs || pairs.friction_at_wall(b, w) > 0.;
    if (scene.walls[w].drive->slides() && !repeats(scene.walls[w]) && !scene.bodies.empty() && !rubs)
      mistakes.add(InputError("'Walls/" + scene.walls[w].name +
                              "/Tangential velocity' has no effect without friction: set 'Walls/" +
                              scene.walls[w].name + "/Friction', or leave it out"));
  }
}
} // namespace

std::string value_in(const ParameterSection &parameters, const std::string &section, const std::string &name)
{
  if (section.empty())
  {
    for (const ParameterEntry &entry : parameters.entries)
      if (entry.name == name)
        return entry.value;
    return "";
  }
  for (const ParameterSection &part : parameters.sections)
    if (part.name == section)
      return value_in(part, "", name);
  return "";
}

void check_walls_in_space(const Scene<3> &scene, const ParameterSection &parameters, Mistakes &mistakes)
{
  check_walls(scene, scheme_of(parameters), mistakes);
  mistakes.attempt([&]() { check_slides(scene, mistakes); });
  mistakes.attempt([&]() { check_motion_of_sides(scene.walls); });
}

void check_walls_in_space(const Scene<3> &scene, const ParameterSection &parameters)
{
  Mistakes mistakes;
  check_walls_in_space(scene, parameters, mistakes);
  mistakes.end();
}
} // namespace softgrain
