// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/periodic_cell.h>

#include <cmath>

namespace softgrain
{
template <int dim>
typename PeriodicCell<dim>::Image PeriodicCell<dim>::image_of(const dealii::Point<dim> &x) const
{
  Image n{};
  for (unsigned int d = 1; d < dim; ++d)
    if (periodic[d])
      n[d] = static_cast<int>(std::floor((x[d] - lower[d]) / length[d]));
  if (periodic[0])
    n[0] = static_cast<int>(std::floor((x[0] - n[1] * offset - lower[0]) / length[0]));
  return n;
}

template <int dim>
typename PeriodicCell<dim>::Image PeriodicCell<dim>::from_reduced(const Image &n) const
{
  Image full = n;
  if (periodic[0] && periodic[1])
    full[0] -= static_cast<int>(std::lround(offset / length[0])) * n[1];
  return full;
}

template <int dim>
dealii::Tensor<1, dim> PeriodicCell<dim>::shortest(const dealii::Tensor<1, dim> &way) const
{
  Image n{};
  for (unsigned int d = 1; d < dim; ++d)
    if (periodic[d])
      n[d] = static_cast<int>(std::lround(way[d] / length[d]));
  if (periodic[0])
    n[0] = static_cast<int>(std::lround((way[0] - n[1] * offset) / length[0]));
  return way - shift(n);
}

template struct PeriodicCell<2>;
template struct PeriodicCell<3>;
} // namespace softgrain
