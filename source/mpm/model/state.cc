// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/model/state.h>

#include <algorithm>

namespace softgrain::mpm
{
State::State() = default;
State::~State() = default;

void State::order_points()
{
  PointStore<2>::LevelsOfBodies levels;
  for (const Body<2> &body : bodies)
    levels.push_back(body.levels.get());
  std::vector<std::vector<BodyPoints<2>::Handle>> lists = points->by_body(levels);
  for (unsigned int b = 0; b < bodies.size(); ++b)
    bodies[b].points.renew(points->handler().get_property_pool(), std::move(lists[b]));
}

bool State::repeats() const
{
  return std::any_of(walls.begin(), walls.end(), [](const Wall<2> &wall) { return is_side_of_cell(wall); });
}

std::optional<CellMotion> State::cell_motion(const std::vector<WallMotion<2>> &motion) const
{
  if (!repeats())
    return std::nullopt;
  CellMotion cell;
  cell.cell = cell_of(walls);
  for (unsigned int w = 0; w < walls.size(); ++w)
    if (is_side_of_cell(walls[w]))
      cell.add_side(motion[w].normal, motion[w].mean_velocity());
  return cell;
}
} // namespace softgrain::mpm
