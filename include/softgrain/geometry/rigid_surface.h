// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_rigid_surface_h
#define softgrain_geometry_rigid_surface_h

#include <softgrain/geometry/rest_surface.h>
#include <softgrain/geometry/solid.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace softgrain
{
/**
 * @brief The surface of a rigid obstacle in space: all that is half a thickness away from a skeleton.
 *
 * The skeleton is a sheet without thickness. Edges and tips of what surrounds it are round, so the surface
 * has a normal everywhere, bodies may touch it from both sides, and no ray misses an edge.
 */
class RigidSurface : public RestSurface<3>
{
public:
  using Place = SurfacePlace<3>;
  using Vector = dealii::Tensor<1, 3>;

  /// @param thickness of the sheet, above 0 [m]
  /// @param skeleton  places that the sheet lies between, for the box around it [m]
  RigidSurface(double thickness, const std::vector<dealii::Point<3>> &skeleton);

  double thickness() const { return 2. * radius; } ///< [m]

  /// The place of the surface that is nearest to @p x; none if the skeleton is further than @p within from x,
  /// or goes through x.
  std::optional<Place> nearest(const dealii::Point<3> &x, double within) const;

  /// Height of @p x above the surface, negative within the thickness; not above what @p within tells [m].
  double height(const dealii::Point<3> &x, double within) const;

  /// Where one who goes from @p from along the unit vector @p way meets the surface from outside first; none
  /// after @p longest [m], or if @p from is within the thickness.
  std::optional<Place> first_met(const dealii::Point<3> &from, const Vector &way, double longest) const;

  /// Goes along the tangent plane and back to the nearest place.
  Place move(const Place &place, const dealii::Tensor<1, 2> &way) const override;

  /// The skeleton, for pictures.
  virtual TriangulatedSurface drawn() const = 0;

  /// Corners of a box around the surface, as drawn [m].
  const std::pair<dealii::Point<3>, dealii::Point<3>> &bounding_box() const { return box; }

protected:
  /// The place of the skeleton that is nearest to some place.
  struct Foot
  {
    dealii::Point<3> place;     ///< [m]
    Vector normal;              ///< unit, from there
    double distance = 0.;       ///< [m]
    Vector along;               ///< a unit tangent of the surface around
    std::array<double, 2> bend; ///< of that surface along this tangent, and across it [1/m]
  };
  /// None if it is further than @p within, or the skeleton goes through @p x.
  virtual std::optional<Foot> foot(const dealii::Point<3> &x, double within) const = 0;

  const double radius; ///< half the thickness [m]

private:
  Place place_at(const dealii::Point<3> &position, const Foot &foot) const;

  const std::pair<dealii::Point<3>, dealii::Point<3>> box;
};

/// A unit vector at right angles to a unit vector.
dealii::Tensor<1, 3> any_tangent(const dealii::Tensor<1, 3> &normal);
} // namespace softgrain

#endif
