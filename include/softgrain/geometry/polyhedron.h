// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_polyhedron_h
#define softgrain_geometry_polyhedron_h

#include <softgrain/geometry/convex_hull.h>
#include <softgrain/geometry/rounded_solid.h>

#include <vector>

namespace softgrain
{
/**
 * @brief A convex body with flat faces and round edges: all places that are no farther than a radius from the
 * smallest convex body around some points (a spheropolyhedron: L. Pournin and T. M. Liebling, A
 * generalization of distinct element method to tridimensional particles with complex shapes, 2005).
 *
 * Two points make a rod with round ends, points in a plane a plate with a round rim.
 */
class Polyhedron : public RoundedSolid
{
public:
  Polyhedron() = default;
  /// @param vertices from @p center, before the turn [m] @param rotation axis times angle [rad]
  Polyhedron(const Place &center, std::vector<Vector> vertices, double edge_radius, const Vector &rotation);

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) override;
  void check(const std::string &body) const override;
  bool round() const override { return hull.corners.size() == 1; }
  /// Steiner's formula is V + S r + (sum of the edges' lengths times turns)/2 r^2 + 4/3 pi r^3.
  double volume() const override;
  std::pair<double, double> distances_from_plane(const Place &point, const Vector &normal) const override;
  std::vector<double> numbers() const override;

protected:
  /// Takes its corners from the centre, before the turn.
  void set_vertices(std::vector<Vector> told);

  Vector extents() const override;
  double beyond_extents() const override;
  Vector from_core(const Place &x) const override { return hull.foot(x).off; }
  double depth_in_core(const Place &x) const override { return hull.depth(x); }
  double reach_of_core() const override;
  dealii::Tensor<2, 3> turn_of_normal(const Place &x) const override;

private:
  std::vector<Vector> vertices; ///< as told [m]
  ConvexHull hull;              ///< in its place
};
} // namespace softgrain

#endif
