// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Dynamics that meets obstacles.
#include <softgrain/bpm/dynamics.h>
#include <softgrain/driving/obstacle_partner.h>

#include <algorithm>

namespace softgrain::bpm
{
using Vector = dealii::Tensor<1, 2>;

void Dynamics::set_obstacles(std::vector<Obstacle<2>> *list)
{
  obstacles = list;
  feet.reset();
  if (list != nullptr)
    feet.emplace(*list);
}

void Dynamics::collect_obstacles(const std::size_t n_walls)
{
  obstacle_rows.clear();
  rows.wall_slip.clear();
  std::vector<std::uint32_t> first_surface(1, n_walls);
  for (std::size_t o = 0; o < obstacles->size(); ++o)
    first_surface.push_back(first_surface.back() + feet->n_pieces(o));
  for (const ObstacleFeet::Foot &foot :
       feet->find(primaries.position, primaries.radius, contact_reach() * diameter))
  {
    const std::uint32_t o = foot.obstacle, i = foot.disk, surface = first_surface[o] + foot.piece;
    const Obstacle<2> &obstacle = (*obstacles)[o];
    const std::array<double, 2> n = {foot.normal[0], foot.normal[1]}, &v = primaries.velocity[i];
    const Vector own = obstacle.way.velocity(foot.drawn);
    if (inverse_mass[i] == 0. || !closes({v[0] - own[0], v[1] - own[1]}, n, foot.gap))
      continue;
    resize_rows(rows.size() + 1);
    set_row(rows.size() - 1, i, primaries.size() + n_walls + o, n, foot.gap, obstacle.description.friction,
            primaries.radius[i] * settings.rolling_resistance,
            remembered_at(surface, i, first_surface[o], first_surface[o + 1]));
    obstacle_rows.push_back({o, surface, foot.drawn});
  }
}

contact::PairMemory::Impulses Dynamics::remembered_at(const std::uint32_t surface,
                                                      const std::uint32_t primary,
                                                      const std::uint32_t first,
                                                      const std::uint32_t end) const
{
  const std::uint32_t n = end - first, k = surface - first;
  // A primary that has come from the piece beside brings along what it remembers.
  for (const std::uint32_t at : {surface, first + (k + n - 1) % n, first + (k + 1) % n})
  {
    const auto found =
        std::lower_bound(remembered.at_walls.begin(), remembered.at_walls.end(), std::make_pair(at, primary),
                         [](const WallMemory &memory, const std::pair<std::uint32_t, std::uint32_t> &wanted)
                         { return std::make_pair(memory.wall, memory.primary) < wanted; });
    if (found != remembered.at_walls.end() && found->wall == at && found->primary == primary)
      return found->impulse;
  }
  return {};
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
  std::vector<ObstaclePartner<2>> partners;
  for (Obstacle<2> &obstacle : *obstacles)
    partners.emplace_back(obstacle, false);
  const std::size_t first = rows.size() - obstacle_rows.size();
  for (std::size_t k = 0; k < obstacle_rows.size(); ++k)
  {
    const Obstacle<2> &obstacle = (*obstacles)[obstacle_rows[k].obstacle];
    const std::array<double, 2> &normal = rows.normal[first + k];
    const double tangential = rotations ? rows.tangential_impulse[first + k] : 0.;
    const Vector given({normal[0] * rows.impulse[first + k] - normal[1] * tangential,
                        normal[1] * rows.impulse[first + k] + normal[0] * tangential});
    const dealii::Point<2> &drawn = obstacle_rows[k].drawn;
    const double work = partners[obstacle_rows[k].obstacle].take(
        {given, 1., 1., obstacle.now.placed(drawn), obstacle.way.velocity(drawn), dt,
         rows.rolling_impulse.empty() ? 0. : rows.rolling_impulse[first + k]});
    report.wall_impulse += given;
    report.wall_work += work;
    report.contact_loss += work;
  }
  for (ObstaclePartner<2> &partner : partners)
    partner.go_on();
}
} // namespace softgrain::bpm
