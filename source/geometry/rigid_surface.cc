// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/rigid_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain
{
namespace
{
constexpr unsigned int most_steps = 80; ///< of the search along a line
constexpr double rounding = 4e-16;      ///< of a distance, over coordinates
constexpr double hardly = 0.25;         ///< cosine from which on Newton's method tells how far to go

/// Corners of a box that has @p distance from all places at least.
std::pair<dealii::Point<3>, dealii::Point<3>> box_around(const std::vector<dealii::Point<3>> &places,
                                                         const double distance)
{
  std::pair<dealii::Point<3>, dealii::Point<3>> box(places.front(), places.front());
  for (const dealii::Point<3> &place : places)
    for (unsigned int d = 0; d < 3; ++d)
    {
      box.first[d] = std::min(box.first[d], place[d]);
      box.second[d] = std::max(box.second[d], place[d]);
    }
  for (unsigned int d = 0; d < 3; ++d)
  {
    box.first[d] -= distance;
    box.second[d] += distance;
  }
  return box;
}
} // namespace

RigidSurface::RigidSurface(const double thickness, const std::vector<dealii::Point<3>> &skeleton)
    : radius(0.5 * thickness), box(box_around(skeleton, 0.5 * thickness))
{
}

RigidSurface::Place RigidSurface::place_at(const dealii::Point<3> &position, const Foot &foot) const
{
  Place place;
  place.position = position;
  place.normal = foot.normal;
  place.tangent[0] = foot.along;
  place.tangent[1] = dealii::cross_product_3d(foot.normal, foot.along);
  place.bend[0][0] = foot.bend[0];
  place.bend[1][1] = foot.bend[1];
  return place;
}

std::optional<RigidSurface::Place> RigidSurface::nearest(const dealii::Point<3> &x, const double within) const
{
  const std::optional<Foot> found = foot(x, within);
  if (!found)
    return std::nullopt;
  return place_at(found->place + radius * found->normal, *found);
}

double RigidSurface::height(const dealii::Point<3> &x, const double within) const
{
  const std::optional<Foot> found = foot(x, within);
  return (found ? found->distance : within) - radius;
}

std::optional<RigidSurface::Place>
RigidSurface::first_met(const dealii::Point<3> &from, const Vector &way, const double longest) const
{
  double gone = 0.;
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    const dealii::Point<3> x = from + gone * way;
    const std::optional<Foot> here = foot(x, 2. * radius + longest - std::min(gone, longest));
    if (!here)
      return std::nullopt;
    const double gap = here->distance - radius, slope = here->normal * way;
    if (std::abs(gap) <= rounding * (x.norm() + radius))
      return slope < 0. ? std::optional<Place>(place_at(x, *here)) : std::nullopt;
    if (gap < 0. && (step == 0 || !(slope < 0.)))
      return std::nullopt;
    // Nothing is nearer than the distance. Close to the surface Newton's method goes as far as slopes allow
    // that rays may have.
    const double next = gone + (gap > radius || slope > -hardly ? gap : -gap / slope);
    if (next == gone)
      return place_at(x, *here);
    gone = next;
    if (gone > longest || gone < -radius)
      return std::nullopt;
  }
  return std::nullopt;
}

RigidSurface::Place RigidSurface::move(const Place &place, const dealii::Tensor<1, 2> &way) const
{
  const dealii::Point<3> x = place.position + way[0] * place.tangent[0] + way[1] * place.tangent[1];
  const std::optional<Place> moved = nearest(x, 2. * (radius + way.norm()));
  return moved ? *moved : place;
}

dealii::Tensor<1, 3> any_tangent(const dealii::Tensor<1, 3> &normal)
{
  unsigned int least = 0;
  for (unsigned int d = 1; d < 3; ++d)
    if (std::abs(normal[d]) < std::abs(normal[least]))
      least = d;
  dealii::Tensor<1, 3> axis;
  axis[least] = 1.;
  const dealii::Tensor<1, 3> tangent = dealii::cross_product_3d(normal, axis);
  return tangent / tangent.norm();
}
} // namespace softgrain
