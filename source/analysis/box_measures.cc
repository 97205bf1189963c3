// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/box_measures.h>
#include <softgrain/geometry/box.h>

#include <cmath>

namespace softgrain
{
template <int dim>
std::optional<double> axial_strain(const std::vector<WallState<dim>> &start,
                                   const std::vector<WallState<dim>> &now)
{
  const auto h0 = wall_distance(start, "bottom", "top"), h = wall_distance(now, "bottom", "top");
  if (!h0 || !h)
    return std::nullopt;
  return std::log(*h0 / *h);
}

std::optional<BoxStrain> box_strain(const std::vector<WallState<2>> &start,
                                    const std::vector<WallState<2>> &now)
{
  const std::optional<Box<2>> before = box_of(start), after = box_of(now);
  if (!before || !after)
    return std::nullopt;
  return BoxStrain{std::log(before->height() / after->height()), std::log(before->width() / after->width())};
}

std::optional<BoxStress> box_stress(const std::vector<WallState<2>> &walls)
{
  const std::optional<Box<2>> box = box_of(walls);
  if (!box)
    return std::nullopt;
  const auto mean = [&walls](const std::string &a, const std::string &b)
  { return 0.5 * (find_wall(walls, a)->normal_force + find_wall(walls, b)->normal_force); };
  return BoxStress{mean("bottom", "top") / box->width(), mean("left", "right") / box->height()};
}

template <int dim>
std::optional<double> packing_fraction(const std::vector<WallState<dim>> &walls, const double solid_area)
{
  const std::optional<Box<dim>> box = box_of(walls);
  if (!box)
    return std::nullopt;
  return solid_area / box->volume();
}

template std::optional<double> axial_strain<2>(const std::vector<WallState<2>> &,
                                               const std::vector<WallState<2>> &);
template std::optional<double> axial_strain<3>(const std::vector<WallState<3>> &,
                                               const std::vector<WallState<3>> &);
template std::optional<double> packing_fraction<2>(const std::vector<WallState<2>> &, double);
template std::optional<double> packing_fraction<3>(const std::vector<WallState<3>> &, double);
} // namespace softgrain
