// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_curve_h
#define softgrain_geometry_curve_h

#include <softgrain/geometry/polygon.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace softgrain
{
/// A straight segment or an arc of a circle: a line of finite length, with two sides.
class Curve
{
public:
  using Place = dealii::Point<2>;
  using Vector = dealii::Tensor<1, 2>;

  /// @param begin,end two different places [m]
  static Curve segment(const Place &begin, const Place &end);

  /// Counter-clockwise. @param center,radius [m]
  /// @param from,to directions from the centre, at most a turn apart, to > from [rad]
  static Curve arc(const Place &center, double radius, double from, double to);

  /// The place of the curve nearest to some place.
  struct Foot
  {
    Place place;       ///< [m]
    Vector normal;     ///< unit, to the left of the curve
    double beyond = 0; ///< how far the place lies beyond the nearer end, along the curve; 0: between them [m]
  };
  Foot foot(const Place &p) const;

  /// Place, direction and curvature at some length along the curve.
  struct Course
  {
    Place place;      ///< [m]
    Vector direction; ///< unit, towards the end
    double bend = 0;  ///< by which it turns to the left [1/m]
  };
  /// @param along from the beginning, within its length [m]
  Course course(double along) const;
  double length() const { return radius > 0. ? radius * sweep : first.distance(last); } ///< [m]

  Place begin() const { return first; } ///< [m]
  Place end() const { return last; }    ///< [m]
  /// Unit, along the curve.
  Vector direction_at_begin() const;
  Vector direction_at_end() const;

  /// A whole circle has no ends.
  bool closed() const { return radius > 0. && sweep >= full_turn; }

  /// Vertices from the beginning to the end, at most @p turn apart on arcs [rad].
  Polygon line(double turn) const;

private:
  static constexpr double full_turn = 6.283185307179586;

  Place at(double angle) const;

  Place first, last;
  Place center;                           ///< of an arc
  double radius = 0, from = 0, sweep = 0; ///< radius 0: straight
};
} // namespace softgrain

#endif
