// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/cell_motion.h>

namespace softgrain
{
void CellMotion::add_side(const dealii::Tensor<1, 2> &normal, const dealii::Tensor<1, 2> &side_velocity)
{
  const unsigned int d = axis_of(normal);
  const bool lower = normal[d] > 0.;
  if (lower)
    drift += side_velocity;
  for (unsigned int e = 0; e < 2; ++e)
    gradient[e][d] += (lower ? -1. : 1.) * side_velocity[e] / cell.length[d];
}

PeriodicCell<2> cell_of(const std::vector<Wall<2>> &walls)
{
  std::vector<CellSide<2>> sides;
  double offset = 0.;
  for (const Wall<2> &wall : walls)
    if (is_side_of_cell(wall))
    {
      sides.push_back({wall.point(), wall.normal()});
      offset = wall.offset;
    }
  return make_cell(sides, offset);
}

void load_sides(std::vector<Wall<2>> &walls, const PeriodicCell<2> &cell, const dealii::Tensor<2, 2> &virial)
{
  for (Wall<2> &wall : walls)
    if (is_side_of_cell(wall))
      wall.book.force = -1. / cell.length[axis_of(wall.normal())] * (virial * wall.normal());
}
} // namespace softgrain
