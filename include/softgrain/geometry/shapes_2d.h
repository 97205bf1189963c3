// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_shapes_2d_h
#define softgrain_geometry_shapes_2d_h

#include <softgrain/geometry/shape.h>

namespace softgrain
{
/// A disk, or a ring when it has an inner radius.
class Disk2D final : public Shape<2>
{
public:
  Disk2D() = default;
  Disk2D(const Place &center, const double radius, const double inner_radius = 0.)
      : center(center), radius(radius), inner_radius(inner_radius)
  {
  }

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) override;
  void check(const std::string &body) const override;
  std::vector<Polygon> outline(double spacing) const override;
  Place project(const Place &on_edge, const Place &vertex) const override;
  bool round() const override { return true; }
  double area() const override;
  std::pair<double, double> distances_from_plane(const Place &point,
                                                 const dealii::Tensor<1, 2> &normal) const override;
  double depth(const Place &p) const override;
  Place some_place() const override;
  void describe(std::ostream &out, const Place &center) const override;
  std::vector<double> numbers() const override;

  Place center;            ///< [m]
  double radius = 0;       ///< [m]
  double inner_radius = 0; ///< [m], 0: no hole
};

/// What has straight edges: everything exact comes from its corners.
class Polygonal2D : public Shape<2>
{
public:
  std::vector<Polygon> outline(double spacing) const override;
  double area() const override;
  double depth(const Place &p) const override;
  Polygon corners() const override = 0;
};

class Rectangle2D final : public Polygonal2D
{
public:
  Rectangle2D() = default;
  Rectangle2D(const Place &center, const dealii::Tensor<1, 2> &edges, const double angle = 0.)
      : center(center), edges(edges), angle(angle)
  {
  }

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) override;
  void check(const std::string &body) const override;
  std::vector<Polygon> outline(double spacing) const override;
  Polygon corners() const override;
  Place some_place() const override { return center; }

  Place center;               ///< [m]
  dealii::Tensor<1, 2> edges; ///< lengths [m]
  double angle = 0;           ///< counter-clockwise [rad]
};

class Polygon2D final : public Polygonal2D
{
public:
  Polygon2D() = default;
  explicit Polygon2D(const Polygon &vertices) : vertices(vertices) {}

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) override;
  void check(const std::string &body) const override;
  Polygon corners() const override;
  Place some_place() const override { return vertices.front(); }

  Polygon vertices; ///< either way round [m]
};
} // namespace softgrain

#endif
