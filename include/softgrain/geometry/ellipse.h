// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_ellipse_h
#define softgrain_geometry_ellipse_h

#include <softgrain/geometry/shape.h>

namespace softgrain
{
class Ellipse2D final : public Shape<2>
{
public:
  Ellipse2D() = default;
  /// @param center,semi_axes [m] @param angle of the first axis, counter-clockwise [rad]
  Ellipse2D(const Place &center, const dealii::Tensor<1, 2> &semi_axes, const double angle)
      : center(center), semi_axes(semi_axes), angle(angle)
  {
  }

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) override;
  void check(const std::string &body) const override;
  /// Edges of one length, three or more in each quarter.
  std::vector<Polygon> outline(double spacing) const override;
  Place project(const Place &on_edge, const Place &vertex) const override;
  bool round() const override { return true; }
  double area() const override;
  std::pair<double, double> distances_from_plane(const Place &point,
                                                 const dealii::Tensor<1, 2> &normal) const override;
  double depth(const Place &p) const override;
  /// 256 places: where bodies overlap at the start by less than a thousandth it goes unnoticed.
  Polygon corners() const override;
  Place some_place() const override { return center; }
  void describe(std::ostream &out, const Place &center) const override;
  std::vector<double> numbers() const override;

  Place center;                   ///< [m]
  dealii::Tensor<1, 2> semi_axes; ///< [m]
  double angle = 0;               ///< of the first axis, counter-clockwise [rad]

private:
  dealii::Tensor<1, 2> to_axes(const dealii::Tensor<1, 2> &v) const;
  dealii::Tensor<1, 2> from_axes(const dealii::Tensor<1, 2> &v) const;
  /// Length along the boundary up to equal steps of its parameter [m].
  std::vector<double> lengths() const;
  /// @p n places on the boundary, as far apart along it, of which @p length is the table.
  Polygon places(unsigned int n, const std::vector<double> &length) const;
  /// The place of the boundary nearest to @p p.
  Place nearest(const Place &p) const;
};
} // namespace softgrain

#endif
