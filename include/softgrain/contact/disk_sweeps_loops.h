// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_disk_sweeps_loops_h
#define softgrain_contact_disk_sweeps_loops_h

// The loops of DiskSweeps, for its own sources.
#include <softgrain/contact/disk_sweeps.h>

#include <algorithm>
#include <cstdint>

namespace softgrain::contact
{
/// Bodies that one thread extrapolates before it takes the next piece.
constexpr std::uint32_t disk_bodies_per_piece = 2048;

/// Parts of a range that take turns.
constexpr std::uint32_t disk_lanes = 4;

template <unsigned int n, bool in_cell, int dim>
template <class Work>
void DiskSweeps<n, in_cell, dim>::interleave(const Range range, const Work &work)
{
  const std::uint32_t length = (range.last - range.first + disk_lanes - 1) / disk_lanes;
  std::uint32_t row = range.first;
  for (std::uint32_t i = 0; i < length; ++i)
    for (std::uint32_t contact = range.first + i; contact < range.last; contact += length)
      work(row++, contact);
}

template <unsigned int n, bool in_cell, int dim>
template <class Work>
void DiskSweeps<n, in_cell, dim>::run(const std::pair<std::uint32_t, std::uint32_t> some, const Work &work)
{
  const std::uint32_t first = some.first, walls = ranges.size() - 1;
  team.run(some.second - first,
           [&](const std::uint32_t i) { work(ranges[first + i], first + i == walls, first + i); });
}

template <unsigned int n, bool in_cell, int dim>
template <class Work>
void DiskSweeps<n, in_cell, dim>::for_ranges(const Work &work)
{
  if (in_cell && cell.is_free())
  {
    for (std::uint32_t i = 0; i < ranges.size(); ++i)
      work(ranges[i], i + 1 == ranges.size(), i);
    return;
  }
  if (share)
  {
    for (std::size_t colour = 0; colour < share->n_colours(); ++colour)
    {
      run(share->own_ranges(colour), work);
      share->template tell<n_velocities>(colour,
                                         [this](const std::uint32_t body, const unsigned int c) -> double &
                                         { return velocity(body, c); });
    }
    return;
  }
  std::uint32_t first = 0;
  for (const std::uint32_t end : colour_end)
  {
    run({first, end}, work);
    first = end;
  }
  run({first, first + 1}, work);
}

template <unsigned int n, bool in_cell, int dim>
template <class Work>
void DiskSweeps<n, in_cell, dim>::for_ranges_at_once(const Work &work)
{
  if (!share)
    run({0, ranges.size()}, work);
  else
    for (std::size_t colour = 0; colour < share->n_colours(); ++colour)
      run(share->own_ranges(colour), work);
}

template <unsigned int n, bool in_cell, int dim>
template <class Work>
void DiskSweeps<n, in_cell, dim>::for_bodies(const Work &work)
{
  const auto in_pieces = [&](const std::size_t number, const auto &one)
  {
    const std::uint32_t n_pieces = (number + disk_bodies_per_piece - 1) / disk_bodies_per_piece;
    team.run(n_pieces,
             [&](const std::uint32_t piece)
             {
               const std::size_t end = std::min<std::size_t>(number, (piece + 1) * disk_bodies_per_piece);
               for (std::size_t i = piece * disk_bodies_per_piece; i < end; ++i)
                 one(i);
             });
  };
  if (!share)
    return in_pieces(n_bodies(), work);
  const std::vector<std::uint32_t> &own = share->own_bodies();
  in_pieces(own.size(), [&](const std::size_t i) { work(own[i]); });
}
} // namespace softgrain::contact

#endif
