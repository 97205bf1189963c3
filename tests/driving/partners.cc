// SPDX-License-Identifier: LGPL-2.1-or-later
// Walls and obstacles as rigid partners: what they feel and book of an impulse in a step whose impulses do
// work and in one from balance to balance, by which numbers they go, and how walls answer in both directions.
#include <softgrain/analysis/partner_numbers.h>
#include <softgrain/driving/obstacle_partner.h>
#include <softgrain/driving/wall_partner.h>

#include <cmath>
#include <iostream>
#include <memory>

using namespace softgrain;

namespace
{
constexpr double dt = 0.1;

/// At the top. Where it is pressed it has 2 kg/m and a damper of 3 kg/(m s).
Wall<2> plate(const std::shared_ptr<const WallDrive> &drive)
{
  Wall<2> wall;
  wall.description.normal = dealii::Point<2>(0., -1.);
  wall.description.drive = drive;
  wall.free.across.mass = 2.;
  wall.free.across.damping = 3.;
  wall.book.force = dealii::Tensor<1, 2>({0., 10.});
  return wall;
}

/// A line that goes down by 0.2 m in the step.
Obstacle<2> line()
{
  Obstacle<2> obstacle;
  obstacle.way.end.shift[1] = -0.2;
  obstacle.way.dt = dt;
  obstacle.force = dealii::Tensor<1, 2>({0., 10.});
  return obstacle;
}

/// Gives 3 N s/m downwards, at 2 m/s. @return what more it could have done
double push(RigidPartner<2> &partner, const bool balanced)
{
  PartnerImpulse<2> impulse;
  impulse.direction = impulse.velocity = dealii::Point<2>(0., -1.);
  impulse.velocity *= 2.;
  impulse.impulse = impulse.acting = 3.;
  impulse.dt = dt;
  partner.take(impulse);
  std::vector<DrivenWork> works;
  if (balanced)
    partner.book_mean(works);
  return works.empty() ? 0. : works[0].most;
}
} // namespace

int main()
{
  const auto told = make_drive("velocity", "Walls/top", {"Velocity=2"});
  const auto pressed = make_drive("pressure", "Walls/top", {"Pressure=100"});
  for (const bool balanced : {false, true})
  {
    Wall<2> wall = plate(told);
    WallPartner of_wall(wall, {2., 0.}, dt, balanced, {});
    const double more_of_wall = push(of_wall, balanced);
    Obstacle<2> obstacle = line();
    ObstaclePartner<2> of_obstacle(obstacle, balanced);
    const double more_of_obstacle = push(of_obstacle, balanced);
    std::cout << (balanced ? "from balance to balance" : "impulses do work")
              << ": force of wall and obstacle " << wall.book.force << ", " << obstacle.force << ", work "
              << wall.book.work << ", " << obstacle.work << ", could be more by " << more_of_wall << ", "
              << more_of_obstacle << '\n';
  }

  Wall<2> loaded = plate(pressed);
  loaded.free.across.force = 40.;
  WallPartner of_loaded(loaded, {2., 0.}, dt, true, 40. * loaded.normal());
  push(of_loaded, true);
  const double mean = loaded.book.work, lost = of_loaded.book_load();
  std::cout << "a load of 40 over a way of 0.2: work " << loaded.book.work << ", bodies get " << mean
            << ", lost " << lost << '\n';

  const PartnerNumbers numbers(4);
  std::cout << "wall 3 is " << (numbers.is_obstacle(3) ? "an obstacle" : "none") << ", obstacle 2 has number "
            << numbers.of_obstacle(2) << " and comes back as " << numbers.obstacle(numbers.of_obstacle(2))
            << '\n';

  for (const auto &drive : {told, pressed})
  {
    const Wall<2> wall = plate(drive);
    const WallRates rates = told_rates(wall, 0., dt);
    const WallAhead ahead = ahead_of(wall, dt, 1.);
    std::cout << freedoms_of(wall).size() << " free, told to go at " << rates.speed
              << ", an impulse of 1 changes that by " << 1. / ahead.across.mass << " and "
              << 1. / ahead.along.mass << '\n';
  }
}
