// SPDX-License-Identifier: LGPL-2.1-or-later
// How DiskSweeps lays out bodies and contacts, and what it gives back.
#include <softgrain/contact/disk_sweeps_loops.h>

#include <algorithm>
#include <limits>

namespace softgrain::contact
{
namespace
{
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
} // namespace

template <unsigned int n, bool in_cell, int dim>
DiskSweeps<n, in_cell, dim>::DiskSweeps(const Bodies &bodies,
                                        const Contacts &contacts,
                                        ThreadTeam &team,
                                        const Exchange *const exchange,
                                        const DiskExchanges *const exchanges)
    : bodies(bodies), contacts(contacts), team(team), rows(new Row[contacts.size()])
{
  number_bodies(exchanges);
  make_ranges();
  if (exchanges != nullptr)
  {
    n_walls = exchanges->n_walls;
    share.emplace(*exchange, *exchanges, packed_of, n_bodies(), ranges);
  }
  else if (ranges.size() > 1 && exchange != nullptr && !bodies.cell.is_free())
    share.emplace(*exchange, contacts, packed_of, n_bodies(), ranges, colour_end);
  for_ranges_at_once([&](const Range range, const bool wall, std::uint32_t) { pack(range, wall); });
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::number_bodies(const DiskExchanges *const exchanges)
{
  packed_of.assign(bodies.size(), none);
  original_of.reserve(bodies.size());
  const auto meet = [&](const std::uint32_t body)
  {
    if (packed_of[body] == none)
    {
      packed_of[body] = original_of.size();
      original_of.push_back(body);
    }
  };
  for (std::size_t i = 0; i < contacts.size(); ++i)
  {
    meet(contacts.a[i]);
    meet(contacts.b[i]);
  }
  // Those that others know may have contacts there alone.
  if (exchanges != nullptr)
    for (const std::vector<DiskRound> &of_colour : exchanges->rounds)
      for (const DiskRound &round : of_colour)
        for (const auto *const list : {&round.send, &round.receive})
          for (const DiskExchange &one : *list)
            for (const std::uint32_t body : one.bodies)
              meet(body);
  states.reset(new State[n_bodies()]);
  last_velocity.reset(new std::array<double, n_velocities>[n_bodies()]);
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::make_ranges()
{
  // A tile is swept by one thread. None of them is left out, nor are two made one: the order in which
  // contacts are swept is not to depend on which tiles are here.
  const auto &tiles = contacts.tile_start;
  for (std::size_t tile = 0; tile + 1 < tiles.size(); ++tile)
    ranges.push_back({tiles[tile], tiles[tile + 1]});
  colour_end.assign(contacts.colour_start.begin() + 1, contacts.colour_start.end());
  ranges.push_back({tiles.back(), std::uint32_t(contacts.size())});
  sums.resize(ranges.size());
  approach.resize(ranges.size());

  // Walls are numbered as they appear; there are few.
  std::vector<std::uint32_t> walls;
  wall_of.resize(ranges.back().last - ranges.back().first);
  interleave(ranges.back(),
             [&](const std::uint32_t row, const std::uint32_t contact)
             {
               const auto found = std::find(walls.begin(), walls.end(), contacts.b[contact]);
               wall_of[row - ranges.back().first] = found - walls.begin();
               if (found == walls.end())
                 walls.push_back(contacts.b[contact]);
             });
  n_walls = walls.size();
}
template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::pack(const Range range, const bool wall)
{
  interleave(
      range,
      [&](const std::uint32_t packed, const std::uint32_t i)
      {
        Row &row = rows[packed];
        row.a = packed_of[contacts.a[i]];
        row.b = packed_of[contacts.b[i]];
        std::copy_n(contacts.normal[i].begin(), dim, row.normal);
        row.gap_velocity = contacts.gap_velocity[i];
        row.impulse[0] = contacts.impulse[i];
        if constexpr (n > 1)
        {
          row.friction = contacts.friction[i];
          row.arm_a = contacts.arm_a[i];
          row.arm_b = !wall ? contacts.arm_b[i] : contacts.wall_slip.empty() ? 0. : contacts.wall_slip[i];
          if constexpr (dim == 3)
            std::copy_n(contacts.tangential_impulse[i].begin(), 3, row.impulse + 1);
          else
            row.impulse[1] = contacts.tangential_impulse[i];
        }
        if constexpr (n == 3)
        {
          row.rolling = contacts.rolling[i];
          row.impulse[2] = contacts.rolling_impulse[i];
        }
        if constexpr (in_cell)
          std::copy_n(contacts.branch[i].begin(), 2, row.branch);
        // A start that is no impulse at all, or one between prescribed bodies, would stay.
        if (bodies.inverse_mass[contacts.a[i]] + bodies.inverse_mass[contacts.b[i]] == 0.)
          std::fill(row.impulse, row.impulse + n, 0.);
        Contact<false>::project(row, row.impulse);
        std::copy(row.impulse, row.impulse + n, row.previous);
      });
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::wall_impulses(std::vector<double> &wall_sums) const
{
  wall_sums.assign(n_walls, 0.);
  const Range range = ranges.back();
  for (std::uint32_t i = range.first; i < range.last; ++i)
    wall_sums[wall_of[i - range.first]] += rows[i].impulse[0];
  if (share)
    share->share_walls(wall_sums);
  if constexpr (in_cell)
    if (cell.is_free() && contacts.size() > 0)
    {
      double sum[2] = {0., 0.}, branches = 0.;
      for (std::size_t i = 0; i < contacts.size(); ++i)
      {
        branches += std::sqrt(rows[i].branch[0] * rows[i].branch[0] + rows[i].branch[1] * rows[i].branch[1]);
        for (unsigned int d = 0; d < 2; ++d)
          sum[d] += rows[i].impulse[0] * rows[i].normal[d] * rows[i].branch[d];
      }
      for (const double one : sum)
        wall_sums.push_back(branches > 0. ? one / branches * contacts.size() : 0.);
    }
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::store_impulses(Contacts &target)
{
  for_ranges_at_once(
      [&](const Range range, bool, std::uint32_t)
      {
        interleave(range,
                   [&](const std::uint32_t row, const std::uint32_t i)
                   {
                     target.impulse[i] = rows[row].impulse[0];
                     if constexpr (n == 4)
                       std::copy_n(rows[row].impulse + 1, 3, target.tangential_impulse[i].begin());
                     else if constexpr (n > 1)
                       target.tangential_impulse[i] = rows[row].impulse[1];
                     if constexpr (n == 3)
                       target.rolling_impulse[i] = rows[row].impulse[2];
                   });
      });
  if (!share || share->apart())
    return;
  share->share_contacts(target.impulse);
  if constexpr (n > 1 && dim == 2)
    share->share_contacts(target.tangential_impulse);
  if constexpr (n == 3)
    share->share_contacts(target.rolling_impulse);
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::store_velocities(Bodies &target)
{
  if (share && !share->apart())
    share->template tell_all<n_velocities>([this](const std::uint32_t body, const unsigned int c) -> double &
                                           { return velocity(body, c); });
  target.cell = cell;
  for (std::size_t i = 0; i < n_bodies(); ++i)
  {
    const std::uint32_t body = original_of[i];
    std::copy_n(states[i].velocity, dim, target.velocity[body].begin());
    if constexpr (n > 1)
      target.angular_velocity[body] = states[i].angular_velocity;
  }
}

template class DiskSweeps<1>;
template class DiskSweeps<2>;
template class DiskSweeps<3>;
template class DiskSweeps<1, true>;
template class DiskSweeps<2, true>;
template class DiskSweeps<3, true>;
template class DiskSweeps<1, false, 3>;
template class DiskSweeps<4, false, 3>;
} // namespace softgrain::contact
