// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of BallDynamics that looks at places: attraction, gaps, rows.
#include <softgrain/base/parallel.h>
#include <softgrain/bpm/ball_dynamics.h>
#include <softgrain/bpm/timed_section.h>

#include <algorithm>
#include <cmath>

namespace softgrain::bpm
{
double BallDynamics::contact_reach() const
{
  return settings.reach();
}

/// Whether a gap [m] that parts at @p relative velocity along @p normal is nearly closed, or will be within
/// look_ahead.
bool BallDynamics::closes(const Vector &relative, const Vector &normal, const double opening) const
{
  const double range = settings.contact_range * diameter;
  if (opening < range)
    return true;
  const double approach = -(relative[0] * normal[0] + relative[1] * normal[1] + relative[2] * normal[2]);
  return opening - settings.look_ahead * approach < range;
}

void BallDynamics::attract_and_find(const std::size_t tile, AttractionBatch<3> &batch)
{
  const double reach = contact_reach() * diameter;
  std::vector<Found> &contacts = found[tile];
  contacts.clear();
  batch.clear();
  double energy = 0.;
  // Pairs of one law follow each other mostly; a batch ends where the law changes.
  const Attraction *law = nullptr;
  for (std::uint32_t pair = list.tile_start()[tile]; pair < list.tile_start()[tile + 1]; ++pair)
  {
    const std::uint32_t a = list.a(pair), b = list.b(pair);
    const Vector &xa = primaries.position[a], &xb = primaries.position[b];
    Vector direction = {xa[0] - xb[0], xa[1] - xb[1], xa[2] - xb[2]};
    const double sum = primaries.radius[a] + primaries.radius[b];
    const double square =
        direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2];
    const bool same = primaries.body[a] == primaries.body[b];
    const Attraction *own = same && !laws.empty() ? laws[primaries.body[a]].get() : nullptr;
    const double attraction_reach = own != nullptr ? own->range() * sum : 0.;
    const bool attracts = square < attraction_reach * attraction_reach,
               near = square < (sum + reach) * (sum + reach);
    if (!attracts && !near)
      continue;
    const double distance = std::sqrt(square);
    // Balls on top of each other have no direction; any one gets them apart.
    if (distance > 0.)
      for (double &component : direction)
        component /= distance;
    else
      direction = {1., 0., 0.};
    const Vector &va = primaries.velocity[a], &vb = primaries.velocity[b];
    if (near && closes({va[0] - vb[0], va[1] - vb[1], va[2] - vb[2]}, direction, distance - sum))
      contacts.push_back({pair, distance - sum, direction});
    if (attracts)
    {
      if (own != law)
        batch.finish(law, primaries.strength, force, energy);
      law = own;
      batch.add(a, b, distance, sum, direction);
    }
  }
  batch.finish(law, primaries.strength, force, energy);
  tile_energy[tile] = energy;
}

void BallDynamics::detect(const Walls &walls)
{
  {
    const TimedSection section(timer, "neighbour list");
    n_lists += list.update(primaries.position);
  }
  {
    const TimedSection section(timer, "attraction");
    force.assign(primaries.size(), Vector{});
    found.resize(list.n_tiles());
    tile_energy.assign(list.n_tiles(), 0.);
    for (std::size_t colour = 0; colour + 1 < list.colour_start().size(); ++colour)
    {
      const std::size_t first = list.colour_start()[colour];
      parallel_for(list.colour_start()[colour + 1] - first, 1,
                   [&](const std::size_t begin, const std::size_t end)
                   {
                     // Buffers alone: what another tile or model has left is cleared.
                     static thread_local AttractionBatch<3> batch;
                     for (std::size_t tile = first + begin; tile < first + end; ++tile)
                       attract_and_find(tile, batch);
                   });
    }
    stored_energy = 0.;
    for (const double energy : tile_energy)
      stored_energy += energy;
  }
  const TimedSection section(timer, "contact rows");
  collect(walls);
}

void BallDynamics::resize_rows(const std::size_t n)
{
  rows.a.resize(n);
  rows.b.resize(n);
  rows.normal.resize(n);
  rows.gap_velocity.resize(n);
  rows.impulse.resize(n);
  gap.resize(n);
  if (!rotations)
    return;
  rows.friction.resize(n);
  rows.arm_a.resize(n);
  rows.arm_b.resize(n);
  rows.tangential_impulse.resize(n);
}

