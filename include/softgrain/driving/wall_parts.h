// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_wall_parts_h
#define softgrain_driving_wall_parts_h

#include <deal.II/base/tensor.h>

/// @file
/// What a Wall is made of beside its place and its velocity.

namespace softgrain
{
/// What is put on a wall along one direction in which it is free, and what resists it.
struct WallLoad
{
  double force = 0;   ///< from outside [N/m]
  double mass = 0;    ///< [kg/m]
  double damping = 0; ///< force against its motion, per velocity [kg/(m s)]
};

/// What moves a wall that is not told how to move.
struct FreeMotion
{
  WallLoad across;            ///< along the normal
  WallLoad along;             ///< along the tangent
  double pressure = 0;        ///< [Pa]
  double pressure_before = 0; ///< the same in the last step that was accepted [Pa]
  double usual_mass = 0;      ///< the mass if none is given [kg/m]
};

/// When a wall began to be driven as it is.
struct DriveBegin
{
  double time = 0;   ///< [s]
  double travel = 0; ///< of the wall until then [m]
};

/// What a wall has felt and given: forces are those of the bodies on the wall, impulses those of the wall on
/// the bodies, in the plane per metre of thickness.
template <int dim>
struct WallBook
{
  dealii::Tensor<1, dim> force;   ///< mean over the last step [N/m; N]
  dealii::Tensor<1, dim> impulse; ///< given since the start; in space nobody asks [N s/m]
  /// Done since the start by what drives it: a wall of prescribed velocity, or the load on a free one [J/m;
  /// J].
  double work = 0;

  /// Takes down an impulse that the wall has given to the bodies in a step of @p dt [s].
  void give(const dealii::Tensor<1, dim> &given, const double dt)
  {
    force -= given / dt;
    impulse += given;
  }
};
} // namespace softgrain

#endif
