// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/wall_position.h>

#include <cmath>

namespace softgrain
{
double wall_position(const dealii::Point<2> &point, const dealii::Tensor<1, 2> &normal)
{
  const unsigned int axis = std::abs(normal[0]) > std::abs(normal[1]) ? 0 : 1;
  return std::abs(normal[axis]) > 1. - 1e-12 ? point[axis] : (point - dealii::Point<2>()) * normal;
}
} // namespace softgrain
