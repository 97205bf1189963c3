// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/curve.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
Curve::Vector left_of(const Curve::Vector &direction)
{
  return Curve::Vector({-direction[1], direction[0]});
}
} // namespace

Curve Curve::segment(const Place &begin, const Place &end)
{
  Curve curve;
  curve.first = begin;
  curve.last = end;
  return curve;
}

Curve Curve::arc(const Place &center, const double radius, const double from, const double to)
{
  Curve curve;
  curve.center = center;
  curve.radius = radius;
  curve.from = from;
  // A turn that has been written in degrees is one.
  curve.sweep = to - from > full_turn - 1e-9 ? full_turn : to - from;
  curve.first = curve.at(from);
  curve.last = curve.at(to);
  return curve;
}

Curve::Place Curve::at(const double angle) const
{
  return center + radius * Vector({std::cos(angle), std::sin(angle)});
}

Curve::Vector Curve::direction_at_begin() const
{
  if (radius > 0.)
    return left_of(first - center) / radius;
  return (last - first) / first.distance(last);
}

Curve::Vector Curve::direction_at_end() const
{
  return radius > 0. ? left_of(last - center) / radius : direction_at_begin();
}

Curve::Course Curve::course(const double along) const
{
  if (radius == 0.)
    return {first + along * direction_at_begin(), direction_at_begin(), 0.};
  const double angle = from + along / radius;
  return {at(angle), Vector({-std::sin(angle), std::cos(angle)}), 1. / radius};
}

Curve::Foot Curve::foot(const Place &p) const
{
  Foot foot;
  if (radius == 0.)
  {
    const Vector edge = last - first;
    const double length = edge.norm(), along = (p - first) * edge / length;
    foot.normal = left_of(edge / length);
    foot.beyond = std::max({0., -along, along - length});
    // Ends exactly, so that pieces of a chain have the same one.
    foot.place = along <= 0. ? first : along >= length ? last : Place(first + along / length * edge);
    return foot;
  }
  const Vector arm = p - center;
  const double norm = arm.norm();
  double angle = std::atan2(arm[1], arm[0]) - from;
  angle -= full_turn * std::floor(angle / full_turn);
  if (angle <= sweep)
  {
    const Vector out = norm > 0. ? arm / norm : Vector({1., 0.});
    foot.place = center + radius * out;
    foot.normal = -out;
    return foot;
  }
  const bool at_end = angle - sweep < full_turn - angle;
  foot.place = at_end ? last : first;
  foot.normal = (center - foot.place) / radius;
  foot.beyond = radius * (at_end ? angle - sweep : full_turn - angle);
  return foot;
}

Polygon Curve::line(const double turn) const
{
  if (radius == 0.)
    return {first, last};
  const unsigned int n = std::max(2, static_cast<int>(std::ceil(sweep / turn)));
  Polygon vertices;
  for (unsigned int i = 0; i <= n; ++i)
    vertices.push_back(at(from + sweep * i / n));
  return vertices;
}
} // namespace softgrain
