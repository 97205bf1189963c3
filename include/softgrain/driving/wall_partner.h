// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_wall_partner_h
#define softgrain_driving_wall_partner_h

#include <softgrain/driving/rigid_partner.h>
#include <softgrain/driving/wall_freedom.h>

namespace softgrain
{
/// The part of the velocity of a wall with which its contacts do work, not its load [m/s]. @param balanced of
/// a step from balance to balance, where loads are in balance with contacts
dealii::Tensor<1, 2> working_velocity(const Wall<2> &wall, bool balanced);

/// A wall of the plane in the books of a step.
class WallPartner : public RigidPartner<2>
{
public:
  /// @param rates    its velocities with which impulses do work
  /// @param dt       of the step [s]
  /// @param balanced whether the step leads from balance to balance
  WallPartner(Wall<2> &wall, const WallRates &rates, double dt, bool balanced);

  void take(const PartnerImpulse<2> &impulse) override;
  void book_mean(std::vector<DrivenWork> &works) override;

private:
  Wall<2> &wall;
  const dealii::Tensor<1, 2> force_before; ///< [N/m]
  const double dt;                         ///< [s]
  const bool balanced;
};
} // namespace softgrain

#endif
