// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/wall_balance.h>
#include <softgrain/driving/wall_freedom.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
double unbalanced(const std::vector<Wall<2>> &walls)
{
  double largest = 0.;
  const auto look = [&largest](const double load, const double force)
  {
    const double left_over = std::abs(load + force);
    largest = std::max(largest, left_over > 0. ? left_over / std::abs(load) : 0.);
  };
  for (const Wall<2> &wall : walls)
  {
    for (const Freedom direction : freedoms_of(wall))
      look(load_on(wall, direction).force, wall.book.force * way_of(wall, direction));
  }
  return largest;
}
} // namespace softgrain
