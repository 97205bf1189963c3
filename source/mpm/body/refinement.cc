// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/mpm/body/refinement.h>
#include <softgrain/scene/obstacle_parameters.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace softgrain::mpm
{
namespace
{
using Place = dealii::Point<2>;

/// An upright box, a point being the smallest.
struct Area
{
  Place lower, upper;

  Place center() const { return lower + 0.5 * (upper - lower); }
  double distance(const Place &x) const
  {
    dealii::Tensor<1, 2> outside;
    for (unsigned int d = 0; d < 2; ++d)
      outside[d] = std::max({lower[d] - x[d], x[d] - upper[d], 0.});
    return outside.norm();
  }
};

/// Distance of an area from something that a body may touch [m].
using Distance = std::function<double(const Area &)>;

/// Places on the outlines of all bodies.
std::vector<std::vector<Place>> outlines_of(const Scene<2> &scene, const double spacing)
{
  std::vector<std::vector<Place>> outlines(scene.bodies.size());
  for (unsigned int b = 0; b < scene.bodies.size(); ++b)
    for (const Polygon &loop : scene.bodies[b].shape->outline(spacing))
      outlines[b].insert(outlines[b].end(), loop.begin(), loop.end());
  return outlines;
}

Distance distance_of_wall(const WallDescription<2> &wall)
{
  return [&wall](const Area &area)
  {
    double half_width = 0.;
    for (unsigned int d = 0; d < 2; ++d)
      half_width += 0.5 * (area.upper[d] - area.lower[d]) * std::abs(wall.normal[d]);
    return (area.center() - wall.point) * wall.normal - half_width;
  };
}

Distance distance_of_obstacle(const ObstacleDescription<2> &obstacle)
{
  const Pose<2> pose = pose_of(obstacle, 0.);
  return [&obstacle, pose](const Area &area)
  {
    const Place center = pose.drawn(area.center());
    double least = std::numeric_limits<double>::max();
    for (const Curve &piece : obstacle.pieces)
      least = std::min(least, center.distance(piece.foot(center).place));
    return least - 0.5 * area.lower.distance(area.upper);
  };
}

Distance distance_of_outline(std::vector<Place> outline)
{
  return [outline = std::move(outline)](const Area &area)
  {
    double least = std::numeric_limits<double>::max();
    for (const Place &x : outline)
      least = std::min(least, area.distance(x));
    return least;
  };
}

/// What a body may touch: distances beyond that of the nearest place of its outline.
std::vector<Distance> neighbours_of(const Scene<2> &scene,
                                    const unsigned int body,
                                    const std::vector<std::vector<Place>> &outlines,
                                    const double reach)
{
  std::vector<Distance> list;
  const auto add = [&](const Distance &distance)
  {
    double gap = std::numeric_limits<double>::max();
    for (const Place &x : outlines[body])
      gap = std::min(gap, distance({x, x}));
    if (gap <= reach)
      list.push_back([distance, gap](const Area &area) { return distance(area) - gap; });
  };
  for (const WallDescription<2> &wall : scene.walls)
    add(distance_of_wall(wall));
  for (const ObstacleDescription<2> &obstacle : scene.obstacles)
    add(distance_of_obstacle(obstacle));
  const auto [lower, upper] = scene.bodies[body].shape->bounding_box();
  for (unsigned int other = 0; other < scene.bodies.size(); ++other)
  {
    const auto [low, high] = scene.bodies[other].shape->bounding_box();
    const bool near = low[0] < upper[0] + reach && high[0] > lower[0] - reach && low[1] < upper[1] + reach &&
                      high[1] > lower[1] - reach;
    if (other != body && near)
      add(distance_of_outline(outlines[other]));
  }
  return list;
}
} // namespace

void check_refinement(const Scene<2> &scene, const Settings &settings)
{
  const std::string name =
      "'Mesh/Refine near contact' = '" + std::to_string(settings.refine_near_contact) + "'";
  for (const WallDescription<2> &wall : scene.walls)
    if (wall.type == WallDescription<2>::Type::periodic)
      throw InputError(name + " is not allowed with 'Walls/" + wall.name +
                       "/Type' = 'periodic': images of bodies would not count; leave it at 0");
  const auto outlines = outlines_of(scene, settings.finest_cell());
  for (unsigned int b = 0; b < scene.bodies.size(); ++b)
    if (!neighbours_of(scene, b, outlines, settings.cell_size).empty())
      return;
  throw InputError(name +
                   " has no effect: at the start nothing that a body may touch is within one 'Mesh/Cell "
                   "size' of it; leave it at 0");
}

LevelsOfScene refine_near_contact(const Scene<2> &scene, const Settings &settings, const Lattice<2> &lattice)
{
  constexpr double wide = 2.; // cells of the next size
  // Where walls and outlines lie on lines of the grid, cells are just so far away: rounding must not decide.
  const double rounding = 1e-6 * lattice.cell_size();
  LevelsOfScene levels(scene.bodies.size());
  if (settings.refine_near_contact == 0)
    return levels;
  check_refinement(scene, settings);
  const auto outlines = outlines_of(scene, lattice.cell_size());
  for (unsigned int b = 0; b < scene.bodies.size(); ++b)
  {
    const std::vector<Distance> neighbours = neighbours_of(scene, b, outlines, settings.cell_size);
    const auto cut = [&](const Place &lower, const Place &upper, const unsigned int level)
    {
      const double reach = wide * std::ldexp(lattice.cell_size(), level - 1);
      return std::any_of(neighbours.begin(), neighbours.end(),
                         [&](const Distance &distance) {
                           return distance({lower, upper}) <= reach + rounding;
                         });
    };
    const auto [lower, upper] = scene.bodies[b].shape->bounding_box();
    levels[b] = std::make_shared<CellLevels<2>>(lattice, lower, upper, settings.refine_near_contact, cut);
  }
  return levels;
}
} // namespace softgrain::mpm
