// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/cell_motion.h>

namespace softgrain
{
template <int dim>
void CellMotion<dim>::add_side(const dealii::Tensor<1, dim> &normal,
                               const dealii::Tensor<1, dim> &side_velocity)
{
  const unsigned int d = axis_of(normal);
  const bool lower = normal[d] > 0.;
  if (lower)
    drift += side_velocity;
  for (unsigned int e = 0; e < dim; ++e)
    gradient[e][d] += (lower ? -1. : 1.) * side_velocity[e] / cell.length[d];
}

template <int dim>
dealii::Tensor<2, dim> CellMotion<dim>::gradient_after(const double dt) const
{
  dealii::Tensor<2, dim> stretch = dt * gradient;
  for (unsigned int d = 0; d < dim; ++d)
    stretch[d][d] += 1.;
  return gradient * invert(stretch);
}

template <int dim>
PeriodicCell<dim> cell_of(const std::vector<Wall<dim>> &walls)
{
  std::vector<CellSide<dim>> sides;
  double offset = 0.;
  for_sides(walls,
            [&](const Wall<dim> &side)
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

template <int dim>
void load_sides(std::vector<Wall<dim>> &walls,
                const PeriodicCell<dim> &cell,
                const dealii::Tensor<2, dim> &virial)
{
  for_sides(walls, [&](Wall<dim> &side) { side.book.force = force_on_side(cell, side.normal(), virial); });
}

template struct CellMotion<2>;
template struct CellMotion<3>;
template PeriodicCell<2> cell_of(const std::vector<Wall<2>> &);
template PeriodicCell<3> cell_of(const std::vector<Wall<3>> &);
template void load_sides(std::vector<Wall<2>> &, const PeriodicCell<2> &, const dealii::Tensor<2, 2> &);
template void load_sides(std::vector<Wall<3>> &, const PeriodicCell<3> &, const dealii::Tensor<2, 3> &);
} // namespace softgrain
