// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_shape_h
#define softgrain_geometry_shape_h

#include <softgrain/base/registry.h>
#include <softgrain/geometry/polygon.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/**
 * @brief The shape of a body at rest, in its place: `Bodies/NAME/Shape` names a member of this family.
 *
 * A new shape must know its parameters and its outline; the rest follows from a fine outline, and is there to
 * be replaced by what is exact. In three dimensions an outline would be a triangulated surface.
 */
template <int dim>
class Shape;

template <>
class Shape<2>
{
public:
  using Place = dealii::Point<2>;

  virtual ~Shape() = default;

  /// Declares its parameters where the handler stands, in the section of a body that has `Center` already.
  virtual void declare_parameters(dealii::ParameterHandler &prm) const = 0;

  /// @param center 'Center' of the body [m]
  virtual void parse_parameters(const dealii::ParameterHandler &prm, const Place &center) = 0;

  /// @param body "Bodies/NAME", for messages. @throw InputError when the shape encloses nothing
  virtual void check(const std::string &body) const = 0;

  /**
   * @brief The boundary as closed polylines with edges of at most @p spacing [m].
   *
   * The outer boundary comes first, counter-clockwise; a hole follows, clockwise, so that the solid lies to
   * the left of every edge. All vertices lie on the boundary; corners are always vertices.
   */
  virtual std::vector<Polygon> outline(double spacing) const = 0;

  /// Takes a place on the edge that begins at the vertex @p vertex of an outline to the boundary.
  virtual Place project(const Place &on_edge, const Place & /*vertex*/) const { return on_edge; }

  /// Whether the boundary is round everywhere, so that an outline has no corners but for its edges.
  virtual bool round() const { return false; }

  /// Area without holes [m^2].
  virtual double area() const;

  /// Least and greatest signed distance from a plane, along its unit normal [m].
  virtual std::pair<double, double> distances_from_plane(const Place &point,
                                                         const dealii::Tensor<1, 2> &normal) const;

  /// Distance of @p p to the boundary, positive inside [m].
  virtual double depth(const Place &p) const;

  /// The corners when the boundary is one polygon; else a fine outline without holes. Counter-clockwise.
  virtual Polygon corners() const;

  /// A place in the body, for a first look at formulas.
  virtual Place some_place() const { return corners().front(); }

  /// Writes what makes this shape a different one when seen from @p center, for keys.
  virtual void describe(std::ostream &out, const Place &center) const;

  /// Every number that places and shapes it: two are the same when these are.
  virtual std::vector<double> numbers() const;

  /// Lower left and upper right corner of the box around it [m].
  std::pair<Place, Place> bounding_box() const;

  /// Length of the diagonal of that box [m].
  double size() const;
};

template <>
Registry<Shape<2>> &Registry<Shape<2>>::instance();

/// Whether the shapes share more than a seam of width @p tolerance [m]; what lies in the hole of a ring does
/// not.
bool overlap(const Shape<2> &a, const Shape<2> &b, double tolerance);
} // namespace softgrain

#endif
