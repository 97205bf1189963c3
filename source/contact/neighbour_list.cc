// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/contact/neighbour_list.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace softgrain::contact
{
namespace
{
/// Disks per tile that keep a tile in the cache and leave enough tiles for all threads.
constexpr double disks_per_tile = 1000.;

/// Disks sorted by the cells of a grid whose columns are what tiles are made of.
struct CellGrid
{
  CellGrid(const std::vector<std::array<double, 2>> &positions, const double size)
  {
    std::array<double, 2> upper = positions[0];
    lower = positions[0];
    for (std::size_t i = 0; i < positions.size(); ++i)
      for (unsigned int d = 0; d < 2; ++d)
      {
        if (!std::isfinite(positions[i][d]))
          throw ComputationError("disk " + std::to_string(i) + " has no finite place");
        lower[d] = std::min(lower[d], positions[i][d]);
        upper[d] = std::max(upper[d], positions[i][d]);
      }
    // A few disks that fly away must not make the grid larger than memory.
    const double most = 4. * positions.size() + 1024.;
    cell = size;
    while ((upper[0] - lower[0]) / cell * ((upper[1] - lower[1]) / cell) > most)
      cell *= 1.5;
    n_columns = static_cast<std::size_t>((upper[0] - lower[0]) / cell) + 1;
    n_rows = static_cast<std::size_t>((upper[1] - lower[1]) / cell) + 1;
    start.assign(n_columns * n_rows + 1, 0);
    std::vector<std::uint32_t> cell_of(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      const auto column = std::min<std::size_t>((positions[i][0] - lower[0]) / cell, n_columns - 1);
      const auto row = std::min<std::size_t>((positions[i][1] - lower[1]) / cell, n_rows - 1);
      cell_of[i] = column * n_rows + row;
      ++start[cell_of[i] + 1];
    }
    for (std::size_t c = 1; c < start.size(); ++c)
      start[c] += start[c - 1];
    disks.resize(positions.size());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < positions.size(); ++i)
      disks[next[cell_of[i]]++] = i;
  }

  std::array<double, 2> lower;
  double cell;
  std::size_t n_columns, n_rows;
  std::vector<std::uint32_t> start; ///< of cells, column by column
  std::vector<std::uint32_t> disks;
};
} // namespace

NeighbourList::NeighbourList(std::vector<double> radii,
                             std::vector<std::uint32_t> groups,
                             const Range &list_range,
                             const unsigned int n_impulses)
    : radius(std::move(radii)), group(std::move(groups)), range(list_range), memories(n_impulses)
{
  if (!group.empty() && group.size() != radius.size())
    throw InputError("neighbour list: " + std::to_string(group.size()) + " groups for " +
                     std::to_string(radius.size()) + " disks");
  if (!(range.gap >= 0.) || !(range.skin > 0.) || !(range.stretch >= 0.))
    throw InputError("neighbour list: gap and stretch must not be negative, the skin must be positive");
  double largest = 0.;
  for (const double r : radius)
    largest = std::max(largest, r);
  largest_distance =
      std::max(2. * largest + range.gap, group.empty() ? 0. : range.stretch * 2. * largest) + range.skin;
}

bool NeighbourList::update(const std::vector<std::array<double, 2>> &positions)
{
  if (built_at.size() == positions.size())
  {
    const double limit = 0.25 * range.skin * range.skin;
    bool moved = false;
    for (std::size_t i = 0; i < positions.size() && !moved; ++i)
    {
      const double dx = positions[i][0] - built_at[i][0], dy = positions[i][1] - built_at[i][1];
      moved = !(dx * dx + dy * dy < limit);
    }
    if (!moved)
      return false;
  }
  build(positions);
  return true;
}

