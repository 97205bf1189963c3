// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_box_h
#define softgrain_geometry_box_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
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

/// The box between the walls left and right, bottom and top; in space front and back are beside these.
template <int dim>
struct Box
{
  /// The box has two walls for each edge: `bottom` and `top` look along the last axis.
  static constexpr std::array<const char *, 2 *dim> sides = []() constexpr
  {
    if constexpr (dim == 2)
      return std::array<const char *, 4>{{"left", "right", "bottom", "top"}};
    else
      return std::array<const char *, 6>{{"left", "right", "front", "back", "bottom", "top"}};
  }
  ();

  std::array<double, dim> edge{}; ///< along x, y and z [m]

  double width() const { return edge[0]; }        ///< [m]
  double height() const { return edge[dim - 1]; } ///< between bottom and top [m]

  /// [m^dim]
  double volume() const
  {
    double product = edge[0];
    for (int d = 1; d < dim; ++d)
      product *= edge[d];
    return product;
  }
};

/// The box of @p walls; nothing unless all its sides are there.
template <typename Wall>
auto box_of(const std::vector<Wall> &walls)
{
  constexpr int dim = decltype(Wall::normal)::dimension;
  std::optional<Box<dim>> box{Box<dim>{}};
  for (int d = 0; d < dim && box; ++d)
    if (const auto edge = wall_distance(walls, Box<dim>::sides[2 * d], Box<dim>::sides[2 * d + 1]))
      box->edge[d] = *edge;
    else
      box.reset();
  return box;
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
