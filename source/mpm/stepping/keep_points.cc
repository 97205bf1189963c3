// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/keep_points.h>

#include <algorithm>

namespace softgrain::mpm
{
template <int dim>
bool any_history(const std::vector<Body<dim>> &bodies)
{
  return std::any_of(bodies.begin(), bodies.end(),
                     [](const Body<dim> &body) { return body.material.law->n_history() > 0; });
}

template <int dim>
WorkOfLaw keep_points(const StepState<dim> &trial, Body<dim> &body)
{
  WorkOfLaw work;
  const unsigned int n_history = body.material.law->n_history();
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

template bool any_history(const std::vector<Body<2>> &);
template bool any_history(const std::vector<Body<3>> &);
template WorkOfLaw keep_points(const StepState<2> &, Body<2> &);
template WorkOfLaw keep_points(const StepState<3> &, Body<3> &);
} // namespace softgrain::mpm
