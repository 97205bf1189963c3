// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/obstacle_partner.h>

#include <cmath>

namespace softgrain
{
template <int dim>
void book_obstacle(Obstacle<dim> &obstacle,
                   const dealii::Tensor<1, dim> &force,
                   const double torque,
                   std::vector<DrivenWork> &works)
{
  const ObstacleMotion<dim> &way = obstacle.way;
  if (way.dt == 0.)
    return;
  const dealii::Tensor<1, dim> shift = way.end.shift - way.start.shift;
  const double angle = way.end.angle - way.start.angle;
  obstacle.work -= 0.5 * (force + obstacle.force) * shift + 0.5 * (torque + obstacle.torque) * angle;
  works.push_back({&obstacle.work,
                   0.5 * std::abs((obstacle.force - force) * shift + (obstacle.torque - torque) * angle)});
}

template <int dim>
ObstaclePartner<dim>::ObstaclePartner(Obstacle<dim> &obstacle, const bool balanced)
    : obstacle(obstacle), force_before(obstacle.force), torque_before(obstacle.torque), balanced(balanced)
{
  obstacle.arrive();
}

template <int dim>
double ObstaclePartner<dim>::take(const PartnerImpulse<dim> &impulse)
{
  obstacle.give(impulse.given(), impulse.place, impulse.dt);
  if (balanced)
    return 0.;
  double work = impulse.acting * (impulse.velocity * impulse.direction);
  if (impulse.moment != 0.)
    work += impulse.moment * obstacle.way.spin();
  obstacle.work += work;
  return work;
}

template <int dim>
void ObstaclePartner<dim>::book_mean(std::vector<DrivenWork> &works)
{
  book_obstacle(obstacle, force_before, torque_before, works);
}

template void book_obstacle(Obstacle<2> &, const dealii::Tensor<1, 2> &, double, std::vector<DrivenWork> &);
template void book_obstacle(Obstacle<3> &, const dealii::Tensor<1, 3> &, double, std::vector<DrivenWork> &);
template class ObstaclePartner<2>;
} // namespace softgrain
