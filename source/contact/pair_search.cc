// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/contact/pair_search.h>

#include <algorithm>

namespace softgrain::contact
{
PairSearch::PairSearch(const Disks &all,
                       const NeighbourList::Range &list_range,
                       const std::vector<double> &level_factors,
                       const NeighbourList::Part &part)
    : disks(all)
    , range(list_range)
    , factors(level_factors)
    , grid(part.grid)
    , first_strip(part.first_strip)
    , end_strip(part.end_strip)
    , first_column(part.first_strip * part.grid.width)
    , end_column(std::min(part.end_strip * part.grid.width, part.grid.n_columns))
{
  if (first_strip == end_strip)
    return;
  const std::size_t n = disks.positions.size();
  std::vector<std::vector<std::uint32_t>> members(factors.size());
  for (std::uint32_t i = 0; i < n; ++i)
  {
    members[level(disks.radius[disk(i)])].push_back(i);
  }
  sort_coarse(members[0]);
  if (members.size() == 1)
    return;
  levels.assign(n, 0);
  fine_of_strip.resize(end_strip - first_strip);
  std::vector<std::vector<std::uint32_t>> behind(end_strip - first_strip);
  fine.emplace_back();
  for (unsigned int l = 1; l < members.size(); ++l)
  {
    for (const std::uint32_t i : members[l])
      levels[i] = l;
    fine.emplace_back(disks.positions, std::move(members[l]), grid, factors[l]);
  }
  for (std::uint32_t i = 0; i < n; ++i)
    if (levels[i] > 0)
    {
      const std::size_t column = grid.column(disks.positions[i]), strip = column / grid.width;
      if (strip >= first_strip && strip < end_strip)
        fine_of_strip[strip - first_strip].push_back(i);
      // Larger ones in the strip before may be near to it.
      if (column % grid.width == 0 && strip > first_strip && strip <= end_strip)
        behind[strip - 1 - first_strip].push_back(i);
    }
  for (std::size_t s = 0; s < behind.size(); ++s)
    fine_of_strip[s].insert(fine_of_strip[s].end(), behind[s].begin(), behind[s].end());
}

unsigned int PairSearch::level(const double radius) const
{
  unsigned int l = factors.size() - 1;
  if (l > 0)
    for (const double own = range.reach(2. * radius, !disks.group.empty());
         l > 0 && own * factors[l] > grid.cell;)
      --l;
  return l;
}

void PairSearch::sort_coarse(const std::vector<std::uint32_t> &members)
{
  // The last strip reaches one column farther.
  const std::size_t end = std::min(end_column + 1, grid.n_columns);
  start.assign((end - first_column) * grid.n_rows + 1, 0);
  std::vector<std::uint32_t> cell_of(members.size());
  for (std::size_t k = 0; k < members.size(); ++k)
  {
    const std::array<double, 2> &x = disks.positions[members[k]];
    cell_of[k] = coarse_cell(grid.column(x), grid.row(x));
    ++start[cell_of[k] + 1];
  }
  for (std::size_t c = 1; c < start.size(); ++c)
    start[c] += start[c - 1];
  sorted.resize(members.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::size_t k = 0; k < members.size(); ++k)
    sorted[next[cell_of[k]]++] = members[k];
}

void PairSearch::look(const std::size_t i, const std::uint32_t j, Found &found) const
{
  const std::size_t n_disks = disks.radius.size();
  if (i >= n_disks && j >= n_disks)
    return;
  ++found.looked_at;
  const std::array<double, 2> &x = disks.positions[i], &y = disks.positions[j];
  const std::size_t a = disk(i), b = disk(j);
  const double dx = x[0] - y[0], dy = x[1] - y[1];
  const double limit = range.reach(disks.radius[a] + disks.radius[b],
                                   !disks.group.empty() && disks.group[a] == disks.group[b]);
  if (dx * dx + dy * dy < limit * limit)
    found.pairs.push_back({static_cast<std::uint32_t>(i), j});
}

void PairSearch::look_in(const std::size_t i,
                         const std::size_t cell,
                         const std::size_t from,
                         Found &found) const
{
  for (std::size_t k = std::max<std::size_t>(from, start[cell]); k < start[cell + 1]; ++k)
    look(i, sorted[k], found);
}

template <class Work>
void PairSearch::for_rows_around(const std::size_t row, const Work &work) const
{
  for (std::size_t other = row > 0 ? row - 1 : 0; other <= std::min(row + 1, grid.n_rows - 1); ++other)
    work(other);
  if (grid.wraps && (row == 0 || row + 1 == grid.n_rows))
    work(row == 0 ? grid.n_rows - 1 : 0);
}

void PairSearch::search_coarse(const std::size_t strip, Found &found) const
{
  const std::size_t n_rows = grid.n_rows;
  for (std::size_t column = strip * grid.width; column < std::min((strip + 1) * grid.width, end_column);
       ++column)
    for (std::size_t row = 0; row < n_rows; ++row)
    {
      const std::size_t cell = coarse_cell(column, row);
      for (std::size_t k = start[cell]; k < start[cell + 1]; ++k)
      {
        const std::size_t i = sorted[k];
        look_in(i, cell, k + 1, found);
        if (row + 1 < n_rows)
          look_in(i, cell + 1, 0, found);
        else if (grid.wraps)
          look_in(i, coarse_cell(column, 0), 0, found);
        if (column + 1 < grid.n_columns)
          for_rows_around(row, [&](const std::size_t other)
                          { look_in(i, coarse_cell(column + 1, other), 0, found); });
      }
    }
}

void PairSearch::search_fine(const std::size_t i, const std::size_t strip, Found &found) const
{
  const std::array<double, 2> &x = disks.positions[i];
  const std::size_t column = grid.column(x);
  const bool here = column / grid.width == strip;
  const unsigned int own = levels[i];
  if (here)
  {
    const FineCells::Cell cell = fine[own].cell(x);
    fine[own].in(cell,
                 [&](const std::uint32_t j)
                 {
                   if (j > i)
                     look(i, j, found);
                 });
    const auto all = [&](const std::uint32_t j) { look(i, j, found); };
    fine[own].in(FineCells::beside(cell, 0, 1), all);
    for (int up = -1; up <= 1; ++up)
      fine[own].in(FineCells::beside(cell, 1, up), all);
  }
  // A pair belongs to the strip that comes first.
  const auto larger = [&](const std::uint32_t j)
  {
    if (std::min(column, grid.column(disks.positions[j])) / grid.width == strip)
      look(i, j, found);
  };
  for (unsigned int l = 1; l < own; ++l)
    if (!fine[l].empty())
    {
      const FineCells::Cell cell = fine[l].cell(x);
      for (int right = -1; right <= 1; ++right)
        for (int up = -1; up <= 1; ++up)
          fine[l].in(FineCells::beside(cell, right, up), larger);
    }
  const std::size_t end = std::min(end_column + 1, grid.n_columns);
  for (std::size_t c = std::max(column, first_column + 1) - 1; c < std::min(column + 2, end); ++c)
    for_rows_around(grid.row(x),
                    [&](const std::size_t row)
                    {
                      const std::size_t cell = coarse_cell(c, row);
                      for (std::size_t k = start[cell]; k < start[cell + 1]; ++k)
                        larger(sorted[k]);
                    });
}

std::vector<std::vector<PairSearch::Pair>> PairSearch::run()
{
  std::vector<std::vector<Pair>> pairs(grid.n_strips());
  std::vector<std::uint64_t> n(grid.n_strips(), 0);
  parallel_for(end_strip - first_strip, 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t s = begin; s < end; ++s)
                 {
                   Found found;
                   search_coarse(first_strip + s, found);
                   if (!fine_of_strip.empty())
                     for (const std::uint32_t i : fine_of_strip[s])
                       search_fine(i, first_strip + s, found);
                   pairs[first_strip + s] = std::move(found.pairs);
                   n[first_strip + s] = found.looked_at;
                 }
               });
  looked_at = 0;
  for (const std::uint64_t of_strip : n)
    looked_at += of_strip;
  return pairs;
}
} // namespace softgrain::contact
