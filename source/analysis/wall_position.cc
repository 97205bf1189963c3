// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/wall_position.h>

#include <cmath>

namespace softgrain
{
template <int dim>
double wall_position(const dealii::Point<dim> &point, const dealii::Tensor<1, dim> &normal)
{
  unsigned int axis = dim - 1;
  for (unsigned int d = dim - 1; d-- > 0;)
    if (std::abs(normal[d]) > std::abs(normal[axis]))
      axis = d;
  return std::abs(normal[axis]) > 1. - 1e-12 ? point[axis] : (point - dealii::Point<dim>()) * normal;
}

template double wall_position<2>(const dealii::Point<2> &, const dealii::Tensor<1, 2> &);
template double wall_position<3>(const dealii::Point<3> &, const dealii::Tensor<1, 3> &);
} // namespace softgrain
