// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Dynamics that meets obstacles.
#include <softgrain/bpm/dynamics.h>

#include <algorithm>

namespace softgrain::bpm
{
using Vector = dealii::Tensor<1, 2>;

void Dynamics::collect_obstacles(const std::size_t n_walls)
{
  obstacle_rows.clear();
  rows.wall_slip.clear();
  // Rows and memory run through walls, pieces and primaries in order.
  std::size_t remembered = 0;
  std::uint32_t surface = n_walls;
  for (std::uint32_t o = 0; o < obstacles->size(); ++o)
    for (std::size_t k = 0; k < (*obstacles)[o].description.pieces.size(); ++k)
      meet(o, k, surface++, n_walls, remembered);
}

void Dynamics::meet(const std::uint32_t o,
                    const std::size_t k,
                    const std::uint32_t surface,
                    const std::size_t n_walls,
                    std::size_t &remembered)
{
  const Obstacle &obstacle = (*obstacles)[o];
  const std::vector<Curve> &pieces = obstacle.description.pieces;
  const double far = contact_reach() * diameter;
  for (std::uint32_t i = 0; i < primaries.size(); ++i)
  {
    if (inverse_mass[i] == 0.)
      continue;
    const std::array<double, 2> &x = primaries.position[i];
    const dealii::Point<2> center(x[0], x[1]), drawn = obstacle.now.drawn(center);
    const dealii::Point<2> touched = pieces[k].foot(drawn).place;
    const Vector arm = center - obstacle.now.placed(touched);
    const double distance = arm.norm(), opening = distance - primaries.radius[i];
    if (opening > far)
      continue;
    // In a corner both pieces have the same nearest place: it is one contact.
    if (k > 0 && touched == pieces[k].begin() && pieces[k - 1].foot(drawn).place == touched)
      continue;
    // A centre on the line has no side; any one gets it away.
    const Vector normal = distance > 0. ? arm / distance : Vector({0., 1.});
    const std::array<double, 2> n = {normal[0], normal[1]}, &v = primaries.velocity[i];
    const Vector own = obstacle.way.velocity(touched);
    if (!closes({v[0] - own[0], v[1] - own[1]}, n, opening))
      continue;
    while (remembered < remembered_at_walls.size() &&
           (remembered_at_walls[remembered].wall < surface ||
            (remembered_at_walls[remembered].wall == surface && remembered_at_walls[remembered].primary < i)))
      ++remembered;
    const bool known = remembered < remembered_at_walls.size() &&
                       remembered_at_walls[remembered].wall == surface &&
                       remembered_at_walls[remembered].primary == i;
    resize_rows(rows.size() + 1);
    set_row(rows.size() - 1, i, primaries.size() + n_walls + o, n, opening, obstacle.description.friction,
            primaries.radius[i] * settings.rolling_resistance,
            known ? remembered_at_walls[remembered].impulse : contact::PairMemory::Impulses{});
    obstacle_rows.push_back({o, surface, touched});
  }
}

Vector Dynamics::obstacle_velocity(const std::size_t row) const
{
  const ObstacleRow &at = obstacle_rows[row - (rows.size() - obstacle_rows.size())];
  return (*obstacles)[at.obstacle].way.velocity(at.drawn);
}

void Dynamics::drive_obstacles(const std::size_t n_walls)
{
  const std::size_t n = primaries.size();
  for (std::size_t o = 0; o < obstacles->size(); ++o)
  {
    bodies.velocity[n + n_walls + o] = {0., 0.};
    bodies.inverse_mass[n + n_walls + o] = 0.;
    if (rotations)
      bodies.angular_velocity[n + n_walls + o] = (*obstacles)[o].way.spin();
  }
  // Places of one obstacle have velocities of their own: rows hold them.
  const std::size_t first = rows.size() - obstacle_rows.size();
  if (rotations && !obstacle_rows.empty())
    rows.wall_slip.assign(rows.size(), 0.);
  for (std::size_t k = 0; k < obstacle_rows.size(); ++k)
  {
    ObstacleRow &row = obstacle_rows[k];
    const Vector v = obstacle_velocity(first + k);
    const std::array<double, 2> &normal = rows.normal[first + k];
    rows.gap_velocity[first + k] -= normal[0] * v[0] + normal[1] * v[1];
    row.slip = normal[0] * v[1] - normal[1] * v[0];
    if (rotations)
      rows.wall_slip[first + k] = row.slip;
  }
}

void Dynamics::move_obstacles(const double dt, DynamicsReport &report)
{
  for (Obstacle &obstacle : *obstacles)
    obstacle.arrive();
  const std::size_t first = rows.size() - obstacle_rows.size();
  for (std::size_t k = 0; k < obstacle_rows.size(); ++k)
  {
    Obstacle &obstacle = (*obstacles)[obstacle_rows[k].obstacle];
    const std::array<double, 2> &normal = rows.normal[first + k];
    const double tangential = rotations ? rows.tangential_impulse[first + k] : 0.;
    const Vector given({normal[0] * rows.impulse[first + k] - normal[1] * tangential,
                        normal[1] * rows.impulse[first + k] + normal[0] * tangential});
    obstacle.give(given, obstacle.now.placed(obstacle_rows[k].drawn), dt);
    report.wall_impulse += given;
    double work = given * obstacle.way.velocity(obstacle_rows[k].drawn);
    if (!rows.rolling_impulse.empty())
      work += rows.rolling_impulse[first + k] * obstacle.way.spin();
    obstacle.work += work;
    report.wall_work += work;
    report.contact_loss += work;
  }
}
} // namespace softgrain::bpm
