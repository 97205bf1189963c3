// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/driven_work.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
template <int dim>
void book_obstacle(Obstacle<dim> &obstacle,
                   const dealii::Tensor<1, dim> &force,
                   const double torque,
                   std::vector<DrivenWork> &driven)
{
  const ObstacleMotion<dim> &way = obstacle.way;
  if (way.dt == 0.)
    return;
  const dealii::Tensor<1, dim> shift = way.end.shift - way.start.shift;
  const double angle = way.end.angle - way.start.angle;
  obstacle.work -= 0.5 * (force + obstacle.force) * shift + 0.5 * (torque + obstacle.torque) * angle;
  driven.push_back({&obstacle.work,
                    0.5 * std::abs((obstacle.force - force) * shift + (obstacle.torque - torque) * angle)});
}

template void book_obstacle(Obstacle<2> &, const dealii::Tensor<1, 2> &, double, std::vector<DrivenWork> &);
template void book_obstacle(Obstacle<3> &, const dealii::Tensor<1, 3> &, double, std::vector<DrivenWork> &);

double give_kinks(const ContactKinks &kinks, const std::vector<DrivenWork> &driven)
{
  double most = 0.;
  for (const DrivenWork &one : driven)
    most += one.most;
  if (most == 0. || kinks.all() == 0.)
    return 0.;
  const double given = std::clamp(kinks.all(), -most, most);
  for (const DrivenWork &one : driven)
    *one.work += given * one.most / most;
  return given / kinks.all();
}
} // namespace softgrain::mpm
