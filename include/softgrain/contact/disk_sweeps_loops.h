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

template <unsigned int n, bool in_cell>
template <class Work>
void DiskSweeps<n, in_cell>::interleave(const Range range, const Work &work)
{
  const std::uint32_t length = (range.last - range.first + disk_lanes - 1) / disk_lanes;
  std::uint32_t row = range.first;
  for (std::uint32_t i = 0; i < length; ++i)
    for (std::uint32_t contact = range.first + i; contact < range.last; contact += length)
      work(row++, contact);
}

template <unsigned int n, bool in_cell>
template <class Work>
void DiskSweeps<n, in_cell>::for_ranges(const Work &work)
{
  if (in_cell && cell.is_free())
  {
    for (std::uint32_t i = 0; i < ranges.size(); ++i)
      work(ranges[i], i + 1 == ranges.size(), i);
    return;
  }
  std::uint32_t first = 0;
  for (const std::uint32_t end : colour_end)
  {
    team.run(end - first, [&](const std::uint32_t i) { work(ranges[first + i], false, first + i); });
    first = end;
  }
  work(ranges.back(), true, ranges.size() - 1);
}

template <unsigned int n, bool in_cell>
template <class Work>
void DiskSweeps<n, in_cell>::for_ranges_at_once(const Work &work)
{
  team.run(ranges.size(), [&](const std::uint32_t i) { work(ranges[i], i + 1 == ranges.size(), i); });
}

template <unsigned int n, bool in_cell>
template <class Work>
void DiskSweeps<n, in_cell>::for_bodies(const Work &work)
{
  const std::uint32_t n_pieces = (n_bodies() + disk_bodies_per_piece - 1) / disk_bodies_per_piece;
  team.run(n_pieces,
           [&](const std::uint32_t piece)
           {
             const std::size_t end = std::min<std::size_t>(n_bodies(), (piece + 1) * disk_bodies_per_piece);
             for (std::size_t i = piece * disk_bodies_per_piece; i < end; ++i)
               work(i);
           });
}
} // namespace softgrain::contact

#endif
