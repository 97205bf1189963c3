// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/periodic_cell.h>

#include <cmath>

namespace softgrain
{
PeriodicCell::Image PeriodicCell::image_of(const dealii::Point<2> &x) const
{
  Image n{};
  if (periodic[1])
    n[1] = static_cast<int>(std::floor((x[1] - lower[1]) / length[1]));
  if (periodic[0])
    n[0] = static_cast<int>(std::floor((x[0] - n[1] * offset - lower[0]) / length[0]));
  return n;
}

PeriodicCell::Image PeriodicCell::from_reduced(const Image &n) const
{
  const int turns = periodic[0] && periodic[1] ? static_cast<int>(std::lround(offset / length[0])) : 0;
  return {{n[0] - turns * n[1], n[1]}};
}

dealii::Tensor<1, 2> PeriodicCell::shortest(const dealii::Tensor<1, 2> &way) const
{
  Image n{};
  if (periodic[1])
    n[1] = static_cast<int>(std::lround(way[1] / length[1]));
  if (periodic[0])
    n[0] = static_cast<int>(std::lround((way[0] - n[1] * offset) / length[0]));
  return way - shift(n);
}
} // namespace softgrain
