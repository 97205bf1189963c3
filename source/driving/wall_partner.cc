// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/wall_partner.h>

#include <cmath>

namespace softgrain
{
dealii::Tensor<1, 2> working_velocity(const Wall<2> &wall, const bool balanced)
{
  return balanced ? wall.velocity() : prescribed_velocity_of(wall);
}

dealii::Tensor<1, 2> load_at(const std::vector<Wall<2>> &walls, const std::size_t w, const double time)
{
  const Wall<2> &wall = walls[w];
  dealii::Tensor<1, 2> load;
  for (const Freedom direction : freedoms_of(wall))
  {
    // What follows the stress beside it is approached, and comes from what it was.
    const bool approached = direction == Freedom::across && wall.description.drive->looks_beside();
    const double stress =
        approached ? wall.free.pressure_before : asked_stress(walls, w, direction, time, 0.);
    load += pressed_length(walls, w) * stress * way_of(wall, direction);
  }
  return load;
}

WallPartner::WallPartner(Wall<2> &wall,
                         const WallRates &rates,
                         const double dt,
                         const bool balanced,
                         const dealii::Tensor<1, 2> &load_at_start)
    : wall(wall), force_before(wall.book.force), load_before(load_at_start), dt(dt), balanced(balanced)
{
  wall.book.force = 0.;
  wall.speed = rates.speed;
  wall.slide_speed = rates.slide;
}

double WallPartner::take(const PartnerImpulse<2> &impulse)
{
  const dealii::Tensor<1, 2> given = impulse.given();
  wall.book.give(given, impulse.dt);
  const double work = given * working_velocity(wall, balanced);
  wall.book.work += work;
  return work;
}

void WallPartner::book_mean(std::vector<DrivenWork> &works)
{
  double change = 0.5 * dt * wall.speed * (wall.book.force - force_before) * wall.description.normal;
  if (wall.slide_speed != 0.)
    change += 0.5 * dt * wall.slide_speed * (wall.book.force - force_before) * wall.tangent();
  wall.book.work += change;
  works.push_back({is_free(wall) ? &beside_mean : &wall.book.work, std::abs(change)});
}

double WallPartner::book_load()
{
  if (!is_free(wall))
    return 0.;
  dealii::Tensor<1, 2> way, load = load_before;
  for (const Freedom direction : freedoms_of(wall))
  {
    way += dt * speed_of(wall, direction) * way_of(wall, direction);
    load += load_on(wall, direction).force * way_of(wall, direction);
  }
  const double lost = 0.5 * way * (load + force_before + wall.book.force) - beside_mean;
  wall.book.work += beside_mean + lost;
  return lost;
}
} // namespace softgrain
