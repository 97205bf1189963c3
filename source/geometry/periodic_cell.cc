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
    n[0] = static_cast<int>(std::floor((x[0] - n[up] * offset - lower[0]) / length[0]));
  return n;
}

template <int dim>
typename PeriodicCell<dim>::Image PeriodicCell<dim>::from_reduced(const Image &n) const
{
  Image full = n;
  if (periodic[0] && periodic[up])
    full[0] -= static_cast<int>(std::lround(offset / length[0])) * n[up];
  return full;
}

template <int dim>
std::vector<typename PeriodicCell<dim>::Image> PeriodicCell<dim>::neighbours() const
{
  const int above = periodic[up] ? 1 : 0, beside = periodic[0] ? 1 + above : 0,
            between = dim == 3 && periodic[1] ? 1 : 0;
  std::vector<Image> images;
  for (int k = -above; k <= above; ++k)
    for (int j = -between; j <= between; ++j)
      for (int i = -beside; i <= beside; ++i)
      {
        Image image{};
        image[0] = i;
        if constexpr (dim == 3)
          image[1] = j;
        image[up] = k;
        images.push_back(from_reduced(image));
      }
  return images;
}

template <int dim>
dealii::Tensor<1, dim> PeriodicCell<dim>::shortest(const dealii::Tensor<1, dim> &way) const
{
  Image n{};
  for (unsigned int d = 1; d < dim; ++d)
    if (periodic[d])
      n[d] = static_cast<int>(std::lround(way[d] / length[d]));
  if (periodic[0])
    n[0] = static_cast<int>(std::lround((way[0] - n[up] * offset) / length[0]));
  return way - shift(n);
}

template struct PeriodicCell<2>;
template struct PeriodicCell<3>;
} // namespace softgrain
