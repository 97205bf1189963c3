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

template <int dim>
double sum_of_lengths(const Eigen::VectorXd &of_nodes)
{
  double sum = 0.;
  for (unsigned int i = 0; i < of_nodes.size(); i += dim)
    sum += of_nodes.segment<dim>(i).norm();
  return sum;
}

template double sum_of_lengths<2>(const Eigen::VectorXd &);
template double sum_of_lengths<3>(const Eigen::VectorXd &);

void resist_more(const double more,
                 const Eigen::VectorXd &v,
                 Eigen::VectorXd &missing,
                 SystemMatrix *const matrix)
{
  missing -= more * v;
  if (matrix != nullptr)
    matrix->add_to_diagonal(more);
}

BodyResistance::BodyResistance(const BodyStart &start)
    : dt(start.plan.dt)
    , shift(start.plan.regularisation * dt * dt * start.softest / start.body.nodes.mass.size())
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

void BodyResistance::find_missing(const Body<2> &body,
                                  const Eigen::VectorXd &v,
                                  const Eigen::VectorXd &,
                                  const Eigen::VectorXd &internal,
                                  const Eigen::VectorXd &load,
                                  Eigen::VectorXd &missing)
{
  missing = dt * internal;
  if (load.size() > 0)
    missing += dt * load;
  missing -= shift * v;
  if (weight > 0.)
    missing -= weight * rotation.dot(v) * rotation;
}

void BodyResistance::add_mass(const Body<2> &, SystemMatrix &matrix) const
{
  matrix.add_to_diagonal(shift);
}

void BodyResistance::resist_more(const Body<2> &,
                                 const double factor,
                                 const Eigen::VectorXd &v,
                                 Eigen::VectorXd &missing,
                                 SystemMatrix *const matrix)
{
  mpm::resist_more((factor - 1.) * shift, v, missing, matrix);
  shift *= factor;
}

double BodyResistance::regularisation_work(const Body<2> &body, const Eigen::VectorXd &increment) const
{
  // What is out of balance at the start goes over to this step: like walls, the mean of both ends.
  const double mass = body.nodes.mass.sum();
  dealii::Tensor<1, 2> way; // of the centre of mass
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      way[d] += body.nodes.mass[i] / mass * increment[2 * i + d];
  return 0.5 * (shift / (dt * dt) * increment.squaredNorm() + before * way);
}

dealii::Tensor<1, 2> BodyResistance::resistance(const Body<2> &, const Eigen::VectorXd &increment) const
{
  dealii::Tensor<1, 2> force;
  for (unsigned int i = 0; i < increment.size(); ++i)
    force[i % 2] += shift / (dt * dt) * increment[i];
  return force;
}

double BodyResistance::held_back(const Body<2> &, const Eigen::VectorXd &increment) const
{
  return shift / (dt * dt) * sum_of_lengths<2>(increment);
}
} // namespace softgrain::mpm
