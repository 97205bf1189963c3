// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/solid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace softgrain
{
namespace
{
constexpr double spacing = 1. / 16.;  ///< of places that are looked at first, in widths of the other body
constexpr unsigned int steps = 60;    ///< from the best of them on
constexpr double as_good = 1. + 1e-9; ///< of radii of balls that touch

/// The greatest depth in @p a of a place of the surface of @p b moved by @p shift.
double deepest(const Shape<3> &a, const Shape<3> &b, const dealii::Tensor<1, 3> &shift)
{
  const auto [lower, upper] = b.bounding_box();
  const double width = std::min({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]});
  double most = -std::numeric_limits<double>::max();
  dealii::Point<3> best;
  for (const dealii::Point<3> &x : b.surface(spacing * width).vertices)
    if (const double depth = a.depth(x + shift); depth > most)
    {
      most = depth;
      best = x;
    }
  double step = spacing * width;
  SurfacePlace<3> here = b.place(best);
  for (unsigned int i = 0; i < steps; ++i)
  {
    bool found = false;
    for (unsigned int d = 0; d < 4 && !found; ++d)
    {
      const SurfacePlace<3> there =
          b.place(here.position + (d % 2 == 0 ? step : -step) * here.tangent[d / 2]);
      if (const double depth = a.depth(there.position + shift); depth > most)
      {
        most = depth;
        here = there;
        found = true;
      }
    }
    if (!found)
      step *= 0.5;
  }
  return most;
}
} // namespace

double overlap(const Shape<3> &a, const Shape<3> &b, const dealii::Tensor<1, 3> &shift)
{
  const auto box = a.bounding_box(), other = b.bounding_box();
  for (unsigned int d = 0; d < 3; ++d)
    if (box.first[d] >= other.second[d] + shift[d] || other.first[d] + shift[d] >= box.second[d])
      return 0.;
  if (a.round() && b.round())
  {
    const dealii::Point<3> one = box.first + 0.5 * (box.second - box.first),
                           two = other.first + 0.5 * (other.second - other.first);
    return (a.depth(one) + b.depth(two)) / as_good - one.distance(two + shift);
  }
  const double tolerance = (as_good - 1.) * (box.second - box.first).norm();
  return std::max(deepest(a, b, shift), deepest(b, a, -shift)) - tolerance;
}
} // namespace softgrain
