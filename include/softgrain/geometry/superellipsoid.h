// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_superellipsoid_h
#define softgrain_geometry_superellipsoid_h

#include <softgrain/geometry/convex_solid.h>
#include <softgrain/geometry/gauge.h>

#include <vector>

namespace softgrain
{
/**
 * @brief A convex body between an ellipsoid, a box and a cylinder, all of them with round edges.
 *
 * In the directions of its axes, with x, y and z over the semi-axes,
 *
 *     N(x, y, z) = ((|x|^m + |y|^m)^(n/m) + |z|^n)^(1/n) = 1,   n, m >= 2
 *
 * (A. H. Barr, Superquadrics and angle-preserving transformations, 1981). n = m = 2 is an ellipsoid; with n
 * and m large it is a box, with n large and m = 2 a cylinder. N is a norm, so that surface, normal, curvature
 * and support follow in closed form.
 */
class Superellipsoid : public ConvexSolid
{
public:
  Superellipsoid() = default;
  /// @param rotation axis times angle [rad]
  Superellipsoid(const Place &center,
                 const dealii::Tensor<1, 3> &semi_axes,
                 const std::array<double, 2> &exponents,
                 const dealii::Tensor<1, 3> &rotation);

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) override;
  void check(const std::string &body) const override;
  /// 1 - N times the least semi-axis: N grows by no more than 1 over that.
  double depth(const Place &p) const override;
  double volume() const override;
  std::pair<double, double> distances_from_plane(const Place &point,
                                                 const dealii::Tensor<1, 3> &normal) const override;
  SurfacePlace<3> place(const Place &x) const override;
  std::vector<double> numbers() const override;

protected:
  void declare_axes(dealii::ParameterHandler &prm) const;
  void parse_axes(const dealii::ParameterHandler &prm, const Place &center);
  Vector outward(const Place &p) const override { return gauge(p).gradient; }
  Vector extents() const override { return semi_axes; }
  double beyond_extents() const override;

private:
  /// N with its derivatives.
  Gauge gauge(const Place &p) const;
  /// Coordinates of @p p along the axes, over the semi-axes.
  Vector over_axes(const Place &p) const;

  Vector semi_axes;                             ///< [m]
  std::array<double, 2> exponents = {{2., 2.}}; ///< n and m
};

/// An ellipsoid: n = m = 2.
class Ellipsoid final : public Superellipsoid
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override { declare_axes(prm); }
  void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) override
  {
    parse_axes(prm, center);
  }
};
} // namespace softgrain

#endif
