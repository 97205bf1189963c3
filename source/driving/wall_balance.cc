// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/wall_balance.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
double unbalanced(const std::vector<Wall> &walls)
{
  double largest = 0.;
  for (const Wall &wall : walls)
    if (!wall.prescribed())
    {
      const double left_over = std::abs(wall.load + wall.force * wall.normal());
      largest = std::max(largest, left_over > 0. ? left_over / std::abs(wall.load) : 0.);
    }
  return largest;
}
} // namespace softgrain
