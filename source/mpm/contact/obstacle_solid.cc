// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/obstacle_solid.h>

#include <algorithm>
#include <vector>

namespace softgrain::mpm
{
namespace
{
using Vector = dealii::Tensor<1, 3>;

constexpr double facing = 0.5;           ///< least cosine between a normal and what it faces
constexpr double steepest = 2.5;         ///< height by which a surface may rise, over the way across a ray
constexpr double above = 0.02;           ///< from where one looks for a surface, over its thickness
constexpr unsigned int times_higher = 3; ///< that one looks from half a thickness higher

/// Of the box around it, as drawn.
std::array<dealii::Point<3>, 8> corners_of(const RigidSurface &surface)
{
  const auto [lower, upper] = surface.bounding_box();
  std::array<dealii::Point<3>, 8> corners;
  for (unsigned int c = 0; c < 8; ++c)
    for (unsigned int d = 0; d < 3; ++d)
      corners[c][d] = (c >> d) & 1 ? upper[d] : lower[d];
  return corners;
}

void turn(const Pose<3> &pose, RaySide<3> &side)
{
  side.normal = pose.turned(side.normal, pose.angle);
  for (Vector &way : side.way)
    way = pose.turned(way, pose.angle);
  dealii::Tensor<2, 3> rotation; // by columns
  for (unsigned int d = 0; d < 3; ++d)
  {
    Vector unit;
    unit[d] = 1.;
    unit = pose.turned(unit, pose.angle);
    for (unsigned int e = 0; e < 3; ++e)
      rotation[e][d] = unit[e];
  }
  side.sliding_twice = rotation * side.sliding_twice * transpose(rotation);
}
} // namespace

ObstacleSolid::ObstacleSolid(const Obstacle<3> &obstacle, const ObstacleMotion<3> &way)
    : RigidRays<3>(obstacle.description.friction), shape(obstacle.description.surface), way(way)
{
}

double ObstacleSolid::largest_way() const
{
  double largest = 0.;
  if (way.dt > 0.)
    for (const dealii::Point<3> &corner : corners_of(*shape))
      largest = std::max(largest, way.way_of(corner).norm());
  return largest;
}

std::pair<dealii::Point<3>, dealii::Point<3>> ObstacleSolid::box() const
{
  const std::array<dealii::Point<3>, 8> corners = corners_of(*shape);
  std::pair<dealii::Point<3>, dealii::Point<3>> box;
  box.first = box.second = way.start.placed(corners[0]);
  for (const dealii::Point<3> &corner : corners)
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double x = way.start.placed(corner)[d];
      box.first[d] = std::min(box.first[d], x);
      box.second[d] = std::max(box.second[d], x);
    }
  return box;
}

SampledSurface<3> ObstacleSolid::facing(const SampledSurface<3> &body,
                                        const dealii::BoundingBox<3> & /*near*/,
                                        const double reach) const
{
  const RigidSurface &surface = *shape;
  const Pose<3> &pose = way.start;
  const double within = surface.thickness() + reach + body.spacing;
  SampledSurface<3> result;
  result.spacing = body.spacing;
  const unsigned int none = body.samples.size();
  std::vector<unsigned int> number(body.samples.size(), none);
  for (unsigned int i = 0; i < body.samples.size(); ++i)
  {
    const SampledSurface<3>::Sample &of_body = body.samples[i];
    const auto place = surface.nearest(pose.drawn(of_body.position), within);
    if (!place)
      continue;
    SampledSurface<3>::Sample sample;
    sample.place = *place;
    sample.position = pose.placed(place->position);
    sample.normal = pose.turned(place->normal, pose.angle);
    if (!(sample.normal * of_body.normal < -mpm::facing))
      continue;
    number[i] = result.samples.size();
    result.samples.push_back(sample);
  }
  for (const auto &[i, j] : body.neighbours)
    if (number[i] != none && number[j] != none)
      result.neighbours.emplace_back(number[i], number[j]);
  return result;
}

RaySide<3> ObstacleSolid::meet(const Ray<3> &ray, const double share, const SurfacePlace<3> &guess) const
{
  const RigidSurface &surface = *shape;
  const Pose<3> pose = way.at(share);
  Ray<3> drawn = ray;
  drawn.origin = pose.drawn(ray.origin);
  drawn.direction = pose.turned(ray.direction, -pose.angle);
  for (Vector &across : drawn.across)
    across = pose.turned(across, -pose.angle);
  const dealii::Point<3> foot =
      drawn.origin + drawn.offset[0] * drawn.across[0] + drawn.offset[1] * drawn.across[1];
  const double height = (guess.position - drawn.origin) * drawn.direction,
               beside = (guess.position - foot - height * drawn.direction).norm();
  // From above the place that is known, but no further than out of the sheet: beyond lies what else it has.
  double lift = steepest * beside + above * surface.thickness();
  const auto start = [&]() { return foot + (height + lift) * drawn.direction; };
  for (unsigned int n = 0; n < times_higher && surface.height(start(), surface.thickness()) < 0.; ++n)
    lift += 0.5 * surface.thickness();
  const auto place = surface.first_met(start(), -drawn.direction, 2. * lift + surface.thickness());
  if (!place)
    return {};
  RaySide<3> side = side_at(drawn, *place);
  turn(pose, side);
  return side;
}
} // namespace softgrain::mpm
