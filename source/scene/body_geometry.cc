// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/scene/body_geometry.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain
{
namespace
{
bool disks_overlap(const BodyDescription<2> &a, const BodyDescription<2> &b, const double tolerance)
{
  const double distance = a.center.distance(b.center);
  return distance < a.radius + b.radius - tolerance && distance + b.radius > a.inner_radius + tolerance &&
         distance + a.radius > b.inner_radius + tolerance;
}

bool disk_overlaps_polygon(const BodyDescription<2> &disk, const Polygon &polygon, const double tolerance)
{
  const bool near = distance_to_boundary(disk.center, polygon) < disk.radius - tolerance;
  if (!near && !is_inside(disk.center, polygon))
    return false;
  return std::any_of(polygon.begin(), polygon.end(),
                     [&](const dealii::Point<2> &p)
                     { return p.distance(disk.center) > disk.inner_radius + tolerance; });
}
} // namespace

Polygon corners(const BodyDescription<2> &body)
{
  Polygon result;
  if (body.shape == BodyShape::polygon)
  {
    result = body.vertices;
    if (signed_area(result) < 0)
      std::reverse(result.begin(), result.end());
  }
  else if (body.shape == BodyShape::rectangle)
    for (const auto &[sx, sy] : {std::pair(-.5, -.5), {.5, -.5}, {.5, .5}, {-.5, .5}})
    {
      const double x = sx * body.size[0], y = sy * body.size[1];
      const double c = std::cos(body.angle), s = std::sin(body.angle);
      result.emplace_back(body.center[0] + c * x - s * y, body.center[1] + s * x + c * y);
    }
  return result;
}

std::vector<Polygon> make_outline(const BodyDescription<2> &body, const double spacing)
{
  switch (body.shape)
  {
  case BodyShape::disk:
  {
    std::vector<Polygon> outline = {circle(body.center, body.radius, spacing, false)};
    if (body.inner_radius > 0.)
      outline.push_back(circle(body.center, body.inner_radius, spacing, true));
    return outline;
  }
  case BodyShape::rectangle:
  {
    const dealii::Tensor<1, 2> e({std::cos(body.angle), std::sin(body.angle)}), f({-e[1], e[0]});
    const dealii::Tensor<1, 2> a = 0.5 * body.size[0] * e, b = 0.5 * body.size[1] * f;
    return {subdivide({body.center - a - b, body.center + a - b, body.center + a + b, body.center - a + b},
                      spacing)};
  }
  case BodyShape::polygon:
  {
    Polygon corners = body.vertices;
    if (signed_area(corners) < 0.)
      std::reverse(corners.begin(), corners.end());
    return {subdivide(corners, spacing)};
  }
  }
  return {};
}
double area(const BodyDescription<2> &body)
{
  if (body.shape == BodyShape::disk)
    return dealii::numbers::PI * (body.radius * body.radius - body.inner_radius * body.inner_radius);
  return signed_area(corners(body));
}

std::pair<dealii::Point<2>, dealii::Point<2>> bounding_box(const BodyDescription<2> &body)
{
  const dealii::Point<2> origin;
  const auto x = distances_from_plane(body, origin, dealii::Point<2>(1, 0));
  const auto y = distances_from_plane(body, origin, dealii::Point<2>(0, 1));
  return {{x.first, y.first}, {x.second, y.second}};
}

std::pair<double, double> distances_from_plane(const BodyDescription<2> &body,
                                               const dealii::Point<2> &point,
                                               const dealii::Tensor<1, 2> &normal)
{
  if (body.shape == BodyShape::disk)
  {
    const double center = (body.center - point) * normal;
    return {center - body.radius, center + body.radius};
  }
  std::pair<double, double> range(std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest());
  for (const dealii::Point<2> &corner : corners(body))
  {
    const double distance = (corner - point) * normal;
    range = {std::min(range.first, distance), std::max(range.second, distance)};
  }
  return range;
}

bool overlap(const BodyDescription<2> &a, const BodyDescription<2> &b, const double tolerance)
{
  const auto box_a = bounding_box(a), box_b = bounding_box(b);
  for (unsigned int d = 0; d < 2; ++d)
    if (box_a.second[d] < box_b.first[d] + tolerance || box_b.second[d] < box_a.first[d] + tolerance)
      return false;
  if (a.shape == BodyShape::disk && b.shape == BodyShape::disk)
    return disks_overlap(a, b, tolerance);
  if (a.shape == BodyShape::disk)
    return disk_overlaps_polygon(a, corners(b), tolerance);
  if (b.shape == BodyShape::disk)
    return disk_overlaps_polygon(b, corners(a), tolerance);
  return polygons_overlap(corners(a), corners(b), tolerance);
}

double depth_inside(const BodyDescription<2> &body, const dealii::Point<2> &p)
{
  if (body.shape == BodyShape::disk)
  {
    const double r = p.distance(body.center);
    return body.inner_radius > 0. ? std::min(body.radius - r, r - body.inner_radius) : body.radius - r;
  }
  const Polygon polygon = corners(body);
  return (is_inside(p, polygon) ? 1. : -1.) * distance_to_boundary(p, polygon);
}
} // namespace softgrain