void NeighbourList::build(const std::vector<std::array<double, 2>> &positions)
{
  if (positions.size() != radius.size())
    throw InputError("neighbour list: " + std::to_string(positions.size()) + " places for " +
                     std::to_string(radius.size()) + " disks");
  const std::vector<std::uint32_t> old_first = std::move(first), old_second = std::move(second);
  const PairMemory old_memories = std::move(memories);
  first.clear();
  second.clear();
  tiles.assign(1, 0);
  colours.assign(1, 0);
  built_at = positions;
  if (positions.empty())
  {
    memories.assign(0);
    return;
  }

  const CellGrid grid(positions, largest_distance);
  const double per_column = static_cast<double>(positions.size()) / grid.n_columns;
  const std::size_t width = std::max<std::size_t>(1, std::lround(disks_per_tile / per_column));
  const std::size_t n_strips = (grid.n_columns + width - 1) / width;

  std::vector<std::vector<std::array<std::uint32_t, 2>>> found(n_strips);
  const auto search = [&](const std::size_t i, const std::size_t cell, std::size_t from, auto &pairs)
  {
    const double x = positions[i][0], y = positions[i][1], r = radius[i];
    for (std::size_t k = std::max<std::size_t>(from, grid.start[cell]); k < grid.start[cell + 1]; ++k)
    {
      const std::uint32_t j = grid.disks[k];
      const double dx = x - positions[j][0], dy = y - positions[j][1], sum = r + radius[j];
      double reach = sum + range.gap;
      if (!group.empty() && group[i] == group[j])
        reach = std::max(reach, range.stretch * sum);
      reach += range.skin;
      if (dx * dx + dy * dy < reach * reach)
        pairs.push_back({static_cast<std::uint32_t>(i), j});
    }
  };
  parallel_for(n_strips, 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t strip = begin; strip < end; ++strip)
                   for (std::size_t column = strip * width;
                        column < std::min((strip + 1) * width, grid.n_columns); ++column)
                     for (std::size_t row = 0; row < grid.n_rows; ++row)
                     {
                       const std::size_t cell = column * grid.n_rows + row;
                       for (std::size_t k = grid.start[cell]; k < grid.start[cell + 1]; ++k)
                       {
                         const std::size_t i = grid.disks[k];
                         search(i, cell, k + 1, found[strip]);
                         if (row + 1 < grid.n_rows)
                           search(i, cell + 1, 0, found[strip]);
                         if (column + 1 == grid.n_columns)
                           continue;
                         for (std::size_t other = row > 0 ? row - 1 : 0;
                              other <= std::min(row + 1, grid.n_rows - 1); ++other)
                           search(i, (column + 1) * grid.n_rows + other, 0, found[strip]);
                       }
                     }
               });

  std::size_t n = 0;
  for (const auto &pairs : found)
    n += pairs.size();
  if (n > std::numeric_limits<std::uint32_t>::max())
    throw ComputationError("neighbour list: more pairs than can be numbered");
  first.reserve(n);
  second.reserve(n);
  for (unsigned int colour = 0; colour < 2; ++colour)
  {
    for (std::size_t strip = colour; strip < n_strips; strip += 2)
    {
      for (const auto &pair : found[strip])
      {
        first.push_back(pair[0]);
        second.push_back(pair[1]);
      }
      tiles.push_back(first.size());
    }
    colours.push_back(tiles.size() - 1);
  }
  take_over_memories(old_first, old_second, old_memories);
}

void NeighbourList::take_over_memories(const std::vector<std::uint32_t> &old_first,
                                       const std::vector<std::uint32_t> &old_second,
                                       const PairMemory &old_memories)
{
  memories.assign(first.size());
  // What is remembered, sorted by the disk with the lower number: a handful of entries per disk.
  std::vector<std::uint32_t> start(radius.size() + 1, 0), entries;
  for (std::size_t pair = 0; pair < old_first.size(); ++pair)
    if (old_memories.remembers(pair))
      ++start[std::min(old_first[pair], old_second[pair]) + 1];
  for (std::size_t i = 1; i < start.size(); ++i)
    start[i] += start[i - 1];
  entries.resize(start.back());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::size_t pair = 0; pair < old_first.size(); ++pair)
    if (old_memories.remembers(pair))
      entries[next[std::min(old_first[pair], old_second[pair])]++] = pair;
  for (std::size_t pair = 0; pair < first.size(); ++pair)
  {
    const std::uint32_t low = std::min(first[pair], second[pair]), high = std::max(first[pair], second[pair]);
    for (std::uint32_t k = start[low]; k < start[low + 1]; ++k)
      if (std::max(old_first[entries[k]], old_second[entries[k]]) == high)
      {
        // Impulses are scalars along n, t and the axis: the same whichever disk comes first.
        memories.set(pair, old_memories[entries[k]]);
        break;
      }
  }
}
} // namespace softgrain::contact
