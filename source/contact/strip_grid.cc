// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/strip_grid.h>

#include <cmath>

namespace softgrain::contact
{
StripGrid::StripGrid(const std::array<double, 2> &lower_corner,
                     const std::array<double, 2> &upper,
                     const std::size_t n_disks,
                     const double size)
    : lower(lower_corner), cell(size)
{
  // A few disks that fly away must not make the grid larger than memory.
  const double most = 4. * n_disks + 1024.;
  while ((upper[0] - lower[0]) / cell * ((upper[1] - lower[1]) / cell) > most)
    cell *= 1.5;
  n_columns = static_cast<std::size_t>((upper[0] - lower[0]) / cell) + 1;
  n_rows = static_cast<std::size_t>((upper[1] - lower[1]) / cell) + 1;
  const double per_column = static_cast<double>(n_disks) / n_columns;
  width = std::max<std::size_t>(1, std::lround(disks_per_strip / per_column));
}
} // namespace softgrain::contact
