// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_strips_in_files_h
#define softgrain_bpm_strips_in_files_h

#include <softgrain/bpm/strip_share.h>
#include <softgrain/model/state_file.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

/// @file
/// What owners of strips have goes to files and back piece by piece. All bring rows of a list of all, from
/// `begin` to `end`, to the first one.

namespace softgrain::bpm
{
/// Brings @p n numbers of every primary, by number; @p values are those here.
void bring_rows(const StripShare &share,
                const double *values,
                std::size_t n,
                const Primaries &disks,
                std::size_t begin,
                std::size_t end,
                double *rows);

/// Where rows of the tiles here stand in the list of all: of each colour, those from one row here to another,
/// and the first of them there.
struct TileRows
{
  std::size_t n_all = 0;
  std::array<std::size_t, 3> here{};
  std::array<std::size_t, 2> there{};

  /// Calls @p work for those of them that are among the rows from @p begin to @p end of all: the first one
  /// here, the same in the list of all, and how many follow.
  template <class Work>
  void among(const std::size_t begin, const std::size_t end, const Work &work) const
  {
    for (unsigned int colour = 0; colour < 2; ++colour)
    {
      const std::size_t first = std::max(begin, there[colour]),
                        last = std::min(end, there[colour] + here[colour + 1] - here[colour]);
      if (first < last)
        work(here[colour] + first - there[colour], first, last - first);
    }
  }
};

/// Places in the list of all of @p n rows here, ordered by tiles; @p n_first have the first colour.
TileRows rows_of_tiles(const Exchange &exchange, std::size_t n_first, std::size_t n);

/// Brings @p width numbers of each of these rows.
void bring_tiles(const Exchange &exchange,
                 const std::vector<double> &values,
                 std::size_t width,
                 const TileRows &tiles,
                 std::size_t begin,
                 std::size_t end,
                 double *rows);

/// Takes what the pairs of @p list remember from the list of all in a state.
void take_tiles(const Exchange &exchange,
                const StateReader &in,
                const std::string &name,
                contact::NeighbourList &list);

/// Gathers numbers of all tiles at the first one, in the order of one process. @p values are those of the
/// tiles here, of which the first @p n_first belong to the first colour.
std::vector<double>
tiles_at_first(const Exchange &exchange, const std::vector<double> &values, std::size_t n_first);
} // namespace softgrain::bpm

#endif
