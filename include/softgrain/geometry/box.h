// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_box_h
#define softgrain_geometry_box_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace softgrain
{
/// The wall of this name, or null. A wall is anything with a name, a point of its plane and a unit normal
/// into the domain.
template <typename Wall>
const Wall *find_wall(const std::vector<Wall> &walls, const std::string &name)
{
  const auto found =
      std::find_if(walls.begin(), walls.end(), [&name](const Wall &wall) { return wall.name == name; });
  return found == walls.end() ? nullptr : &*found;
}

/// Distance of two walls along the normal of the first, or nothing when one is missing [m].
template <typename Wall>
std::optional<double>
wall_distance(const std::vector<Wall> &walls, const std::string &from, const std::string &to)
{
  const Wall *const first = find_wall(walls, from), *const second = find_wall(walls, to);
  if (first == nullptr || second == nullptr)
    return std::nullopt;
  return (second->point - first->point) * first->normal;
}

/// The rectangle between the walls bottom, top, left and right.
struct Box
{
  double width = 0;  ///< [m]
  double height = 0; ///< [m]

  double area() const { return width * height; } ///< [m^2]
};

/// The box of @p walls; nothing unless bottom, top, left and right are there.
template <typename Wall>
std::optional<Box> box_of(const std::vector<Wall> &walls)
{
  const auto height = wall_distance(walls, "bottom", "top"), width = wall_distance(walls, "left", "right");
  if (!height || !width)
    return std::nullopt;
  return Box{*width, *height};
}

/// Length of wall @p w (2D) between the two walls that stand beside it at right angles; 0 without them [m].
template <typename Wall>
double length_between_neighbours_2d(const std::vector<Wall> &walls, const std::size_t w)
{
  const dealii::Tensor<1, 2> tangent({-walls[w].normal[1], walls[w].normal[0]});
  std::optional<double> low, high;
  for (const Wall &other : walls)
  {
    const double along = other.normal * tangent;
    if (std::abs(std::abs(along) - 1.) <= 1e-12)
      (along > 0. ? low : high) = other.point * tangent;
  }
  return low && high ? *high - *low : 0.;
}
} // namespace softgrain

#endif
