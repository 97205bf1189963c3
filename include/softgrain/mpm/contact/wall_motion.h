// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_wall_motion_h
#define softgrain_mpm_contact_wall_motion_h

#include <softgrain/geometry/wall_tangent.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace softgrain::mpm
{
/// Where a wall stands and moves during one step.
template <int dim>
struct WallMotion
{
  dealii::Point<dim> point;      ///< at the start of the step [m]
  dealii::Tensor<1, dim> normal; ///< unit, into the domain
  double velocity;    ///< mean over the step, along the normal; of a free wall as far as known [m/s]
  bool plane = true;  ///< false: it is made of material points, or a side of a cell
  double rate = 0;    ///< velocity with which its impulses do work [m/s]
  double fastest = 0; ///< largest velocity it may come to have in the step, either way [m/s]
  double slide = 0;   ///< along the tangent [m/s]

  dealii::Tensor<1, dim> tangent() const { return wall_tangent(normal); }
  /// Velocity of its places, mean over the step [m/s].
  dealii::Tensor<1, dim> mean_velocity() const { return velocity * normal + slide * tangent(); }
};
} // namespace softgrain::mpm

#endif
