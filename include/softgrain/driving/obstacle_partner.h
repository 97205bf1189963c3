// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_obstacle_partner_h
#define softgrain_driving_obstacle_partner_h

#include <softgrain/driving/obstacle.h>
#include <softgrain/driving/rigid_partner.h>

namespace softgrain
{
/// Books what an obstacle does in a step from balance to balance: the work of the mean of both ends.
/// @param force,torque that it felt at the start
template <int dim>
void book_obstacle(Obstacle<dim> &obstacle,
                   const dealii::Tensor<1, dim> &force,
                   double torque,
                   std::vector<DrivenWork> &works);

/// An obstacle in the books of a step.
template <int dim>
class ObstaclePartner : public RigidPartner<dim>
{
public:
  /// It arrives where its way ends. @param balanced whether the step leads from balance to balance
  ObstaclePartner(Obstacle<dim> &obstacle, bool balanced);

  double take(const PartnerImpulse<dim> &impulse) override;
  void book_mean(std::vector<DrivenWork> &works) override;
  void go_on() override { obstacle.go_on(); }

private:
  Obstacle<dim> &obstacle;
  const dealii::Tensor<1, dim> force_before; ///< [N/m^(3-dim)]
  const double torque_before;                ///< [N m/m^(3-dim)]
  const bool balanced;
};
} // namespace softgrain

#endif
