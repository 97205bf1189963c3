// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_snapshot_cell_h
#define softgrain_analysis_snapshot_cell_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/geometry/periodic_cell.h>

#include <vector>

namespace softgrain
{
/// The cell between those of the walls that are sides of one; it does not repeat when there are none.
template <int dim>
PeriodicCell<dim> cell_of(const std::vector<WallState<dim>> &walls)
{
  std::vector<CellSide<dim>> sides;
  double offset = 0.;
  for (const WallState<dim> &wall : walls)
    if (wall.repeats)
    {
      sides.push_back({wall.point, wall.normal});
      offset = wall.offset;
    }
  return make_cell(sides, offset);
}
} // namespace softgrain

#endif
