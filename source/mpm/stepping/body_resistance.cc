// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/body_resistance.h>

namespace softgrain::mpm
{
namespace
{
/// Torque that keeps a round body without friction from turning, against one that resists as the body's own
/// stiffness does: where the rim is cut by cells the body would creep on, turn by turn, from one balance to
/// another.
constexpr double locked = 1e4;
} // namespace

BodyResistance::BodyResistance(const BodyStart &start)
    : dt(start.plan.dt)
    , nodes(start.body.nodes.mass, start.plan.regularisation, dt * dt * start.softest)
    , weight(30. * (start.nothing_turns_it ? locked : start.plan.regularisation) * dt * dt * start.softest *
             start.body.rest.area)
    , rotation(whole_rotation(start.body))
    , before(start.resistance)
{
}

Eigen::VectorXd BodyResistance::increment(const Body<2> &, const Eigen::VectorXd &v) const
{
  return dt * v;
}

void BodyResistance::find_missing(const Body<2> &,
                                  const Eigen::VectorXd &v,
                                  const Eigen::VectorXd &,
                                  const Eigen::VectorXd &internal,
                                  const Eigen::VectorXd &load,
                                  Eigen::VectorXd &missing)
{
  missing = dt * internal;
  if (load.size() > 0)
    missing += dt * load;
  nodes.subtract(v, missing);
  if (weight > 0.)
    missing -= weight * rotation.dot(v) * rotation;
}

void BodyResistance::add_mass(const Body<2> &, SystemMatrix &matrix) const
{
  nodes.add_to(matrix);
}

void BodyResistance::resist_more(const Body<2> &,
                                 const double factor,
                                 const Eigen::VectorXd &v,
                                 Eigen::VectorXd &missing,
                                 SystemMatrix *const matrix)
{
  nodes.rise(factor, v, missing, matrix);
}

double BodyResistance::regularisation_work(const Body<2> &body, const Eigen::VectorXd &increment) const
{
  // What is out of balance at the start goes over to this step: like walls, the mean of both ends.
  const double mass = body.nodes.mass.sum();
  dealii::Tensor<1, 2> way; // of the centre of mass
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      way[d] += body.nodes.mass[i] / mass * increment[2 * i + d];
  return 0.5 * (nodes.times_way(increment) / (dt * dt) + before * way);
}

dealii::Tensor<1, 2> BodyResistance::resistance(const Body<2> &, const Eigen::VectorXd &increment) const
{
  return nodes.sum(increment) / (dt * dt);
}

double BodyResistance::held_back(const Body<2> &, const Eigen::VectorXd &increment) const
{
  return nodes.amounts(increment) / (dt * dt);
}
} // namespace softgrain::mpm
