// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_moving_wall_h
#define softgrain_bpm_moving_wall_h

#include <array>

namespace softgrain::bpm
{
/// A wall as a body with one degree of freedom, along its normal; the domain lies on the side of the normal.
struct MovingWall
{
  std::array<double, 2> point{};  ///< of its plane at the start [m]
  std::array<double, 2> normal{}; ///< unit, into the domain
  double friction = 0;            ///< against primaries
  double inverse_mass = 0;        ///< [m/kg]; 0: its velocity is prescribed
  double damping = 0;             ///< force per velocity, of walls with mass [kg/(m s)]

  double travel = 0;   ///< along the normal since the start [m]
  double velocity = 0; ///< along the normal [m/s]
  double load = 0;     ///< force on it from outside, along the normal [N/m]; of walls with mass

  double normal_impulse = 0;     ///< from the primaries during the last step, against its normal [N s/m]
  double tangential_impulse = 0; ///< on the wall along (n_y, -n_x), during the last step [N s/m]
};
} // namespace softgrain::bpm

#endif
