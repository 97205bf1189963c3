// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_moved_boundary_h
#define softgrain_mpm_contact_moved_boundary_h

#include <softgrain/driving/cell_motion.h>
#include <softgrain/driving/obstacle.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/contact/contact_rows.h>

#include <deal.II/base/bounding_box.h>

#include <array>
#include <vector>

namespace softgrain::mpm
{
/// Largest way of a contact marker of @p body for a displacement of its nodes [m]; nodes on the rim may go
/// far and move nothing.
template <int dim>
double largest_way(const Body<dim> &body, const Eigen::VectorXd &displacement);

/// Outlines in a step, for a look at what they do to each other.
struct OutlineScene
{
  const std::vector<Body<2>> &bodies;
  const std::vector<dealii::Tensor<1, 2>> &drive; ///< of driven bodies in the step, one per body [m/s]
  const std::vector<WallMotion<2>> &walls;
  double dt;                                     ///< of the step [s]
  double cell_size;                              ///< [m]
  const std::vector<Eigen::VectorXd> &increment; ///< displacement of the nodes over the step, by body [m]
  double share;                                  ///< where in the step outlines are: 0 its start, 1 its end
  const std::vector<Obstacle<2>> *obstacles = nullptr; ///< with their way in the step; null: none
  const CellMotion<2> *cell = nullptr;                 ///< null: nothing repeats
  const BodyShare *looking = nullptr;                  ///< owned bodies are looked at; null: all are
};

/**
 * @brief The boundary of a body at some share of a step: its markers, and how they move.
 */
class MovedBoundary
{
public:
  using Point = dealii::Point<2>;
  using Vector = dealii::Tensor<1, 2>;

  MovedBoundary() = default;
  MovedBoundary(const Body<2> &body, const OutlineScene &scene);

  /// What tells whether anything may meet it: of a boundary that another owner has moved.
  using Sketch = std::array<double, 11>;
  Sketch sketch() const;
  /// A boundary without markers, as its sketch has it.
  MovedBoundary(const Body<2> &body, const Sketch &sketch);
  bool has_markers() const { return !position.empty(); }
  /// Gives such a one its markers, which go as the owner that has moved it tells: two numbers each [m].
  void take_markers(const OutlineScene &scene, const double *displacements);
  /// What it tells of itself for that.
  const std::vector<Vector> &marker_displacements() const { return displacement; }

  const Boundary<2> &boundary() const { return body->boundary; }
  const std::vector<Point> &markers() const { return position; }

  dealii::BoundingBox<2> box() const { return {{lower, upper}}; }

  /// Becomes its image that lies @p way from it at the start of the step and moves against it by @p moves
  /// over the step [m]. @param share where in the step it is
  void shift(const Vector &way, const Vector &moves, double share);

  Point center;      ///< of mass [m]
  Point start;       ///< where that is at the start of the step, in a cell that repeats [m]
  Vector travel;     ///< of the centre over the whole step [m]
  double spread = 0; ///< largest displacement of a contact marker against that of the centre [m]

private:
  void find_center(const OutlineScene &scene);
  void find_displacements(const OutlineScene &scene);
  void move_markers(const OutlineScene &scene);

  const Body<2> *body = nullptr;
  std::vector<Point> position;
  std::vector<Vector> displacement;
  Point lower, upper;
};
} // namespace softgrain::mpm

#endif
