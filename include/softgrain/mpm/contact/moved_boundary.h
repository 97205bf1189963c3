// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_moved_boundary_h
#define softgrain_mpm_contact_moved_boundary_h

#include <softgrain/mpm/contact/contact_geometry.h>

#include <deal.II/base/bounding_box.h>

#include <array>
#include <utility>
#include <vector>

namespace softgrain::mpm
{
/// `a` and `b` blended: (1 - share) a + share b; both are in the order of their nodes.
NodeWeights blend(const NodeWeightsView &a, const NodeWeightsView &b, double share);

/// What nodes of @p body have to do with the place @p share of the way from a marker to the next.
NodeWeights weights_on_outline(const Body<2> &body, unsigned int marker, double share);

/// Largest way of a contact marker of @p body for a displacement of its nodes [m]; nodes on the rim may go
/// far and move nothing.
double largest_way(const Body<2> &body, const Eigen::VectorXd &displacement);

/**
 * @brief The boundary of a body at some share of a step, as a curve.
 *
 * Between two markers the curve is the cubic whose ends have the normals of the markers, so that bodies
 * touch where round outlines are and not where chords are, and normals are those of the curve; at a corner it
 * is straight. A place on a loop is
 * told by a parameter: the number of a marker plus a number that grows from 0 to 1 on the way to the next
 * one. The length of curve per parameter does not jump at a marker, also where its two neighbours are not
 * equally far from it. If it did, the gap of a place that slides past the marker would change at another rate
 * from there on, and searches for contact rows would go to and fro between two sets of rows.
 */
class MovedBoundary
{
public:
  using Point = dealii::Point<2>;
  using Vector = dealii::Tensor<1, 2>;

  MovedBoundary() = default;
  MovedBoundary(const Body<2> &body, const ContactScene<2> &scene);

  /// What tells whether anything may meet it: of a boundary that another rank has moved.
  using Sketch = std::array<double, 13>;
  Sketch sketch() const;
  /// A boundary without markers, as its sketch has it.
  MovedBoundary(const Body<2> &body, const Sketch &sketch);
  bool has_markers() const { return !position.empty(); }
  /// Gives such a one its markers, which go as the rank that has moved it tells: two numbers each [m].
  void take_markers(const ContactScene<2> &scene, const double *displacements);
  /// What it tells of itself for that.
  const std::vector<Vector> &marker_displacements() const { return displacement; }

  /// A place on the curve.
  struct Place
  {
    Point position;      ///< [m]
    Vector normal;       ///< unit, outward
    double speed = 0;    ///< length of curve per marker [m]
    Vector displacement; ///< over the whole step [m]
  };

  const Boundary<2> &boundary() const { return body->boundary; }
  unsigned int n_markers() const { return position.size(); }
  const Point &marker(const unsigned int m) const { return position[m]; }
  const std::vector<Point> &markers() const { return position; }
  const Vector &normal(const unsigned int m) const { return normals[m]; }

  /// The place @p share of the way from marker @p m to the next.
  Place place(unsigned int m, double share) const;
  /// The place of a parameter on the only loop of a smooth boundary; any number, the loop is closed.
  Place place(double parameter) const;
  /// Whether that is a corner.
  bool at_corner(unsigned int m, double share) const
  {
    return (share == 0. && body->boundary.corner[m]) ||
           (share == 1. && body->boundary.corner[body->boundary.next(m)]);
  }
  /// What nodes have to do with it; empty for a driven body.
  NodeWeights weights(unsigned int m, double share) const;
  NodeWeights weights(double parameter) const;
  /// Position at a parameter, alone [m].
  Point position_at(double parameter) const;
  /// Where the ray from the centre along @p direction leaves a smooth boundary; its parameter.
  double facing(const Vector &direction) const;

  /// Whether marker @p m looks for contact; not asked for places that stand in space.
  bool looks(const unsigned int m) const { return looking[m] != 0; }
  /// How many markers further the next one that looks is, @p after marker @p m or before it.
  unsigned int markers_to_next(unsigned int m, bool after) const;
  /// Length of boundary that the contact marker @p m stands for: half the way to those on both sides [m].
  double tributary_length(unsigned int m) const;

  dealii::BoundingBox<2> box() const { return {{lower, upper}}; }
  bool near(const Point &x, const double margin) const
  {
    return x[0] > lower[0] - margin && x[0] < upper[0] + margin && x[1] > lower[1] - margin &&
           x[1] < upper[1] + margin;
  }
  bool near_box(const Point &box_lower, const Point &box_upper, const double margin) const
  {
    return box_upper[0] > lower[0] - margin && box_lower[0] < upper[0] + margin &&
           box_upper[1] > lower[1] - margin && box_lower[1] < upper[1] + margin;
  }
  bool near(const MovedBoundary &other, const double margin) const
  {
    return near_box(other.lower, other.upper, margin);
  }

  /// Becomes its image that lies @p way from it at the start of the step and moves against it by @p moves
  /// over the step [m]. @param share where in the step it is
  void shift(const Vector &way, const Vector &moves, double share);

  /// Whether a point is inside of the outline, by the number of edges that a ray from it crosses.
  bool encloses(const Point &x) const;
  /// Distance of the nearest marker from the plane through @p point with unit @p normal, along that [m].
  double distance_from(const Point &point, const Vector &normal) const;

  /// Whether places that look for contact may stand in space: round, smooth, and ContactScene::free_places.
  bool is_free = false;
  Point center;        ///< of mass [m]
  Point start;         ///< where that is at the start of the step, in a cell that repeats [m]
  Vector travel;       ///< of the centre over the whole step [m]
  Vector nodal_travel; ///< the same by its nodes alone, without what a cell that repeats adds [m]
  double spread = 0;   ///< largest displacement of a contact marker against that of the centre [m]

  /// The place of a parameter in the configuration of the grid [m], and its unit outward normal there.
  std::pair<Point, Vector> on_grid(double parameter) const;

private:
  /// The curve from a marker to the next: its chord, and above that the cubic with these slopes at its ends.
  struct Arc
  {
    Vector chord, normal; ///< the latter unit, outward
    double length = 0, start_slope = 0, end_slope = 0;
    double height(double share) const;        ///< above the chord [m]
    double height_change(double share) const; ///< per share [m]
  };
  Arc arc(unsigned int m) const;
  /// Where on the only loop the place of a parameter is.
  struct OnSegment
  {
    unsigned int marker; ///< the one before the place
    double share;        ///< of the chord to the next marker
    double rate;         ///< change of the share per parameter
  };
  OnSegment segment(double parameter) const;
  /// Changes of the share per parameter at both ends of the chord from marker @p m to the next.
  std::pair<double, double> end_rates(unsigned int m) const;
  /// The parameter of a share of that chord.
  double parameter_of(unsigned int m, double share) const;

  void find_center(const ContactScene<2> &scene);
  void find_displacements(const ContactScene<2> &scene);
  void move_markers(const ContactScene<2> &scene);
  void find_normals();
  void find_looking(const ContactScene<2> &scene);

  const Body<2> *body = nullptr;
  std::vector<Point> position;
  std::vector<Vector> displacement, normals;
  std::vector<char> looking; ///< of every marker: whether it looks for contact
  Point lower, upper;
};
} // namespace softgrain::mpm

#endif
