// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_solid_h
#define softgrain_geometry_solid_h

#include <softgrain/geometry/rest_surface.h>
#include <softgrain/geometry/shape.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace softgrain
{
/// A closed surface of triangles, whose corners run counter-clockwise when seen from outside.
struct TriangulatedSurface
{
  std::vector<dealii::Point<3>> vertices; ///< [m]
  std::vector<std::array<unsigned int, 3>> triangles;
};

/**
 * @brief The shape of a body in space at rest, in its place: `Bodies/NAME/Shape` names a member of this
 * family where `Dimension` is 3.
 *
 * A shape is smooth, and every ray from its centre meets its surface once. It knows how deep a place lies in
 * it, by which grids cut it, and how its surface runs, where contact is.
 */
template <>
class Shape<3>
{
public:
  using Place = dealii::Point<3>;

  virtual ~Shape() = default;

  /// Declares its parameters where the handler stands, in the section of a body that has `Center` already.
  virtual void declare_parameters(dealii::ParameterHandler &prm) const = 0;

  /// @param center 'Center' of the body [m]
  virtual void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) = 0;

  /// @param body "Bodies/NAME", for messages. @throw InputError when the shape encloses nothing
  virtual void check(const std::string &body) const = 0;

  /// How deep @p p lies inside, below 0 outside [m]. Its size is the distance to the surface, or less.
  virtual double depth(const Place &p) const = 0;

  /// The place of the surface on the ray from the centre to @p x, which is not the centre [m].
  virtual SurfacePlace<3> place(const Place &x) const = 0;

  /// Whether it is a ball, which is the same when it is turned.
  virtual bool round() const { return false; }

  /// [m^3]
  virtual double volume() const = 0;

  /// Least and greatest signed distance from a plane, along its unit normal [m].
  virtual std::pair<double, double> distances_from_plane(const Place &point,
                                                         const dealii::Tensor<1, 3> &normal) const = 0;

  /// Triangles whose vertices lie on the surface, about @p spacing apart and hardly farther [m].
  virtual TriangulatedSurface surface(double spacing) const = 0;

  /// A place of the surface in the box between two corners; none where it does not go through it.
  virtual std::optional<Place> surface_in_box(const Place &lower, const Place &upper) const = 0;

  /// Every number that places and shapes it: two are the same when these are.
  virtual std::vector<double> numbers() const = 0;

  /// Corners of the box around it with the smallest and with the greatest coordinates [m].
  std::pair<Place, Place> bounding_box() const;
};

template <>
Registry<Shape<3>> &Registry<Shape<3>>::instance();

/// A place of a surface with its unit normal and with some tangents, without bends.
SurfacePlace<3> place_of(const dealii::Point<3> &position, const dealii::Tensor<1, 3> &normal);

/// What @p make makes of a spacing so fine that vertices of a triangle are hardly farther apart than @p
/// spacing [m].
TriangulatedSurface finely(double spacing, const std::function<TriangulatedSurface(double)> &make);

/// How far two bodies lie in each other, the second moved by @p shift [m]; 0 or less: they do not.
double
overlap(const Shape<3> &a, const Shape<3> &b, const dealii::Tensor<1, 3> &shift = dealii::Tensor<1, 3>());

/// A ball.
class Sphere final : public Shape<3>
{
public:
  Sphere() = default;
  Sphere(const Place &center, const double radius) : center(center), radius(radius) {}

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) override;
  void check(const std::string &body) const override;
  double depth(const Place &p) const override { return radius - p.distance(center); }
  double volume() const override;
  SurfacePlace<3> place(const Place &x) const override;
  bool round() const override { return true; }
  std::pair<double, double> distances_from_plane(const Place &point,
                                                 const dealii::Tensor<1, 3> &normal) const override;
  /// A geodesic sphere: an icosahedron with divided sides, the same in the mirrors of all three axes.
  TriangulatedSurface surface(double spacing) const override;
  std::optional<Place> surface_in_box(const Place &lower, const Place &upper) const override;
  std::vector<double> numbers() const override { return {center[0], center[1], center[2], radius}; }

  Place center;      ///< [m]
  double radius = 0; ///< [m]
};
} // namespace softgrain

#endif
