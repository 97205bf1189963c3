// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/model/state.h>
#include <softgrain/mpm/stepping/stored_energy.h>
#include <softgrain/mpm/stepping/stress.h>

namespace softgrain::mpm
{
double stored_energy(const State &state, const BodyShare &share)
{
  std::vector<double> elastic(state.bodies.size(), 0.);
  share.for_mine(
      state.bodies,
      [&](const Body<2> &body)
      {
        elastic[body.index] = measure_points(body, body.displacement,
                                             Eigen::VectorXd(Eigen::VectorXd::Zero(body.field.n_dofs())))
                                  .energy;
      },
      [&](BodyShare::Message &message) { message.add(elastic); });
  double sum = state.balance.subgrid_energy;
  for (const double energy : elastic)
    sum += energy;
  return sum;
}
} // namespace softgrain::mpm
