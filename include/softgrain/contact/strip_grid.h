// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_strip_grid_h
#define softgrain_contact_strip_grid_h

#include <algorithm>
#include <array>
#include <cstddef>

namespace softgrain::contact
{
/// Cells in which disks look for their neighbours, and the vertical strips of some columns of cells that make
/// the tiles of a NeighbourList.
struct StripGrid
{
  /// Disks per strip that keep it in the cache and leave enough strips for all threads.
  static constexpr double disks_per_strip = 1000.;

  StripGrid() = default;

  /**
   * @param lower,upper least and largest coordinates of the disks [m]
   * @param n_disks their number
   * @param size of a cell at least [m]
   */
  StripGrid(const std::array<double, 2> &lower,
            const std::array<double, 2> &upper,
            std::size_t n_disks,
            double size);

  std::size_t column(const std::array<double, 2> &x) const { return index(x, 0, n_columns); }
  std::size_t row(const std::array<double, 2> &x) const { return index(x, 1, n_rows); }
  std::size_t strip(const std::array<double, 2> &x) const { return column(x) / width; }
  std::size_t n_strips() const { return (n_columns + width - 1) / width; }

  std::array<double, 2> lower{};
  double cell = 1.; ///< [m]
  std::size_t n_columns = 0, n_rows = 0;
  std::size_t width = 1; ///< columns of a strip

private:
  std::size_t index(const std::array<double, 2> &x, const unsigned int d, const std::size_t n) const
  {
    return std::min<std::size_t>((x[d] - lower[d]) / cell, n - 1);
  }
};
} // namespace softgrain::contact

#endif
