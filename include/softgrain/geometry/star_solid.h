// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_star_solid_h
#define softgrain_geometry_star_solid_h

#include <softgrain/geometry/gauge.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/geometry/spherical_harmonics.h>

#include <string>
#include <vector>

namespace softgrain
{
/**
 * @brief A body whose surface of triangles is read from a file and made smooth, convex or not: the distance
 * of the surface from the centre is a sum of spherical harmonics of the direction (E. J. Garboczi,
 * Three-dimensional mathematical analysis of particle shape using X-ray tomography and spherical harmonics,
 * 2002).
 *
 * The whole surface must be seen from the centroid. Edges become round, by about the radius of the body over
 * the degree; the volume is that of the triangles.
 */
class StarSolid final : public Shape<3>
{
public:
  StarSolid() = default;
  /// @param center where the centroid of the triangles is put [m] @param rotation axis times angle [rad]
  /// @throw InputError when the triangles are not closed, or not all seen from their centroid
  StarSolid(const Place &center,
            TriangulatedSurface triangles,
            unsigned int degree,
            const dealii::Tensor<1, 3> &rotation);

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) override;
  void check(const std::string &body) const override;
  /// 1 - the gauge, over its steepest slope.
  double depth(const Place &p) const override;
  SurfacePlace<3> place(const Place &x) const override;
  double volume() const override { return told_volume; }
  std::pair<double, double> distances_from_plane(const Place &point,
                                                 const dealii::Tensor<1, 3> &normal) const override;
  TriangulatedSurface surface(double spacing) const override;
  std::optional<Place> surface_in_box(const Place &lower, const Place &upper) const override;
  std::vector<double> numbers() const override;

private:
  using Vector = dealii::Tensor<1, 3>;

  static StarSolid of_no_size(const Place &center, const std::string &trouble);
  void fit(TriangulatedSurface triangles, unsigned int degree);
  Gauge gauge(const Place &p) const;
  /// The greatest distance from the centre along @p normal.
  double reach(const Vector &normal) const;
  /// A place of a box at which the depth has no greater one beside it, or no smaller one.
  Place deepest_beside(Place from, const Place &lower, const Place &upper, double sign) const;

  Place center;
  Vector rotation; ///< axis times angle [rad]
  SphericalHarmonics distance;
  double told_volume = 0., steepest = 0., farthest = 0.;
  std::vector<Place> seen; ///< places of the surface all around, where a search begins
  std::string trouble;     ///< why there is no body
};
} // namespace softgrain

#endif
