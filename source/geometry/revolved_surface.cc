// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/revolved_surface.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain
{
namespace
{
constexpr unsigned int parts_of_turn = 48; ///< of pictures

using Point2 = RevolvedSurface::Point2;

double distance(const Point2 &a, const Point2 &b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// The nearest place of a line to a place.
struct Nearest
{
  Point2 place{{0., 0.}};
  double distance = std::numeric_limits<double>::max();
  bool at_point = false; ///< where the line ends or turns

  void look_at(const Point2 &x, const Point2 &candidate, const bool is_point)
  {
    if (const double d = softgrain::distance(x, candidate); d < distance)
    {
      place = candidate;
      distance = d;
      at_point = is_point;
    }
  }
};

Nearest nearest_on(const std::vector<Point2> &line, const Point2 &x)
{
  Nearest nearest;
  for (const Point2 &point : line)
    nearest.look_at(x, point, true);
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const Point2 &a = line[i], &b = line[i + 1];
    const double length = distance(a, b),
                 share = ((x[0] - a[0]) * (b[0] - a[0]) + (x[1] - a[1]) * (b[1] - a[1])) / (length * length);
    if (share > 0. && share < 1.)
      nearest.look_at(x, {{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])}}, false);
  }
  return nearest;
}

/// Triangles of the line as it turns; of a single point those of what surrounds it.
TriangulatedSurface draw(const std::vector<Point2> &line,
                         const dealii::Point<3> &center,
                         const dealii::Tensor<1, 3> &axis,
                         const double radius)
{
  std::vector<Point2> shown = line;
  if (shown.size() == 1)
  {
    // What surrounds a point has a shape, the point has none.
    const Point2 point = shown[0];
    shown.clear();
    const bool ball = point[0] == 0.;
    const unsigned int parts = ball ? parts_of_turn / 2 : parts_of_turn;
    for (unsigned int i = 0; i <= parts; ++i)
    {
      const double angle = (ball ? dealii::numbers::PI : 2. * dealii::numbers::PI) * i / parts;
      shown.push_back(
          {{std::max(0., point[0] + radius * std::sin(angle)), point[1] - radius * std::cos(angle)}});
    }
  }
  TriangulatedSurface result;
  const dealii::Tensor<1, 3> first = any_tangent(axis), second = dealii::cross_product_3d(axis, first);
  for (const Point2 &point : shown)
    for (unsigned int i = 0; i < parts_of_turn; ++i)
    {
      const double angle = 2. * dealii::numbers::PI * i / parts_of_turn;
      result.vertices.push_back(center + point[0] * (std::cos(angle) * first + std::sin(angle) * second) +
                                point[1] * axis);
    }
  for (unsigned int row = 0; row + 1 < shown.size(); ++row)
    for (unsigned int i = 0; i < parts_of_turn; ++i)
    {
      const unsigned int a = row * parts_of_turn + i, b = row * parts_of_turn + (i + 1) % parts_of_turn;
      result.triangles.push_back({{a, b, b + parts_of_turn}});
      result.triangles.push_back({{a, b + parts_of_turn, a + parts_of_turn}});
    }
  return result;
}
} // namespace

RevolvedSurface::RevolvedSurface(std::vector<Point2> line,
                                 const dealii::Point<3> &center,
                                 const Vector &axis,
                                 const double thickness)
    : RigidSurface(thickness, draw(line, center, axis, 0.5 * thickness).vertices)
    , line(std::move(line))
    , center(center)
    , axis(axis)
{
}

std::optional<RigidSurface::Foot> RevolvedSurface::foot(const dealii::Point<3> &x, const double within) const
{
  const double height = (x - center) * axis;
  const Vector away = x - center - height * axis;
  const double from_axis = away.norm();
  const Nearest nearest = nearest_on(line, {{from_axis, height}});
  if (nearest.distance > within || !(nearest.distance > 0.))
    return std::nullopt;
  const Vector outwards = from_axis > 0. ? away / from_axis : any_tangent(axis);
  const double out = (from_axis - nearest.place[0]) / nearest.distance,
               up = (height - nearest.place[1]) / nearest.distance;
  Foot result;
  result.place = center + nearest.place[0] * outwards + nearest.place[1] * axis;
  result.distance = nearest.distance;
  result.normal = out * outwards + up * axis;
  result.along = out * axis - up * outwards;
  result.bend[0] = nearest.at_point ? 1. / radius : 0.;
  // Around the axis the surface is as round as its distance from the axis says.
  const double around = nearest.place[0] + radius * out;
  result.bend[1] = nearest.place[0] == 0. && nearest.at_point ? 1. / radius : around > 0. ? out / around : 0.;
  return result;
}

TriangulatedSurface RevolvedSurface::drawn() const
{
  return draw(line, center, axis, radius);
}
} // namespace softgrain
