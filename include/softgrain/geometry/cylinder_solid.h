// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_cylinder_solid_h
#define softgrain_geometry_cylinder_solid_h

#include <softgrain/geometry/rounded_solid.h>

#include <vector>

namespace softgrain
{
/// A cylinder about the z axis, before it is turned, with flat ends and round rims: a tablet, a pin, a disc.
/// With rims as wide as its radius it is a rod with round ends.
class CylinderSolid final : public RoundedSolid
{
public:
  CylinderSolid() = default;
  /// @param radius, height of the whole body [m] @param rotation axis times angle [rad]
  CylinderSolid(
      const Place &center, double radius, double height, double edge_radius, const Vector &rotation);

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) override;
  void check(const std::string &body) const override;
  bool round() const override { return core_radius == 0. && half_core == 0.; }
  /// Steiner's formula for the core, whose mean curvature adds up to pi h + pi^2 R.
  double volume() const override;
  std::pair<double, double> distances_from_plane(const Place &point, const Vector &normal) const override;
  std::vector<double> numbers() const override;

protected:
  Vector extents() const override;
  double beyond_extents() const override;
  Vector from_core(const Place &x) const override;
  double depth_in_core(const Place &x) const override;
  double reach_of_core() const override;
  dealii::Tensor<2, 3> turn_of_normal(const Place &x) const override;

private:
  void set(double whole_radius, double height);
  /// The same way as from_core(), with both vectors along the axes of the cylinder and from its centre [m].
  Vector off_core(Vector at) const;

  double core_radius = 0., half_core = 0.; ///< radius and half the height of the core [m]
};
} // namespace softgrain

#endif
