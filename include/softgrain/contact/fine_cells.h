// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_fine_cells_h
#define softgrain_contact_fine_cells_h

#include <softgrain/contact/strip_grid.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief Small disks, sorted by parts of the cells of a StripGrid: where one large disk makes the cells
 * large, small ones look for each other in cells of their own.
 *
 * Columns of these cells do not reach over the sides of columns of the grid. Only cells that have a disk take
 * memory.
 */
class FineCells
{
public:
  using Cell = std::array<double, 2>; ///< column and row, whole numbers

  FineCells() = default;

  /// @param positions of all disks [m] @param members numbers of those that are sorted @param grid has to
  /// stay
  /// @param factor cells in a cell of @p grid, along each direction
  FineCells(const std::vector<std::array<double, 2>> &positions,
            std::vector<std::uint32_t> members,
            const StripGrid &grid,
            double factor);

  bool empty() const { return disks.empty(); }

  Cell cell(const std::array<double, 2> &x) const
  {
    return {{grid->fine_column(x, factor), grid->fine_row(x, factor)}};
  }

  /// Calls @p work for all disks in a cell, in the order of their numbers.
  template <class Work>
  void in(const Cell &cell, const Work &work) const
  {
    // Far rows come round again: they are the same numbers then, for disks that are never near.
    const std::size_t place = bucket(cell);
    for (std::uint32_t k = start[place]; k < start[place + 1]; ++k)
      if (cells[k] == cell)
        work(disks[k]);
  }

  /// The cell beside @p cell.
  static Cell beside(const Cell &cell, const int right, const int up)
  {
    return {{cell[0] + right, within_turn(cell[1] + up)}};
  }

private:
  std::size_t bucket(const Cell &cell) const
  {
    const auto whole = [](const double x)
    { return static_cast<std::uint64_t>(static_cast<std::int64_t>(x)); };
    const std::uint64_t mixed =
        (whole(cell[0]) * 0x9E3779B97F4A7C15u ^ whole(cell[1]) * 0xC2B2AE3D27D4EB4Fu) * 0xD6E8FEB86659FD93u;
    return (mixed >> 32) & mask;
  }

  const StripGrid *grid = nullptr;
  double factor = 1.;
  std::size_t mask = 0;
  std::vector<std::uint32_t> start, disks; ///< of buckets
  std::vector<Cell> cells;                 ///< of the sorted disks
};
} // namespace softgrain::contact

#endif
