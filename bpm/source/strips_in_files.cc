// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of StripShare that brings what ranks have to files and back, piece by piece.
#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/strip_share.h>

#include <algorithm>

namespace softgrain::bpm
{
void StripShare::bring_rows(const double *const values,
                            const std::size_t n,
                            const Primaries &disks,
                            const std::size_t begin,
                            const std::size_t end,
                            double *const rows) const
{
  std::fill(rows, rows + (end - begin) * n, 0.);
  const auto first = disks.number.begin(), own_end = first + n_own_primaries;
  for (auto i = std::lower_bound(first, own_end, begin); i != own_end && *i < end; ++i)
    std::copy_n(values + (i - first) * n, n, rows + (*i - begin) * n);
  exchange.join_at_first(rows, (end - begin) * n);
}

StripShare::TileRows StripShare::rows_of_tiles(const std::size_t n_first, const std::size_t n) const
{
  TileRows rows;
  rows.here = {{0, n_first, n}};
  const std::vector<std::vector<double>> sizes =
      exchange.of_all({static_cast<double>(n_first), static_cast<double>(n - n_first)});
  for (unsigned int colour = 0; colour < 2; ++colour)
    for (unsigned int r = 0; r < exchange.number(); ++r)
    {
      if (r == exchange.here())
        rows.there[colour] = rows.n_all;
      rows.n_all += static_cast<std::size_t>(sizes[r][colour]);
    }
  return rows;
}

void StripShare::bring_tiles(const std::vector<double> &values,
                             const std::size_t width,
                             const TileRows &tiles,
                             const std::size_t begin,
                             const std::size_t end,
                             double *const rows) const
{
  std::fill(rows, rows + (end - begin) * width, 0.);
  tiles.among(begin, end,
              [&](const std::size_t here, const std::size_t row, const std::size_t n)
              { std::copy_n(values.data() + here * width, n * width, rows + (row - begin) * width); });
  exchange.join_at_first(rows, (end - begin) * width);
}

void StripShare::take_tiles(const StateReader &in,
                            const std::string &name,
                            contact::NeighbourList &list) const
{
  contact::PairMemory &memory = list.memory();
  const std::size_t width = memory.n_impulses();
  const TileRows tiles = rows_of_tiles(list.tile_start()[list.colour_start()[1]], memory.size());
  in.read_rows(name, tiles.n_all, width,
               [&](const std::size_t begin, const std::size_t end, const double *const rows)
               {
                 tiles.among(begin, end,
                             [&](const std::size_t here, const std::size_t row, const std::size_t n) {
                               std::copy_n(rows + (row - begin) * width, n * width,
                                           memory.values().data() + here * width);
                             });
               });
}
} // namespace softgrain::bpm
