// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/strips_in_files.h>

#include <algorithm>

namespace softgrain::bpm
{
void bring_rows(const StripShare &share,
                const double *const values,
                const std::size_t n,
                const Primaries &disks,
                const std::size_t begin,
                const std::size_t end,
                double *const rows)
{
  std::fill(rows, rows + (end - begin) * n, 0.);
  const auto first = disks.number.begin(), own_end = first + share.n_own();
  for (auto i = std::lower_bound(first, own_end, begin); i != own_end && *i < end; ++i)
    std::copy_n(values + (i - first) * n, n, rows + (*i - begin) * n);
  share.exchange.join_at_first(rows, (end - begin) * n);
}

TileRows rows_of_tiles(const Exchange &exchange, const std::size_t n_first, const std::size_t n)
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

void bring_tiles(const Exchange &exchange,
                 const std::vector<double> &values,
                 const std::size_t width,
                 const TileRows &tiles,
                 const std::size_t begin,
                 const std::size_t end,
                 double *const rows)
{
  std::fill(rows, rows + (end - begin) * width, 0.);
  tiles.among(begin, end,
              [&](const std::size_t here, const std::size_t row, const std::size_t n)
              { std::copy_n(values.data() + here * width, n * width, rows + (row - begin) * width); });
  exchange.join_at_first(rows, (end - begin) * width);
}

void take_tiles(const Exchange &exchange,
                const StateReader &in,
                const std::string &name,
                contact::NeighbourList &list)
{
  contact::PairMemory &memory = list.memory();
  const std::size_t width = memory.n_impulses();
  const TileRows tiles = rows_of_tiles(exchange, list.tile_start()[list.colour_start()[1]], memory.size());
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

std::vector<double>
tiles_at_first(const Exchange &exchange, const std::vector<double> &values, const std::size_t n_first)
{
  const double size = values.size(), of_first = n_first;
  const std::vector<std::vector<double>> sizes = exchange.of_all({of_first, size - of_first});
  std::vector<double> all;
  if (exchange.first())
  {
    double sum = 0.;
    for (const std::vector<double> &one : sizes)
      sum += one[0] + one[1];
    all.resize(static_cast<std::size_t>(sum));
  }
  std::vector<Exchange::Piece> pieces;
  double *place = all.data();
  for (unsigned int colour = 0; colour < 2; ++colour)
    for (unsigned int r = 0; r < exchange.number(); ++r)
    {
      const auto n = static_cast<std::size_t>(sizes[r][colour]);
      double *const here = const_cast<double *>(values.data()) + (colour > 0 ? n_first : 0); // is only sent
      if (exchange.first() && r == 0)
        std::copy_n(here, n, place);
      pieces.push_back({r, exchange.first() ? place : here, n});
      place += exchange.first() ? n : 0;
    }
  exchange.bring(pieces);
  return all;
}
} // namespace softgrain::bpm
