// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_sphere_surface_h
#define softgrain_geometry_sphere_surface_h

#include <softgrain/geometry/rest_surface.h>

#include <array>
#include <utility>
#include <vector>

namespace softgrain
{
/// The surface of a ball. It has one piece and no edge.
class SphereSurface final : public RestSurface<3>
{
public:
  using Place = SurfacePlace<3>;

  SphereSurface() = default;
  /// @param triangles of the markers of its body, outward: where contact is looked for
  SphereSurface(const dealii::Point<3> &center,
                const double radius,
                std::vector<std::array<unsigned int, 3>> triangles)
      : triangles(std::move(triangles)), center(center), radius(radius)
  {
  }

  /// The place that lies on the ray from the centre to @p x, which is not the centre [m].
  Place at(const dealii::Point<3> &x) const;

  /// Goes along the tangent plane and back to the centre.
  Place move(const Place &place, const dealii::Tensor<1, 2> &way) const override;

  std::vector<std::array<unsigned int, 3>> triangles;

private:
  dealii::Point<3> center; ///< [m]
  double radius = 1.;      ///< [m]
};
} // namespace softgrain

#endif
