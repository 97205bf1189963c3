// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/polygon.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain
{
namespace
{
/// Keeps the part of @p polygon where sign * (x_d - limit) >= 0.
Polygon
clip_to_half_space(const Polygon &polygon, const unsigned int d, const double limit, const double sign)
{
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const dealii::Point<2> &a = polygon[i];
    const dealii::Point<2> &b = polygon[(i + 1) % polygon.size()];
    const double sa = sign * (a[d] - limit), sb = sign * (b[d] - limit);
    if (sa >= 0.)
      result.push_back(a);
    if ((sa > 0. && sb < 0.) || (sa < 0. && sb > 0.))
    {
      dealii::Point<2> cut = a + (sa / (sa - sb)) * (b - a);
      cut[d] = limit;
      result.push_back(cut);
    }
  }
  return result;
}

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
} // namespace

double signed_area(const Polygon &polygon)
{
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    // Relative to the first vertex, so that small polygons far from the origin keep their digits.
    const dealii::Tensor<1, 2> a = polygon[i] - polygon[0];
    const dealii::Tensor<1, 2> b = polygon[(i + 1) % polygon.size()] - polygon[0];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

std::pair<double, dealii::Point<2>> area_and_centroid(const Polygon &polygon)
{
  if (polygon.empty())
    return {0., dealii::Point<2>()};
  double twice = 0;
  dealii::Tensor<1, 2> moment, mean;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const dealii::Tensor<1, 2> a = polygon[i] - polygon[0];
    const dealii::Tensor<1, 2> b = polygon[(i + 1) % polygon.size()] - polygon[0];
    const double cross = a[0] * b[1] - a[1] * b[0];
    twice += cross;
    moment += cross * (a + b) / 3.;
    mean += a / static_cast<double>(polygon.size());
  }
  if (std::abs(twice) < 1e-300)
    return {0., polygon[0] + mean};
  return {0.5 * twice, polygon[0] + moment / twice};
}

Polygon clip_to_box(const Polygon &polygon, const dealii::Point<2> &lower, const dealii::Point<2> &upper)
{
  Polygon result = polygon;
  for (unsigned int d = 0; d < 2; ++d)
  {
    result = clip_to_half_space(result, d, lower[d], 1.);
    result = clip_to_half_space(result, d, upper[d], -1.);
  }
  return result;
}

Polygon
circle(const dealii::Point<2> &center, const double radius, const double spacing, const bool clockwise)
{
  // Whole quarters: the vertices are their own image in a mirror and when turned by 90 degrees.
  const unsigned int n = 4 * std::max(3, static_cast<int>(std::ceil(0.5 * M_PI * radius / spacing)));
  Polygon polygon(n);
  for (unsigned int i = 0; i < n; ++i)
  {
    const double angle = (clockwise ? -1. : 1.) * 2. * M_PI * i / n;
    polygon[i] = center + radius * dealii::Tensor<1, 2>({std::cos(angle), std::sin(angle)});
  }
  return polygon;
}

Polygon subdivide(const Polygon &corners, const double spacing)
{
  Polygon polygon;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const dealii::Tensor<1, 2> edge = corners[(i + 1) % corners.size()] - corners[i];
    const unsigned int n = std::max(1, static_cast<int>(std::ceil(edge.norm() / spacing - 1e-9)));
    for (unsigned int k = 0; k < n; ++k)
      polygon.push_back(corners[i] + (static_cast<double>(k) / n) * edge);
  }
  return polygon;
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

bool polygons_overlap(const Polygon &a, const Polygon &b, const double tolerance)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (edges_cross(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()], tolerance))
        return true;
  return has_point_inside(a, b, tolerance) || has_point_inside(b, a, tolerance);
}
} // namespace softgrain
