// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/packing/convex_grain.h>

#include <array>
#include <cmath>

namespace softgrain
{
namespace
{
using Vector = ConvexGrain::Vector;

double cross(const Vector &u, const Vector &v)
{
  return u[0] * v[1] - u[1] * v[0];
}

/// Across the edge from @p p on along @p edge, towards the origin.
Vector towards_origin(const Vector &p, const Vector &edge)
{
  const Vector across({-edge[1], edge[0]});
  return across * p > 0. ? -across : across;
}
} // namespace

ConvexGrain::ConvexGrain(const double radius, const GrainForm2D &form)
    : kind(form.kind), a(radius), b(kind == GrainForm2D::Kind::disk ? radius : form.short_radius)
{
  if (kind == GrainForm2D::Kind::polygon)
    for (const Vector &corner : form.directions())
      corners.push_back(Vector({a * corner[0], b * corner[1]}));
}

void ConvexGrain::put(const Place &center, const double angle)
{
  middle = center;
  if (angle == turned)
    return;
  turned = angle;
  cosine = std::cos(angle);
  sine = std::sin(angle);
}

ConvexGrain::Place ConvexGrain::support(const Vector &direction) const
{
  if (kind == GrainForm2D::Kind::disk)
    return middle + a / direction.norm() * direction;
  const Vector d({cosine * direction[0] + sine * direction[1], cosine * direction[1] - sine * direction[0]});
  Vector best;
  if (kind == GrainForm2D::Kind::ellipse)
    best = Vector({a * a * d[0], b * b * d[1]}) / std::hypot(a * d[0], b * d[1]);
  else
  {
    best = corners.front();
    for (const Vector &corner : corners)
      if (corner * d > best * d)
        best = corner;
  }
  return middle + Vector({cosine * best[0] - sine * best[1], sine * best[0] + cosine * best[1]});
}

bool touch(const ConvexGrain &one, const ConvexGrain &other)
{
  const double reach = one.radius() + other.radius();
  Vector direction = one.center() - other.center();
  if (direction.norm_square() > reach * reach)
    return false;
  if (direction.norm() < 1e-12 * reach)
    return true;
  // Corners of a simplex inside of the difference of the two.
  std::array<Vector, 3> p;
  unsigned int n = 0;
  direction *= -1.;
  for (unsigned int iteration = 0; iteration < 40; ++iteration)
  {
    const Vector next = one.support(direction) - other.support(-direction);
    if (next * direction < 0.)
      return false;
    p[n++] = next;
    if (n == 1)
      direction = -next;
    else if (n == 2)
      direction = towards_origin(p[0], p[1] - p[0]);
    else
    {
      // The origin is on the inner side of the first edge; beside which of the other two is it not?
      const double side = cross(p[1] - p[0], p[2] - p[0]) > 0. ? 1. : -1.;
      if (side * cross(p[2] - p[1], -p[1]) < 0.)
        p[0] = p[2];
      else if (side * cross(p[0] - p[2], -p[2]) < 0.)
        p[1] = p[2];
      else
        return true;
      n = 2;
      direction = towards_origin(p[0], p[1] - p[0]);
    }
    if (direction.norm() < 1e-14 * reach)
      return true;
  }
  return true; // so near that it makes no difference
}
} // namespace softgrain
