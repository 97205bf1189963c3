// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_rounded_solid_h
#define softgrain_geometry_rounded_solid_h

#include <softgrain/geometry/convex_solid.h>

namespace softgrain
{
/**
 * @brief All places that are no farther than a radius from a convex core: faces of the core stay flat, and
 * its edges and corners become round.
 *
 * Distances, normals and curvatures are exact. The curvature jumps where a face meets the round edge beside
 * it; normals do not.
 */
class RoundedSolid : public ConvexSolid
{
public:
  /// The distance from the surface.
  double depth(const Place &p) const override;
  SurfacePlace<3> place(const Place &x) const override;
  TriangulatedSurface surface(double spacing) const override;

protected:
  RoundedSolid() = default;
  RoundedSolid(const Place &center, const double edge_radius, const Vector &rotation);

  /// Declares `Edge radius` and `Rotation`.
  static void declare_edges(dealii::ParameterHandler &prm);
  void parse_edges(const dealii::ParameterHandler &prm, const Place &center);
  /// @throw InputError when edges are sharp, or when the body is more than ten times as long as wide
  void check_edges(const std::string &body, const std::string &told_by) const;

  Vector outward(const Place &p) const override { return from_core(p); }

  /// The way from the place of the core that is nearest to @p x, which is not in the core [m].
  virtual Vector from_core(const Place &x) const = 0;
  /// How deep a place lies in the core, 0 outside [m].
  virtual double depth_in_core(const Place &x) const = 0;
  /// How far the core reaches from the centre [m].
  virtual double reach_of_core() const = 0;
  /// Derivative of the unit normal at a place of the surface [1/m].
  virtual dealii::Tensor<2, 3> turn_of_normal(const Place &x) const = 0;

  double radius = 0.; ///< of the edges [m]
};
} // namespace softgrain

#endif
