// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_packing_convex_grain_h
#define softgrain_packing_convex_grain_h

#include <softgrain/packing/packing.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace softgrain
{
/// A disk, an ellipse or a polygon on its way into a packing.
class ConvexGrain
{
public:
  using Place = dealii::Point<2>;
  using Vector = dealii::Tensor<1, 2>;

  ConvexGrain(double radius, const GrainForm2D &form);

  /// Puts it somewhere. @param angle of its first axis [rad]
  void put(const Place &center, double angle);

  /// The place of the grain furthest along @p direction, which need not be unit [m].
  Place support(const Vector &direction) const;

  const Place &center() const { return middle; }
  double angle() const { return turned; } ///< [rad]
  double radius() const { return a; }     ///< of the circle around it [m]

private:
  GrainForm2D::Kind kind;
  double a, b;
  Place middle;
  double turned = 0, cosine = 1, sine = 0;
  std::vector<Vector> corners; ///< of a polygon, in its axes
};

/// Whether two convex grains touch or overlap, by the distance algorithm of Gilbert, Johnson and Keerthi
/// (1988): whether the difference of the two holds the origin.
bool touch(const ConvexGrain &one, const ConvexGrain &other);
} // namespace softgrain

#endif
