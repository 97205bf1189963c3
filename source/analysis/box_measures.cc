// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/box_measures.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
std::optional<double>
wall_distance(const std::vector<WallState<2>> &walls, const std::string &from, const std::string &to)
{
  const auto find = [&walls](const std::string &name)
  {
    return std::find_if(walls.begin(), walls.end(),
                        [&name](const WallState<2> &wall) { return wall.name == name; });
  };
  const auto first = find(from), second = find(to);
  if (first == walls.end() || second == walls.end())
    return std::nullopt;
  return (second->point - first->point) * first->normal;
}

std::optional<double> axial_strain(const std::vector<WallState<2>> &start,
                                   const std::vector<WallState<2>> &now)
{
  const auto h0 = wall_distance(start, "bottom", "top"), h = wall_distance(now, "bottom", "top");
  if (!h0 || !h)
    return std::nullopt;
  return std::log(*h0 / *h);
}

std::optional<double> packing_fraction(const std::vector<WallState<2>> &walls, const double solid_area)
{
  const auto height = wall_distance(walls, "bottom", "top"), width = wall_distance(walls, "left", "right");
  if (!height || !width)
    return std::nullopt;
  return solid_area / (*height * *width);
}
} // namespace softgrain
