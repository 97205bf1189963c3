// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/convex_hull.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace softgrain
{
namespace
{
using Point = dealii::Point<3>;
using Vector = dealii::Tensor<1, 3>;
using dealii::numbers::PI;

constexpr double same = 1e-9; ///< over the greatest distance of two points

Vector unit(const Vector &v)
{
  return v / v.norm();
}

/// Points that differ, and the greatest distance of two.
std::pair<std::vector<Point>, double> different(const std::vector<Point> &points)
{
  double size = 0.;
  for (const Point &a : points)
    for (const Point &b : points)
      size = std::max(size, a.distance(b));
  std::vector<Point> kept;
  for (const Point &a : points)
    if (std::none_of(kept.begin(), kept.end(), [&](const Point &b) { return a.distance(b) <= same * size; }))
      kept.push_back(a);
  return {kept, size};
}

/// The corners of the polygon around some points of a plane, counter-clockwise about its normal. Each next
/// one has all others to its left, and is the farthest of those on one line.
std::vector<unsigned int> polygon_around(const std::vector<Point> &points,
                                         const std::vector<unsigned int> &some,
                                         const Vector &normal,
                                         const double tolerance)
{
  const unsigned int lowest = *std::min_element(some.begin(), some.end(),
                                                [&](const unsigned int i, const unsigned int j)
                                                {
                                                  for (unsigned int d = 0; d < 3; ++d)
                                                    if (std::abs(points[i][d] - points[j][d]) > tolerance)
                                                      return points[i][d] < points[j][d];
                                                  return false;
                                                });
  std::vector<unsigned int> corners;
  unsigned int here = lowest;
  do
  {
    corners.push_back(here);
    unsigned int next = here;
    for (const unsigned int other : some)
    {
      if (other == here)
        continue;
      const Vector to_next = points[next] - points[here], to_other = points[other] - points[here];
      const double left = next == here ? -1. : normal * dealii::cross_product_3d(to_next, to_other);
      const double on_line = next == here ? 0. : tolerance * to_next.norm();
      if (left < -on_line || (left <= on_line && to_other.norm() > to_next.norm()))
        next = other;
    }
    here = next;
  } while (here != lowest && corners.size() < some.size());
  return corners;
}
} // namespace

ConvexHull::ConvexHull(const std::vector<Point> &given)
{
  const auto [points, size] = different(given);
  const Point first = points.front();
  const auto farthest =
      std::max_element(points.begin(), points.end(),
                       [&](const Point &a, const Point &b) { return a.distance(first) < b.distance(first); });
  Vector across; // from the line through two points
  for (const Point &x : points)
    if (const Vector normal = dealii::cross_product_3d(*farthest - first, x - first);
        normal.norm() > across.norm())
      across = normal;
  if (across.norm() > same * size * size)
    find_faces(points, size);
  else if (points.size() > 1)
  {
    const Vector line = unit(*farthest - first);
    const auto ends = std::minmax_element(
        points.begin(), points.end(), [&](const Point &a, const Point &b) { return (a - b) * line < 0.; });
    edges.push_back({{{static_cast<unsigned int>(ends.first - points.begin()),
                       static_cast<unsigned int>(ends.second - points.begin())}},
                     2. * PI});
  }
  else
  {
    corners = points;
    return;
  }
  find_edges();
  keep_corners(points);
}

/// A face lies in a plane through three points that has all others on one side. Where all lie in it, it has
/// two.
void ConvexHull::find_faces(const std::vector<Point> &points, const double size)
{
  const double tolerance = same * size;
  std::vector<std::vector<unsigned int>> of_faces;
  const auto known = [&](const unsigned int i, const unsigned int j, const unsigned int k)
  {
    return std::any_of(of_faces.begin(), of_faces.end(),
                       [&](const std::vector<unsigned int> &face)
                       {
                         return std::binary_search(face.begin(), face.end(), i) &&
                                std::binary_search(face.begin(), face.end(), j) &&
                                std::binary_search(face.begin(), face.end(), k);
                       });
  };
  const unsigned int n = points.size();
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = i + 1; j < n; ++j)
      for (unsigned int k = j + 1; k < n; ++k)
      {
        Vector normal = dealii::cross_product_3d(points[j] - points[i], points[k] - points[i]);
        if (normal.norm() <= tolerance * size || known(i, j, k))
          continue;
        normal = unit(normal);
        bool above = false, below = false;
        std::vector<unsigned int> in_plane;
        for (unsigned int m = 0; m < n; ++m)
        {
          const double height = (points[m] - points[i]) * normal;
          above = above || height > tolerance;
          below = below || height < -tolerance;
          if (std::abs(height) <= tolerance)
            in_plane.push_back(m);
        }
        if (above && below)
          continue;
        of_faces.push_back(in_plane);
        if (above)
          normal *= -1.;
        faces.push_back({normal, polygon_around(points, in_plane, normal, tolerance)});
        if (!above && !below)
        {
          faces.push_back({-normal, polygon_around(points, in_plane, -normal, tolerance)});
          return;
        }
      }
  solid = true;
}

