// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_convex_solid_h
#define softgrain_geometry_convex_solid_h

#include <softgrain/geometry/solid.h>

#include <deal.II/base/symmetric_tensor.h>

namespace softgrain
{
/**
 * @brief A smooth convex body that is turned about its centre, and what follows from that alone.
 *
 * Parameter `Rotation` turns it; before, its own axes lie along x, y and z.
 */
class ConvexSolid : public Shape<3>
{
public:
  std::optional<Place> surface_in_box(const Place &lower, const Place &upper) const override;
  /// A geodesic sphere, stretched along the axes and brought to the surface.
  TriangulatedSurface surface(double spacing) const override;

protected:
  using Vector = dealii::Tensor<1, 3>;

  ConvexSolid() = default;
  /// @param rotation axis times angle [rad]
  ConvexSolid(const Place &center, const Vector &rotation);

  void parse_place(const dealii::ParameterHandler &prm, const Place &center);

  /// A vector along the derivative of -depth() at a place that is not the centre.
  virtual Vector outward(const Place &p) const = 0;

  /// Semi-axes of an ellipsoid that is about as long in every direction as the body is, along its axes [m].
  virtual Vector extents() const = 0;

  /// How much farther than that ellipsoid the body reaches in any direction, at most.
  virtual double beyond_extents() const = 0;

  Place center;    ///< a place inside, from which every ray meets the surface once [m]
  Vector rotation; ///< axis times angle [rad]
  /// The axes are its columns.
  dealii::Tensor<2, 3> turn = dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
};
} // namespace softgrain

#endif
