// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_cell_motion_h
#define softgrain_driving_cell_motion_h

#include <softgrain/driving/wall_freedom.h>
#include <softgrain/geometry/periodic_cell.h>

#include <vector>

namespace softgrain
{
/**
 * @brief A cell that repeats at the start of a step, and how it deforms over it: homogeneously, so that its
 * sides move as they are driven.
 *
 * Bodies follow as wholes: each is taken along with velocity(centre of its mass), not strained. Velocities in
 * the models are those beside this one (peculiar). An image that lies n cells away is taken along at
 * velocity(x + shift(n)), so all copies of the cell are alike however fast it deforms; the price is the
 * force -m L U on a body of mass m and peculiar velocity U, L being the gradient
 * (Evans and Morriss, Phys. Rev. A 30, 1984, SLLOD).
 */
template <int dim>
struct CellMotion
{
  PeriodicCell<dim> cell;
  dealii::Tensor<2, dim> gradient; ///< of the velocity [1/s]
  dealii::Tensor<1, dim> drift;    ///< velocity of the lower corner [m/s]

  bool deforms() const { return gradient.norm_square() > 0. || drift.norm_square() > 0.; }

  /// Velocity that the cell gives a body with its centre at @p x [m/s].
  dealii::Tensor<1, dim> velocity(const dealii::Point<dim> &x) const
  {
    return drift + gradient * (x - cell.lower);
  }

  /// A side moves: adds its velocity [m/s].
  void add_side(const dealii::Tensor<1, dim> &normal, const dealii::Tensor<1, dim> &velocity);

  /// The gradient as places have it that the cell has taken along for a step of @p dt [1/s].
  dealii::Tensor<2, dim> gradient_after(double dt) const;

  /// The offset of the cell above after a step of @p dt [m].
  double offset_after(double dt) const
  {
    return cell.offset + dt * (gradient * cell.shift(PeriodicCell<dim>::above()))[0];
  }
};

/// What a step of @p dt in which a cell deforms changes of the velocities of a body, which from then on are
/// those beside the cell as it is after the step: so all its copies stay alike.
template <int dim>
class MeasuredAgain
{
public:
  MeasuredAgain(const CellMotion<dim> &cell, const double dt) : gradient(cell.gradient_after(dt)), dt(dt) {}

  /// @param momentum of the body beside the cell as it was [N s/m; N s in space] @return change of all its
  /// velocities [m/s]
  dealii::Tensor<1, dim> change(const double mass, const dealii::Tensor<1, dim> &momentum) const
  {
    return -dt / mass * (gradient * momentum);
  }

private:
  const dealii::Tensor<2, dim> gradient;
  const double dt;
};

/// The cell between the walls that are sides of one; it does not repeat when there are none.
template <int dim>
PeriodicCell<dim> cell_of(const std::vector<Wall<dim>> &walls);

/// The force of the bodies on a side of the cell. @param normal of the side, into the cell
/// @param virial as of load_sides()
template <int dim>
dealii::Tensor<1, dim> force_on_side(const PeriodicCell<dim> &cell,
                                     const dealii::Tensor<1, dim> &normal,
                                     const dealii::Tensor<2, dim> &virial)
{
  return -1. / cell.length[axis_of(normal)] * (virial * normal);
}

/// Length of the cell across wall @p w; 0 where that is no side of one [m].
double length_across(const std::vector<Wall<2>> &walls, std::size_t w);

/// Puts the forces through its sides on them. @param virial sum over contacts of the force on a body times
/// the branch vector to its centre from that of its partner [N; N m in space]
template <int dim>
void load_sides(std::vector<Wall<dim>> &walls,
                const PeriodicCell<dim> &cell,
                const dealii::Tensor<2, dim> &virial);

/// How @p cell deforms where every one of its sides has velocity_of(side, number) [m/s].
template <int dim, class Velocity>
CellMotion<dim>
motion_of(const PeriodicCell<dim> &cell, const std::vector<Wall<dim>> &walls, const Velocity &velocity_of)
{
  CellMotion<dim> motion;
  motion.cell = cell;
  for_sides(walls, [&](const Wall<dim> &side, const std::size_t w)
            { motion.add_side(side.normal(), velocity_of(side, w)); });
  return motion;
}
} // namespace softgrain

#endif
