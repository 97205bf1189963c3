// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/model/state.h>

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
  return any_sides(walls);
}

std::optional<CellMotion<2>> State::cell_motion(const std::vector<WallMotion<2>> &motion) const
{
  if (!repeats())
    return std::nullopt;
  return motion_of(cell_of(walls), walls,
                   [&](const Wall<2> &, const std::size_t w) { return motion[w].mean_velocity(); });
}
} // namespace softgrain::mpm
