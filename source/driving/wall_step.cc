// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/wall_step.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
double step_of_wall_way(const std::vector<Wall<2>> &walls,
                        const double time,
                        const double way,
                        const double shortest,
                        const double longest)
{
  const auto way_in = [&](const double dt)
  {
    double farthest = 0.;
    for (const Wall<2> &wall : walls)
      if (wall.prescribed())
        farthest = std::max(
            farthest, std::hypot(demand_of(wall, time, dt).velocity, demanded_slide(wall, time, dt)) * dt);
    return farthest;
  };
  // A wall that goes to and fro is at the same place again after a period: so from short steps to longer
  // ones.
  for (double dt = shortest; dt < longest; dt *= 2.)
  {
    const double gone = way_in(dt);
    if (gone < 0.5 * way)
      continue;
    const double step = dt * way / gone, then = way_in(step);
    return then > way ? step * way / then : step; // it may become faster
  }
  return 0.;
}
} // namespace softgrain
