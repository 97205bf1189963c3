// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_box_solid_h
#define softgrain_geometry_box_solid_h

#include <softgrain/geometry/polyhedron.h>

namespace softgrain
{
/// A box with round edges: the polyhedron of its eight corners.
class BoxSolid final : public Polyhedron
{
public:
  BoxSolid() = default;
  /// @param size of the whole body along its axes [m] @param rotation axis times angle [rad]
  BoxSolid(const Place &center, const Vector &size, double edge_radius, const Vector &rotation);

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) override;
  void check(const std::string &body) const override;

private:
  Vector size; ///< [m]
};
} // namespace softgrain

#endif
