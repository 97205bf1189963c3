// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_wall_partner_h
#define softgrain_driving_wall_partner_h

#include <softgrain/driving/rigid_partner.h>
#include <softgrain/driving/wall_freedom.h>

#include <algorithm>
#include <vector>

namespace softgrain
{
/// The part of the velocity of a wall with which its contacts do work, not its load [m/s]. @param balanced of
/// a step from balance to balance, where loads are in balance with contacts
dealii::Tensor<1, 2> working_velocity(const Wall<2> &wall, bool balanced);

/// Time at which the load of a step begins [s]. A held step completes the step before it, so its load begins
/// with that one, but not before the wall got its drive.
/// @param held length of a held step, 0 of another one [s]
template <int dim>
double begin_of_load(const Wall<dim> &wall, const double time, const double held)
{
  return std::max(time - held, wall.driven_since.time);
}

/// The load that the drive of wall @p w asks for at a time [N/m]; it has no part along directions in which
/// the wall is told how to go.
dealii::Tensor<1, 2> load_at(const std::vector<Wall<2>> &walls, std::size_t w, double time);

/**
 * @brief A wall of the plane in the books of a step.
 *
 * From balance to balance the work of a load is its mean over the step times the way of the wall. The bodies
 * may push back with less: when the load has just begun to act, and in held steps on the way to balance. What
 * they do not get is lost.
 */
class WallPartner : public RigidPartner<2>
{
public:
  /// @param rates    its velocities with which impulses do work
  /// @param dt       of the step [s]
  /// @param balanced whether the step leads from balance to balance
  /// @param load_at_start see load_at(); of a step from balance to balance
  WallPartner(Wall<2> &wall,
              const WallRates &rates,
              double dt,
              bool balanced,
              const dealii::Tensor<1, 2> &load_at_start);

  double take(const PartnerImpulse<2> &impulse) override;
  void book_mean(std::vector<DrivenWork> &works) override;
  double book_load() override;

private:
  Wall<2> &wall;
  const dealii::Tensor<1, 2> force_before, load_before; ///< of bodies, and from outside [N/m]
  const double dt;                                      ///< [s]
  const bool balanced;
  double beside_mean = 0.; ///< what bodies get beside the work of the mean force, if the wall is free [J/m]
};
} // namespace softgrain

#endif
