// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_revolved_surface_h
#define softgrain_geometry_revolved_surface_h

#include <softgrain/geometry/rigid_surface.h>

#include <array>
#include <vector>

namespace softgrain
{
/**
 * @brief A sheet that a broken line makes as it turns about an axis: a tube, a cone, a disk, a drum with
 * lids.
 *
 * A single point on the axis makes a ball, one beside it a ring, two points on the axis a rod with round
 * ends.
 */
class RevolvedSurface final : public RigidSurface
{
public:
  using Point2 = std::array<double, 2>; ///< distance from the axis, height along it [m]

  /// @param line     one point or more, none with a negative distance from the axis
  /// @param center   from where heights are measured
  /// @param axis     unit, up
  RevolvedSurface(std::vector<Point2> line,
                  const dealii::Point<3> &center,
                  const Vector &axis,
                  double thickness);

  TriangulatedSurface drawn() const override;

protected:
  std::optional<Foot> foot(const dealii::Point<3> &x, double within) const override;

private:
  const std::vector<Point2> line;
  const dealii::Point<3> center;
  const Vector axis;
};
} // namespace softgrain

#endif
