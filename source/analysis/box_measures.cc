// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/box_measures.h>
#include <softgrain/geometry/box.h>

#include <cmath>

namespace softgrain
{
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
  const std::optional<Box> box = box_of(walls);
  if (!box)
    return std::nullopt;
  return solid_area / box->area();
}
} // namespace softgrain
