// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/fine_cells.h>

namespace softgrain::contact
{
FineCells::FineCells(const std::vector<std::array<double, 2>> &positions,
                     std::vector<std::uint32_t> members,
                     const StripGrid &strip_grid,
                     const double cells_in_one)
    : grid(&strip_grid), factor(cells_in_one)
{
  std::size_t n_buckets = 16;
  while (n_buckets < 2 * members.size())
    n_buckets *= 2;
  mask = n_buckets - 1;
  std::vector<std::uint32_t> place(members.size());
  std::vector<Cell> cell_of(members.size());
  start.assign(n_buckets + 1, 0);
  for (std::size_t k = 0; k < members.size(); ++k)
  {
    cell_of[k] = cell(positions[members[k]]);
    place[k] = bucket(cell_of[k]);
    ++start[place[k] + 1];
  }
  for (std::size_t b = 1; b < start.size(); ++b)
    start[b] += start[b - 1];
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  disks.resize(members.size());
  cells.resize(members.size());
  for (std::size_t k = 0; k < members.size(); ++k)
  {
    const std::uint32_t to = next[place[k]]++;
    disks[to] = members[k];
    cells[to] = cell_of[k];
  }
}
} // namespace softgrain::contact
