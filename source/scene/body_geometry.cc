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
double cross(const dealii::Tensor<1, 2> &a, const dealii::Tensor<1, 2> &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

double distance_to_edge(const dealii::Point<2> &p, const dealii::Point<2> &a, const dealii::Point<2> &b)
{
  const dealii::Tensor<1, 2> edge = b - a;
  const double length_squared = edge.norm_square();
  const double s = length_squared > 0 ? std::clamp(((p - a) * edge) / length_squared, 0., 1.) : 0.;
  return p.distance(a + s * edge);
}

double distance_to_boundary(const dealii::Point<2> &p, const Polygon &polygon)
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    least = std::min(least, distance_to_edge(p, polygon[i], polygon[(i + 1) % polygon.size()]));
  return least;
}

bool is_inside(const dealii::Point<2> &p, const Polygon &polygon)
{
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
  {
    const auto &a = polygon[i], &b = polygon[j];
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]))
      inside = !inside;
  }
  return inside;
}

/// Whether the edges cross with every end point farther than @p tolerance from the other edge's line.
bool edges_cross(const dealii::Point<2> &a,
                 const dealii::Point<2> &b,
                 const dealii::Point<2> &c,
                 const dealii::Point<2> &d,
                 const double tolerance)
{
  const auto apart = [tolerance](const dealii::Point<2> &p, const dealii::Point<2> &q,
                                 const dealii::Point<2> &r, const dealii::Point<2> &s)
  {
    const double length = p.distance(q);
    const double first = cross(q - p, r - p) / length, second = cross(q - p, s - p) / length;
    return (first > tolerance && second < -tolerance) || (first < -tolerance && second > tolerance);
  };
  return apart(a, b, c, d) && apart(c, d, a, b);
}

/// Whether @p p lies in the polygon, deeper than @p tolerance.
bool is_deep_inside(const dealii::Point<2> &p, const Polygon &polygon, const double tolerance)
{
  return is_inside(p, polygon) && distance_to_boundary(p, polygon) > tolerance;
}

/// Corners, and points just inside of every edge: so that a polygon laid exactly on another one is noticed.
bool has_point_inside(const Polygon &a, const Polygon &b, const double tolerance)
{
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const auto &p = a[i], &q = a[(i + 1) % a.size()];
    const dealii::Tensor<1, 2> edge = q - p;
    dealii::Tensor<1, 2> inward;
    inward[0] = -edge[1];
    inward[1] = edge[0];
    const dealii::Point<2> within = p + 0.5 * edge + (4 * tolerance / edge.norm()) * inward;
    if (is_deep_inside(p, b, tolerance) || is_deep_inside(within, b, tolerance))
      return true;
  }
  return false;
}

bool polygons_overlap(const Polygon &a, const Polygon &b, const double tolerance)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (edges_cross(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()], tolerance))
        return true;
  return has_point_inside(a, b, tolerance) || has_point_inside(b, a, tolerance);
}

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

bool crosses_itself(const Polygon &polygon)
{
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i &&
          edges_cross(polygon[i], polygon[(i + 1) % n], polygon[j], polygon[(j + 1) % n], 0.))
        return true;
  return false;
}

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
