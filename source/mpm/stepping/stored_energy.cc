// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/model/state.h>
#include <softgrain/mpm/stepping/stored_energy.h>
#include <softgrain/mpm/stepping/stress.h>

namespace softgrain::mpm
{
double stored_energy(const State &state)
{
  std::vector<double> elastic(state.bodies.size(), 0.);
  parallel_for(state.bodies.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   if (!state.bodies[b].driven)
                     elastic[b] = measure_points(
                                      state.bodies[b], state.bodies[b].displacement,
                                      Eigen::VectorXd(Eigen::VectorXd::Zero(state.bodies[b].field.n_dofs())))
                                      .energy;
               });
  double sum = state.balance.subgrid_energy;
  for (const double energy : elastic)
    sum += energy;
  return sum;
}
} // namespace softgrain::mpm
