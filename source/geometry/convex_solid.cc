// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/convex_solid.h>
#include <softgrain/geometry/turned_axes.h>

#include <algorithm>

namespace softgrain
{
ConvexSolid::ConvexSolid(const Place &center, const Vector &rotation)
    : center(center), rotation(rotation), turn(turned_axes(rotation))
{
}

void ConvexSolid::parse_place(const dealii::ParameterHandler &prm, const Place &body_center)
{
  center = body_center;
  rotation = rotation_of(prm);
  turn = turned_axes(rotation);
}

TriangulatedSurface ConvexSolid::surface(const double spacing) const
{
  const Vector extent = extents();
  const double longest = std::max({extent[0], extent[1], extent[2]});
  TriangulatedSurface result = Sphere(Place(), 1.).surface(spacing / (beyond_extents() * longest));
  for (Place &x : result.vertices)
  {
    Vector stretched;
    for (unsigned int d = 0; d < 3; ++d)
      stretched[d] = extent[d] * x[d];
    x = place(center + turn * stretched).position;
  }
  return result;
}

/// A place between one of the box that lies inside and the corner that is farthest out. Depth is concave: it
/// is smallest at a corner, and greatest where no coordinate alone makes it greater.
std::optional<ConvexSolid::Place> ConvexSolid::surface_in_box(const Place &lower, const Place &upper) const
{
  Place near = center, far = lower;
  for (unsigned int c = 0; c < 8; ++c)
  {
    const Place corner(c & 1 ? upper[0] : lower[0], c & 2 ? upper[1] : lower[1], c & 4 ? upper[2] : lower[2]);
    if (depth(corner) < depth(far))
      far = corner;
  }
  if (!(depth(far) < 0.))
    return std::nullopt;
  for (unsigned int d = 0; d < 3; ++d)
    near[d] = std::clamp(center[d], lower[d], upper[d]);
  for (unsigned int sweep = 0; sweep < 30 && !(depth(near) > 0.); ++sweep)
    for (unsigned int d = 0; d < 3; ++d)
    {
      double low = lower[d], high = upper[d];
      for (unsigned int halving = 0; halving < 30; ++halving)
      {
        near[d] = 0.5 * (low + high);
        (outward(near)[d] > 0. ? high : low) = near[d];
      }
    }
  if (!(depth(near) > 0.))
    return std::nullopt;
  for (unsigned int halving = 0; halving < 50; ++halving)
  {
    const Place middle = near + 0.5 * (far - near);
    (depth(middle) > 0. ? near : far) = middle;
  }
  return near;
}
} // namespace softgrain
