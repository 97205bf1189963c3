// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_wall_partner_h
#define softgrain_driving_wall_partner_h

#include <softgrain/driving/rigid_partner.h>
#include <softgrain/driving/wall_freedom.h>

#include <vector>

namespace softgrain
{
/// The part of the velocity of a wall with which its contacts do work, not its load [m/s]. @param balanced of
/// a step from balance to balance, where loads are in balance with contacts
dealii::Tensor<1, 2> working_velocity(const Wall<2> &wall, bool balanced);

/// What loads on wall @p w as its drive asks for it at a time [N/m]; nothing where it is told how to go.
dealii::Tensor<1, 2> load_at(const std::vector<Wall<2>> &walls, std::size_t w, double time);

/**
 * @brief A wall of the plane in the books of a step.
 *
 * A load does all of its work as soon as it acts, whatever the bodies bear: they push back with less before
 * the first step that meets it, and in steps that are held on the way to balance.
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

  void take(const PartnerImpulse<2> &impulse) override;
  void book_mean(std::vector<DrivenWork> &works) override;
  double book_load() override;

private:
  Wall<2> &wall;
  const dealii::Tensor<1, 2> force_before, load_before; ///< of bodies, and from outside [N/m]
  const double dt;                                      ///< [s]
  const bool balanced;
  double beside_mean = 0.; ///< what it could have done more than its mean, where it is free [J/m]
};
} // namespace softgrain

#endif
