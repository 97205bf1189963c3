// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/anisotropy.h>

#include <cmath>

namespace softgrain
{
double eigenvalue_difference(const dealii::SymmetricTensor<2, 2> &tensor)
{
  return std::hypot(tensor[0][0] - tensor[1][1], 2. * tensor[0][1]);
}

std::optional<double> principal_angle(const dealii::SymmetricTensor<2, 2> &tensor)
{
  if (eigenvalue_difference(tensor) <= 1e-9 * tensor.norm())
    return std::nullopt;
  return 0.5 * std::atan2(2. * tensor[0][1], tensor[0][0] - tensor[1][1]);
}
} // namespace softgrain