void BallDynamics::set_row(const std::size_t row,
                           const std::uint32_t a,
                           const std::uint32_t b,
                           const Vector &normal,
                           const double opening,
                           const double friction,
                           const double *const memory)
{
  rows.a[row] = a;
  rows.b[row] = b;
  rows.normal[row] = normal;
  rows.impulse[row] = memory[0];
  gap[row] = opening;
  if (!rotations)
    return;
  rows.friction[row] = friction;
  // Friction acts in the middle of a gap: arms that are together as long as the branch keep angular momentum.
  const bool pair = b < primaries.size();
  rows.arm_a[row] = primaries.radius[a] + (pair ? 0.5 * opening : 0.);
  rows.arm_b[row] = pair ? primaries.radius[b] + 0.5 * opening : 0.;
  std::copy_n(memory + 1, 3, rows.tangential_impulse[row].begin());
}

void BallDynamics::collect(const Walls &walls)
{
  rows.colour_start = list.colour_start();
  rows.tile_start.assign(1, 0);
  for (const std::vector<Found> &contacts : found)
    rows.tile_start.push_back(rows.tile_start.back() + contacts.size());
  resize_rows(rows.tile_start.back());
  pair_of_row.resize(rows.tile_start.back());
  parallel_for(found.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t tile = begin; tile < end; ++tile)
                 {
                   std::size_t row = rows.tile_start[tile];
                   for (const Found &contact : found[tile])
                   {
                     const std::uint32_t a = list.a(contact.pair), b = list.b(contact.pair);
                     const std::uint32_t of_a = primaries.body[a], of_b = primaries.body[b];
                     set_row(row, a, b, contact.normal, contact.gap,
                             of_a == of_b || !rotations ? 0. : settings.pairs.friction(of_a, of_b),
                             list.memory(contact.pair));
                     pair_of_row[row++] = contact.pair;
                   }
                 }
               });
  add_wall_rows(walls);
  deepest = 0.;
  for (const double opening : gap)
    deepest = std::max(deepest, -opening);
}

void BallDynamics::add_wall_rows(const Walls &walls)
{
  struct AtWall
  {
    std::uint32_t wall, ball;
    double gap;
  };
  std::vector<AtWall> at_walls;
  const double reach = contact_reach() * diameter;
  for (std::uint32_t w = 0; w < walls.size(); ++w)
  {
    const dealii::Point<3> point = walls[w].point();
    const dealii::Tensor<1, 3> n = walls[w].normal();
    const Vector normal = {n[0], n[1], n[2]};
    for (std::uint32_t i = 0; i < primaries.size(); ++i)
    {
      const Vector &x = primaries.position[i], &v = primaries.velocity[i];
      const double opening = (x[0] - point[0]) * n[0] + (x[1] - point[1]) * n[1] + (x[2] - point[2]) * n[2] -
                             primaries.radius[i];
      if (opening < reach &&
          closes({v[0] - walls[w].speed * n[0], v[1] - walls[w].speed * n[1], v[2] - walls[w].speed * n[2]},
                 normal, opening))
        at_walls.push_back({w, i, opening});
    }
  }
  const std::size_t first = rows.tile_start.back();
  resize_rows(first + at_walls.size());
  auto old = remembered_at_walls.begin();
  for (std::size_t k = 0; k < at_walls.size(); ++k)
  {
    const auto &[wall, ball, opening] = at_walls[k];
    const auto earlier = [wall = wall, ball = ball](const WallMemory &memory)
    { return memory.wall < wall || (memory.wall == wall && memory.ball < ball); };
    while (old != remembered_at_walls.end() && earlier(*old))
      ++old;
    const bool known = old != remembered_at_walls.end() && old->wall == wall && old->ball == ball;
    const std::array<double, 4> nothing{};
    const dealii::Tensor<1, 3> &n = walls[wall].normal();
    set_row(first + k, ball, primaries.size() + wall, {n[0], n[1], n[2]}, opening,
            rotations ? settings.pairs.friction_at_wall(primaries.body[ball], wall) : 0.,
            known ? old->impulse.data() : nothing.data());
  }
}
} // namespace softgrain::bpm
