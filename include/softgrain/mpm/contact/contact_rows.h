// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_contact_rows_h
#define softgrain_mpm_contact_contact_rows_h

#include <softgrain/geometry/periodic_cell.h>
#include <softgrain/mpm/contact/wall_motion.h>
#include <softgrain/mpm/field/body_field.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace softgrain::mpm
{
/// What nodes of body and partner have to do with the places of a row; none of a partner that is driven or a
/// wall, nor of bodies whose weights are not known here. Apart, since rows are many and go from hand to hand.
struct RowWeights
{
  std::shared_ptr<const NodeWeights> body, partner;
};

/// What both sides of a row do to each other.
struct RowLaw
{
  double friction = 0; ///< coefficient
  double adhesion = 0; ///< strength of the pair [N/m^2]
  /// How much a change of its force in a step closes its gap and lets its places slide, beside what the
  /// bodies yield [m^2/N].
  double softness = 0;
  double pull = 0; ///< cohesive force over the step, as its impulses count forces [N/m]
};

/// The work of a row beside that of its impulse on the way by which its places part.
struct WorkBeyond
{
  double work = 0; ///< [J/m]
  double pull = 0; ///< what adhesion does of this [J/m]
};

/// Where a row is in a cell that repeats.
template <int dim>
struct RowInCell
{
  /// The way to the centre of the body from that of the image it meets, or from the wall, at the start of the
  /// step. The cell moves both apart by gradient * branch [m].
  dealii::Tensor<1, dim> branch;
  /// Image of the partner that the body meets, as if no body had been brought into the cell.
  typename PeriodicCell<dim>::Image image{};
  /// Copy of the cell that the body would be in, as if no body had been brought into the cell: the place of
  /// the row is where it is in the cell itself.
  typename PeriodicCell<dim>::Image fold{};
};

/// One place where a body may touch another body or a wall: w = H v, one normal and dim - 1 tangential
/// components.
template <int dim>
struct ContactRow
{
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  unsigned int body = none;    ///< feels +impulse
  unsigned int partner = none; ///< feels -impulse; none when it is a plane wall
  unsigned int wall =
      none; ///< the wall on the other side, plane or made of points; obstacles follow the walls
  RowWeights weights;
  dealii::Point<dim> place;      ///< [m]
  dealii::Tensor<1, dim> normal; ///< unit, from partner or wall to body
  double gap = 0;                ///< at the start of the step [m]
  double length = 0;             ///< of the boundary it stands for [m]
  RowLaw law;
  WorkBeyond beyond;
  /// Velocity of the place it meets, mean over the step, of a partner whose places have their own [m/s].
  std::optional<dealii::Tensor<1, dim>> velocity_of_place;
  std::uint64_t key = 0; ///< names the pair from step to step, for warm starts
  RowInCell<dim> cell;
};

/// Unit vector of a component of a row: its normal, then its tangents. In the plane that is the normal turned
/// by -90 degrees.
template <int dim>
dealii::Tensor<1, dim> direction_of(const ContactRow<dim> &row, const unsigned int component)
{
  const dealii::Tensor<1, dim> &normal = row.normal;
  if (component == 0)
    return normal;
  dealii::Tensor<1, dim> t;
  if constexpr (dim == 2)
  {
    t[0] = normal[1];
    t[1] = -normal[0];
  }
  else
  {
    // Any pair of unit vectors will do, as long as it is the same at every call.
    dealii::Tensor<1, dim> axis;
    axis[std::abs(normal[0]) < 0.7 ? 0 : 1] = 1.;
    t = dealii::cross_product_3d(normal, axis);
    t /= t.norm();
    if (component == 2)
      t = dealii::cross_product_3d(normal, t);
  }
  return t;
}
} // namespace softgrain::mpm

#endif
