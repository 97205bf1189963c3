// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Dynamics that looks at places: attraction, gaps, rows.
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/bpm/dynamics.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace softgrain::bpm
{
namespace
{
/// What a thread takes at a time where a pair is only cleared, and where a row is copied.
constexpr std::size_t pairs_to_a_piece = 65536, rows_to_a_piece = 8192;
} // namespace

/// Whether a gap [m] that parts at @p relative velocity along @p normal is nearly closed, or will be within
/// look_ahead.
bool Dynamics::closes(const std::array<double, 2> &relative,
                      const std::array<double, 2> &normal,
                      const double opening) const
{
  const double range = std::max(settings.contact_range * diameter, remembered.adhesion.reach());
  if (opening < range)
    return true;
  const double approach = -(relative[0] * normal[0] + relative[1] * normal[1]);
  return opening - settings.look_ahead * approach < range;
}

void Dynamics::attract_and_find(const std::size_t tile, AttractionBatch<2> &batch)
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
    double dx = primaries.position[a][0] - primaries.position[b][0];
    double dy = primaries.position[a][1] - primaries.position[b][1];
    if (cell)
    {
      const dealii::Tensor<1, 2> away = cell->cell.shift(list.image(pair));
      dx -= away[0];
      dy -= away[1];
    }
    const double sum = primaries.radius[a] + primaries.radius[b];
    const double square = dx * dx + dy * dy;
    const bool same = primaries.body[a] == primaries.body[b];
    if (same && cell && list.image(pair) != PeriodicCell<2>::Image())
    {
      if (square < sum * sum)
        throw ComputationError("the cell that repeats has become too small: body " +
                               std::to_string(primaries.body[a]) + " meets itself");
      continue;
    }
    const Attraction *own = same && !laws.empty() ? laws[primaries.body[a]].get() : nullptr;
    const double attraction_reach = own != nullptr ? own->range() * sum : 0.;
    const double contact_reach = sum + reach;
    const bool attracts = square < attraction_reach * attraction_reach;
    const bool near = square < contact_reach * contact_reach;
    if (!attracts && !near)
      continue;
    const double distance = std::sqrt(square);
    // Disks on top of each other have no direction; any one gets them apart.
    const std::array<double, 2> direction =
        distance > 0. ? std::array<double, 2>{dx / distance, dy / distance} : std::array<double, 2>{1., 0.};
    const std::array<double, 2> &va = primaries.velocity[a], &vb = primaries.velocity[b];
    std::array<double, 2> relative = {va[0] - vb[0], va[1] - vb[1]};
    if (near && cell)
    {
      const dealii::Tensor<1, 2> parted = cell->gradient * branch(a, b, list.image(pair));
      relative[0] += parted[0];
      relative[1] += parted[1];
    }
    if (near && inverse_mass[a] + inverse_mass[b] > 0. && closes(relative, direction, distance - sum))
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

void Dynamics::detect(const std::vector<Wall<2>> &walls)
{
  std::optional<dealii::TimerOutput::Scope> section;
  if (timer != nullptr)
    section.emplace(*timer, "neighbour list");
  see_cell(walls);
  update_list();
  if (timer != nullptr)
  {
    section.reset();
    section.emplace(*timer, "attraction");
  }
  force.assign(primaries.size(), {0., 0.});
  const std::size_t n_tiles = list.tile_start().empty() ? 0 : list.tile_start().size() - 1;
  found.resize(n_tiles);
  tile_energy.assign(n_tiles, 0.);
  for (std::size_t colour = 0; colour + 1 < list.colour_start().size(); ++colour)
  {
    const std::size_t first = list.colour_start()[colour];
    parallel_for(list.colour_start()[colour + 1] - first, 1,
                 [&](const std::size_t begin, const std::size_t end)
                 {
                   // Buffers alone: attract_and_find() clears what another tile or model has left.
                   static thread_local AttractionBatch<2> batch;
                   for (std::size_t tile = first + begin; tile < first + end; ++tile)
                     attract_and_find(tile, batch);
                 });
    if (share)
      tell_forces(colour);
  }
  if (share)
    tell_energies();
  stored_energy = 0.;
  for (const double energy : tile_energy)
    stored_energy += energy;
  if (timer != nullptr)
  {
    section.reset();
    section.emplace(*timer, "contact rows");
  }
  collect(walls);
}

void Dynamics::resize_rows(const std::size_t n)
{
  rows.a.resize(n);
  rows.b.resize(n);
  rows.normal.resize(n);
  if (cell)
    rows.branch.resize(n);
  rows.gap_velocity.resize(n);
  rows.impulse.resize(n);
  gap.resize(n);
  if (!rotations)
    return;
  rows.friction.resize(n);
  rows.arm_a.resize(n);
  rows.arm_b.resize(n);
  rows.tangential_impulse.resize(n);
  if (settings.any_rolling())
  {
    rows.rolling.resize(n);
    rows.rolling_impulse.resize(n);
  }
}

void Dynamics::set_row(const std::size_t row,
                       const std::uint32_t a,
                       const std::uint32_t b,
                       const std::array<double, 2> &normal,
                       const double opening,
                       const double friction,
                       const double rolling,
                       const contact::PairMemory::Impulses &memory)
{
  rows.a[row] = a;
  rows.b[row] = b;
  rows.normal[row] = normal;
  rows.impulse[row] = memory[0];
  gap[row] = opening;
  if (!rotations)
    return;
  rows.friction[row] = friction;
  rows.arm_a[row] = primaries.radius[a];
  rows.arm_b[row] = b < primaries.size() ? primaries.radius[b] : 0.;
  rows.tangential_impulse[row] = memory[1];
  if (!rows.rolling.empty())
  {
    rows.rolling[row] = rolling;
    rows.rolling_impulse[row] = memory[2];
  }
}

void Dynamics::collect(const std::vector<Wall<2>> &walls)
{
  rows.colour_start = list.colour_start();
  rows.tile_start.assign(1, 0);
  for (const std::vector<Found> &contacts : found)
    rows.tile_start.push_back(rows.tile_start.back() + contacts.size());
  resize_rows(rows.tile_start.back());
  pair_of_row.resize(rows.tile_start.back());
  parallel_for(
      found.size(), 1,
      [&](const std::size_t begin, const std::size_t end)
      {
        for (std::size_t tile = begin; tile < end; ++tile)
        {
          std::size_t row = rows.tile_start[tile];
          for (const Found &contact : found[tile])
          {
            const std::uint32_t a = list.a(contact.pair), b = list.b(contact.pair);
            const bool same = primaries.body[a] == primaries.body[b];
            const double ra = primaries.radius[a], rb = primaries.radius[b];
            // (2.12) with the radius that acts in a pair: harmonic mean, the disk's own against a
            // plane.
            set_row(row, a, b, contact.normal, contact.gap,
                    same || !rotations ? 0. : settings.pairs.friction(primaries.body[a], primaries.body[b]),
                    2. * ra * rb / (ra + rb) *
                        (same ? settings.inner_rolling_resistance : settings.rolling_resistance),
                    list.memory()[contact.pair]);
            if (cell)
            {
              const dealii::Tensor<1, 2> r = branch(a, b, list.image(contact.pair));
              rows.branch[row] = {{r[0], r[1]}};
            }
            pair_of_row[row++] = contact.pair;
          }
        }
      });
  if (share)
    bring_wall_rows(walls);
  else
    add_wall_rows(walls, find_at_walls(walls, 0, primaries.size()));
  if (obstacles != nullptr)
    collect_obstacles(walls.size());
  find_pulls();
  deepest = 0.;
  for (const double opening : gap)
    deepest = std::max(deepest, -opening);
  if (share)
    sum_up();
}

void Dynamics::remember()
{
  const auto impulses = [&](const std::size_t row) -> contact::PairMemory::Impulses
  {
    return {rows.impulse[row], rotations ? rows.tangential_impulse[row] : 0.,
            rows.rolling_impulse.empty() ? 0. : rows.rolling_impulse[row]};
  };
  contact::PairMemory &memory = list.memory();
  parallel_for(memory.size(), pairs_to_a_piece,
               [&](const std::size_t begin, const std::size_t end) { memory.forget(begin, end); });
  parallel_for(pair_of_row.size(), rows_to_a_piece,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t row = begin; row < end; ++row)
                   memory.set(pair_of_row[row], impulses(row));
               });
  remembered.at_walls.clear();
  const std::size_t first_at_obstacle = rows.size() - obstacle_rows.size();
  for (std::size_t row = pair_of_row.size(); row < first_at_obstacle; ++row)
    remembered.at_walls.push_back({static_cast<std::uint32_t>(rows.b[row] - primaries.size()),
                                   primaries.number_of(rows.a[row]), impulses(row)});
  for (std::size_t row = first_at_obstacle; row < rows.size(); ++row)
    remembered.at_walls.push_back(
        {obstacle_rows[row - first_at_obstacle].surface, rows.a[row], impulses(row)});
}
} // namespace softgrain::bpm
