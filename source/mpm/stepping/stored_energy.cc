// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/model/state.h>
#include <softgrain/mpm/stepping/stored_energy.h>
#include <softgrain/mpm/stepping/stress.h>

#include <numeric>

namespace softgrain::mpm
{
double
elastic_energy(const State &state, const BodyShare &share, const std::vector<Eigen::VectorXd> *increment)
{
  std::vector<double> elastic(state.bodies.size(), 0.);
  share.for_mine(
      state.bodies,
      [&](const Body<2> &body)
      {
        Eigen::VectorXd place = body.nodes.displacement;
        if (increment != nullptr)
          place += (*increment)[body.index];
        elastic[body.index] =
            measure_points(body, place, Eigen::VectorXd(Eigen::VectorXd::Zero(body.field.n_dofs()))).energy;
      },
      [&](BodyShare::Message &message) { message.add(elastic); });
  return std::accumulate(elastic.begin(), elastic.end(), 0.);
}

double stored_energy(const State &state, const BodyShare &share)
{
  return state.balance.subgrid_energy + elastic_energy(state, share);
}
} // namespace softgrain::mpm
