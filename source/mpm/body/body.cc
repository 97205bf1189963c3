// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/body.h>

#include <algorithm>

namespace softgrain::mpm
{
template <int dim>
dealii::Tensor<1, dim> NodalState<dim>::momentum() const
{
  dealii::Tensor<1, dim> sum;
  for (unsigned int i = 0; velocity.size() > 0 && i < mass.size(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      sum[d] += mass[i] * velocity[dim * i + d];
  return sum;
}

template <int dim>
dealii::Point<dim> Body<dim>::center() const
{
  dealii::Tensor<1, dim> moment;
  for (unsigned int i = 0; i < nodes.mass.size(); ++i)
  {
    const dealii::Point<dim> &at = field.place(i);
    for (unsigned int d = 0; d < dim; ++d)
      moment[d] += nodes.mass[i] * (at[d] + nodes.displacement[dim * i + d]);
  }
  return dealii::Point<dim>(moment / nodes.mass.sum());
}

template <int dim>
double NodalState<dim>::kinetic_energy() const
{
  double sum = 0.;
  for (unsigned int i = 0; velocity.size() > 0 && i < mass.size(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      sum += 0.5 * mass[i] * velocity[dim * i + d] * velocity[dim * i + d];
  return sum;
}

template <int dim>
void Body<dim>::translate(const dealii::Tensor<1, dim> &way)
{
  for (unsigned int i = 0; i < field.n_independent(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      nodes.displacement[dim * i + d] += way[d];
}

template struct Boundary<2>;
template struct Boundary<3>;
template struct NodalState<2>;
template struct NodalState<3>;
template struct Body<2>;
template struct Body<3>;
} // namespace softgrain::mpm
