// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/keep_points.h>

#include <algorithm>

namespace softgrain::mpm
{
template <int dim>
WorkOfLaw keep_points(const StepState<dim> &trial, Body<dim> &body)
{
  WorkOfLaw work;
  const unsigned int n_history = body.law->n_history();
  for (std::size_t p = 0; p < body.points.size(); ++p)
  {
    auto point = body.points[p];
    point.stress() = trial.stress[p];
    if (n_history == 0)
      continue;
    std::copy_n(&trial.history[p * n_history], n_history, point.history());
    work.loss += trial.dissipation[p] * trial.volume[p];
  }
  for (std::size_t p = 0; p < trial.supply.size(); ++p)
    work.supply += trial.supply[p] * trial.volume[p];
  return work;
}

template WorkOfLaw keep_points(const StepState<2> &, Body<2> &);
template WorkOfLaw keep_points(const StepState<3> &, Body<3> &);
} // namespace softgrain::mpm
