// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/bpm/gathered_primaries.h>
#include <softgrain/bpm/strips_in_files.h>

#include <algorithm>

namespace softgrain::bpm
{
namespace
{
std::vector<std::array<double, 2>> pairs_of(const std::vector<double> &numbers)
{
  std::vector<std::array<double, 2>> pairs(numbers.size() / 2);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    pairs[i] = {numbers[2 * i], numbers[2 * i + 1]};
  return pairs;
}
} // namespace

GatheredPrimaries::GatheredPrimaries(const Dynamics &dynamics) : dynamics(dynamics)
{
  if (dynamics.strips() == nullptr)
    return;
  gathered.emplace();
  gather_disks();
  gather_rows();
  gather_bonds();
}

void GatheredPrimaries::gather_disks()
{
  const Primaries &here = dynamics.disks();
  const StripShare &share = *dynamics.strips();
  const auto bring = [&](const std::vector<double> &values)
  { return share.at_first(values.data(), 1, here); };
  const auto bring_pairs = [&](const std::vector<std::array<double, 2>> &values)
  { return pairs_of(share.at_first(values.data()->data(), 2, here)); };
  Primaries &all = gathered->disks;
  all.position = bring_pairs(here.position);
  all.velocity = bring_pairs(here.velocity);
  all.radius = bring(here.radius);
  all.mass = bring(here.mass);
  const std::vector<double> body = bring(std::vector<double>(here.body.begin(), here.body.end()));
  all.body.assign(body.begin(), body.end());
  if (share.carried().spins)
    all.angular_velocity = bring(here.angular_velocity);
}

void GatheredPrimaries::gather_rows()
{
  constexpr unsigned int n = 7;
  const PresentContacts present = dynamics.present();
  const contact::DiskContacts &here = present.rows();
  const Primaries &disks = dynamics.disks();
  const StripShare &share = *dynamics.strips();
  const std::uint32_t first_wall = share.n_all();
  std::vector<double> numbers, at_walls;
  std::size_t n_first = 0;
  const std::uint32_t first_end = here.tile_start[here.colour_start[1]], tiles_end = here.tile_start.back();
  for (std::size_t row = 0; row < here.size(); ++row)
  {
    if (present.carries_force(row))
    {
      const std::uint32_t b = here.b[row];
      std::vector<double> &list = row < tiles_end ? numbers : at_walls;
      list.insert(list.end(),
                  {static_cast<double>(disks.number[here.a[row]]),
                   static_cast<double>(b < disks.size() ? disks.number[b] : first_wall + (b - disks.size())),
                   here.normal[row][0], here.normal[row][1], present.gaps()[row], here.impulse[row],
                   share.carried().spins ? here.tangential_impulse[row] : 0.});
    }
    if (row < first_end)
      n_first = numbers.size();
  }
  std::vector<double> all = tiles_at_first(share.exchange, numbers, n_first);
  all.insert(all.end(), at_walls.begin(), at_walls.end()); // only the first owner has any
  contact::DiskContacts &rows = gathered->rows;
  for (std::size_t k = 0; k < all.size(); k += n)
  {
    rows.a.push_back(static_cast<std::uint32_t>(all[k]));
    rows.b.push_back(static_cast<std::uint32_t>(all[k + 1]));
    rows.normal.push_back({all[k + 2], all[k + 3]});
    gathered->gap.push_back(all[k + 4]);
    rows.impulse.push_back(all[k + 5]);
    if (share.carried().spins)
      rows.tangential_impulse.push_back(all[k + 6]);
  }
}

void GatheredPrimaries::gather_bonds()
{
  constexpr unsigned int n = 4;
  const contact::NeighbourList &list = dynamics.present().neighbours();
  const std::vector<std::uint32_t> &number = dynamics.disks().number;
  const std::size_t first_end = list.tile_start()[list.colour_start()[1]];
  std::vector<double> numbers;
  const auto note = [&](const Bond &bond)
  {
    numbers.insert(numbers.end(), {static_cast<double>(number[bond.a]), static_cast<double>(number[bond.b]),
                                   bond.attraction, bond.impulse});
  };
  for_bonds_here(0, first_end, note);
  const std::size_t n_first = numbers.size();
  for_bonds_here(first_end, list.n_pairs(), note);
  const std::vector<double> all = tiles_at_first(dynamics.strips()->exchange, numbers, n_first);
  for (std::size_t k = 0; k < all.size(); k += n)
    gathered->bonds.push_back(
        {static_cast<std::uint32_t>(all[k]), static_cast<std::uint32_t>(all[k + 1]), all[k + 2], all[k + 3]});
}
} // namespace softgrain::bpm
