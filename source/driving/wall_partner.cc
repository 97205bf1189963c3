// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/wall_partner.h>

#include <cmath>

namespace softgrain
{
dealii::Tensor<1, 2> working_velocity(const Wall<2> &wall, const bool balanced)
{
  return balanced ? wall.velocity() : prescribed_velocity_of(wall);
}

WallPartner::WallPartner(Wall<2> &wall, const WallRates &rates, const double dt, const bool balanced)
    : wall(wall), force_before(wall.book.force), dt(dt), balanced(balanced)
{
  wall.book.force = 0.;
  wall.speed = rates.speed;
  wall.slide_speed = rates.slide;
}

void WallPartner::take(const PartnerImpulse<2> &impulse)
{
  const dealii::Tensor<1, 2> given = impulse.given();
  wall.book.give(given, impulse.dt);
  wall.book.work += given * working_velocity(wall, balanced);
}

void WallPartner::book_mean(std::vector<DrivenWork> &works)
{
  double change = 0.5 * dt * wall.speed * (wall.book.force - force_before) * wall.description.normal;
  if (wall.slide_speed != 0.)
    change += 0.5 * dt * wall.slide_speed * (wall.book.force - force_before) * wall.tangent();
  wall.book.work += change;
  works.push_back({&wall.book.work, std::abs(change)});
}
} // namespace softgrain
