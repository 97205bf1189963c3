// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/scene/cell_checks.h>
#include <softgrain/scene/loads.h>
#include <softgrain/scene/wall_drive.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain
{
namespace
{
constexpr double along = 1. - 1e-12; ///< least cosine of normals that are parallel

std::string number(const double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

template <int dim>
bool goes_along(const WallDescription<dim> &wall)
{
  return wall.drive->slides() || wall.drive->shears();
}
} // namespace

template <int dim>
std::string tangential_key(const WallDescription<dim> &wall)
{
  return wall.drive->shears() ? "Shear stress" : "Tangential velocity";
}

template <int dim>
PeriodicCell<dim> cell_of(const Scene<dim> &scene)
{
  std::vector<CellSide<dim>> sides;
  for (const WallDescription<dim> &wall : scene.walls)
    if (repeats(wall))
      sides.push_back({wall.point, wall.normal});
  return make_cell(sides, 0.);
}

template <int dim>
void check_sides(const std::vector<WallDescription<dim>> &walls)
{
  for (const WallDescription<dim> &side : walls)
  {
    if (!repeats(side))
      continue;
    const std::string is = "'Walls/" + side.name + "/Type' = 'periodic' ";
    if (std::abs(side.normal[axis_of(side.normal)]) < along)
      throw InputError(is + "needs a 'Normal' along x" + (dim == 3 ? ", y or z" : " or y"));
    unsigned int facing = 0;
    for (const WallDescription<dim> &other : walls)
    {
      const double cosine = side.normal * other.normal;
      facing += repeats(other) && cosine < -along;
      if (&other != &side && repeats(other) && cosine > along)
        throw InputError(is + "is not allowed beside the periodic wall '" + other.name +
                         "', which has the same normal");
      if (!repeats(other) && std::abs(cosine) > 1e-12)
        throw InputError(
            is + "is not allowed with the wall '" + other.name +
            "', which bodies do not go through: in a direction that repeats there are no others");
      if (other.type == WallDescription<dim>::Type::material_points)
        throw InputError(is + "is not allowed with 'Walls/" + other.name +
                         "/Type' = 'material points': choose 'plane'");
    }
    if (facing != 1)
      throw InputError(is + "needs one wall of this type that faces it");
    if (side.friction > 0.)
      throw InputError("'Walls/" + side.name +
                       "/Friction' has no effect with 'Type' = 'periodic': leave it at 0");
  }
}

template <int dim>
void check_cell(const Scene<dim> &scene)
{
  for (const WallDescription<dim> &side : scene.walls)
    for (const WallDescription<dim> &other : scene.walls)
    {
      if (!repeats(side) || !repeats(other) || side.normal * other.normal > -along)
        continue;
      if (!scene.obstacles.empty())
        throw InputError("'Obstacles/" + scene.obstacles.front().name +
                         "' is not allowed in a cell that repeats: nothing repeats an obstacle");
      const double length = (other.point - side.point) * side.normal;
      for (const BodyDescription<dim> &body : scene.bodies)
      {
        const auto extent = body.shape->distances_from_plane(side.point, side.normal);
        if (extent.second - extent.first > 0.9 * length)
          throw InputError("the cell between the walls '" + other.name + "' and '" + side.name + "' is " +
                           number(length) + " m wide, too narrow for body '" + body.name +
                           "', which would meet itself");
        if (body.driven)
          throw InputError("'Bodies/" + body.name +
                           "/Driven' = 'true' is not allowed in a cell that repeats");
      }
    }
}

template <int dim>
void check_loads_in_cell(const Scene<dim> &scene)
{
  for (const auto &load : scene.loads)
    if (load->sees_velocity() && std::any_of(scene.walls.begin(), scene.walls.end(), repeats<dim>))
      throw InputError("'Loads/" + load->key() +
                       "' is not allowed in a cell that repeats, where bodies have no velocity of their own");
}

template <int dim>
void check_motion_of_sides(const std::vector<WallDescription<dim>> &walls)
{
  const bool along_x = std::any_of(walls.begin(), walls.end(),
                                   [](const WallDescription<dim> &wall)
                                   { return repeats(wall) && axis_of(wall.normal) == 0; });
  for (const WallDescription<dim> &wall : walls)
  {
    if (!repeats(wall))
      continue;
    const std::string at = "'Walls/" + wall.name + "/";
    if (goes_along(wall) && !(axis_of(wall.normal) == PeriodicCell<dim>::up && along_x))
      throw InputError(at + tangential_key(wall) +
                       "' is not allowed with 'Type' = 'periodic' but at top and bottom of a "
                       "cell that repeats along x and " +
                       (dim == 3 ? "z" : "y"));
    for (const WallDescription<dim> &other : walls)
    {
      if (&wall == &other || !repeats(other))
        continue;
      if (wall.drive->shears() && goes_along(other))
        throw InputError(at + "Shear stress' is not allowed where 'Walls/" + other.name + "/" +
                         tangential_key(other) + "' moves the side that faces it");
      if (!wall.drive->prescribed() && !other.drive->prescribed() &&
          axis_of(wall.normal) == axis_of(other.normal))
        throw InputError(at + "Drive' = '" + wall.drive_name + "' is not allowed where 'Walls/" + other.name +
                         "/Drive' = '" + other.drive_name +
                         "' moves the side that faces it: of two periodic walls one may be free to move");
    }
  }
}

template std::string tangential_key(const WallDescription<2> &);
template PeriodicCell<2> cell_of(const Scene<2> &);
template void check_sides(const std::vector<WallDescription<2>> &);
template void check_cell(const Scene<2> &);
template void check_loads_in_cell(const Scene<2> &);
template void check_motion_of_sides(const std::vector<WallDescription<2>> &);
template std::string tangential_key(const WallDescription<3> &);
template PeriodicCell<3> cell_of(const Scene<3> &);
template void check_sides(const std::vector<WallDescription<3>> &);
template void check_cell(const Scene<3> &);
template void check_loads_in_cell(const Scene<3> &);
template void check_motion_of_sides(const std::vector<WallDescription<3>> &);
} // namespace softgrain
