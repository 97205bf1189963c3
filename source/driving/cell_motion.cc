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

dealii::Tensor<2, 2> CellMotion::gradient_after(const double dt) const
{
  dealii::Tensor<2, 2> stretch = dt * gradient;
  for (unsigned int d = 0; d < 2; ++d)
    stretch[d][d] += 1.;
  return gradient * invert(stretch);
}

PeriodicCell<2> cell_of(const std::vector<Wall<2>> &walls)
{
  std::vector<CellSide<2>> sides;
  double offset = 0.;
  for_sides(walls,
            [&](const Wall<2> &side)
            {
              sides.push_back({side.point(), side.normal()});
              offset = side.offset;
            });
  return make_cell(sides, offset);
}

double length_across(const std::vector<Wall<2>> &walls, const std::size_t w)
{
  return is_side_of_cell(walls[w]) ? cell_of(walls).length[axis_of(walls[w].normal())] : 0.;
}

void load_sides(std::vector<Wall<2>> &walls, const PeriodicCell<2> &cell, const dealii::Tensor<2, 2> &virial)
{
  for_sides(walls, [&](Wall<2> &side)
            { side.book.force = -1. / cell.length[axis_of(side.normal())] * (virial * side.normal()); });
}
} // namespace softgrain