void ConvexHull::find_edges()
{
  std::map<std::array<unsigned int, 2>, std::vector<Vector>> normals;
  for (const Face &face : faces)
    for (unsigned int k = 0; k < face.corners.size(); ++k)
    {
      const auto [low, high] = std::minmax(face.corners[k], face.corners[(k + 1) % face.corners.size()]);
      normals[{{low, high}}].push_back(face.normal);
    }
  for (const auto &[ends, both] : normals)
    edges.push_back({ends, std::atan2(dealii::cross_product_3d(both.front(), both.back()).norm(),
                                      both.front() * both.back())});
}

void ConvexHull::keep_corners(const std::vector<Point> &points)
{
  std::map<unsigned int, unsigned int> numbers;
  for (const Edge &edge : edges)
    for (const unsigned int end : edge.ends)
      numbers[end] = 0;
  for (auto &[old, number] : numbers)
  {
    number = corners.size();
    corners.push_back(points[old]);
  }
  for (Edge &edge : edges)
    for (unsigned int &end : edge.ends)
      end = numbers[end];
  for (Face &face : faces)
    for (unsigned int &corner : face.corners)
      corner = numbers[corner];
}

double ConvexHull::depth(const Point &x) const
{
  if (!solid)
    return 0.;
  double least = std::numeric_limits<double>::max();
  for (const Face &face : faces)
    least = std::min(least, (corners[face.corners[0]] - x) * face.normal);
  return std::max(least, 0.);
}

ConvexHull::Foot ConvexHull::foot(const Point &x) const
{
  for (const Face &face : faces)
  {
    const double height = (x - corners[face.corners[0]]) * face.normal;
    bool over = height >= 0.;
    for (unsigned int k = 0; k < face.corners.size() && over; ++k)
    {
      const Point &a = corners[face.corners[k]], &b = corners[face.corners[(k + 1) % face.corners.size()]];
      over = dealii::cross_product_3d(face.normal, b - a) * (x - a) >= 0.;
    }
    if (over)
      return {height * face.normal, Foot::On::face, Vector()};
  }
  Foot nearest;
  double least = std::numeric_limits<double>::max();
  const auto take = [&](const Foot &foot)
  {
    if (const double distance = foot.off.norm(); distance < least)
    {
      least = distance;
      nearest = foot;
    }
  };
  for (const Point &corner : corners)
    take({x - corner, Foot::On::corner, Vector()});
  for (const Edge &edge : edges)
  {
    const Vector way = corners[edge.ends[1]] - corners[edge.ends[0]], from = x - corners[edge.ends[0]];
    if (const double share = from * way / way.norm_square(); share > 0. && share < 1.)
      take({from - share * way, Foot::On::edge, unit(way)});
  }
  return nearest;
}

double ConvexHull::volume() const
{
  double sum = 0.;
  for (const Face &face : faces)
    for (unsigned int k = 1; k + 1 < face.corners.size(); ++k)
    {
      const Point &a = corners[face.corners[0]];
      sum += (a - corners[0]) *
             dealii::cross_product_3d(corners[face.corners[k]] - a, corners[face.corners[k + 1]] - a) / 6.;
    }
  return sum;
}

double ConvexHull::area() const
{
  double sum = 0.;
  for (const Face &face : faces)
    for (unsigned int k = 1; k + 1 < face.corners.size(); ++k)
    {
      const Point &a = corners[face.corners[0]];
      sum += 0.5 *
             dealii::cross_product_3d(corners[face.corners[k]] - a, corners[face.corners[k + 1]] - a).norm();
    }
  return sum;
}
} // namespace softgrain
