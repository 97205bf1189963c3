// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/loaded_walls.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double along = 1. - 1e-9; ///< least cosine of normals that are parallel

/// Distance of the two walls that look at each other along @p axis; 0 if there are none.
double distance_along(const std::vector<WallMotion<3>> &walls, const dealii::Tensor<1, 3> &axis)
{
  const auto looking = [&](const double sign)
  {
    return std::find_if(walls.begin(), walls.end(),
                        [&](const WallMotion<3> &wall) { return sign * (wall.normal * axis) > along; });
  };
  const auto one = looking(1.), other = looking(-1.);
  return one == walls.end() || other == walls.end() ? 0. : (other->point - one->point) * axis;
}
} // namespace

std::optional<CellMotion<3>> SpaceMotion::cell() const
{
  std::vector<CellSide<3>> sides;
  for (const WallMotion<3> &wall : walls)
    if (!wall.plane)
      sides.push_back({wall.point, wall.normal});
  if (sides.empty())
    return std::nullopt;
  CellMotion<3> motion;
  motion.cell = make_cell(sides, cell_offset);
  for (const WallMotion<3> &wall : walls)
    if (!wall.plane)
      motion.add_side(wall.normal, wall.mean_velocity());
  return motion;
}

SpaceMotion SpaceMotion::at_end(const double dt) const
{
  SpaceMotion end = *this;
  if (const auto repeats = cell())
    end.cell_offset = repeats->offset_after(dt);
  for (WallMotion<3> &wall : end.walls)
  {
    wall.point += dt * wall.velocity * wall.normal;
    wall.velocity = wall.slide = 0.;
  }
  for (ObstacleMotion<3> &obstacle : end.obstacles)
    obstacle = obstacle.at_end();
  return end;
}

double pressed_area(const std::vector<WallMotion<3>> &walls, const std::size_t w)
{
  for (const WallMotion<3> &beside : walls)
    if (std::abs(beside.normal * walls[w].normal) < 1. - along)
      return distance_along(walls, beside.normal) *
             distance_along(walls, dealii::cross_product_3d(walls[w].normal, beside.normal));
  return 0.;
}

std::vector<WallMotion<3>> walls_now(const SpaceMotion &motion, const std::vector<LoadedWall> &loaded)
{
  std::vector<WallMotion<3>> walls = motion.walls;
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (motion.pressure[w])
      walls[w].point += loaded[w].way * walls[w].normal;
  return walls;
}

WallImbalance least_balanced_wall(const SpaceMotion &motion,
                                  const std::vector<LoadedWall> &loaded,
                                  const std::vector<dealii::Tensor<1, 3>> &force,
                                  const double floor)
{
  WallImbalance worst;
  const std::vector<WallMotion<3>> walls = walls_now(motion, loaded);
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (motion.pressure[w])
      worst.compare(w, false, force[w] * walls[w].normal, *motion.pressure[w] * pressed_area(walls, w),
                    floor);
  return worst;
}
} // namespace softgrain::mpm
