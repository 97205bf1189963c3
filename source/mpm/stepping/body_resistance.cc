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
void subtract_drag(const Body<dim> &body,
                   const double shift,
                   const Eigen::VectorXd &v,
                   Eigen::VectorXd &impulse)
{
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    impulse.segment<dim>(dim * i) -= shift * std::abs(body.nodes.mass[i]) * v.segment<dim>(dim * i);
}

template <int dim>
void resist_more(const Body<dim> &body,
                 const double more,
                 const Eigen::VectorXd &v,
                 Eigen::VectorXd &missing,
                 SystemMatrix *const matrix)
{
  subtract_drag(body, more, v, missing);
  if (matrix != nullptr)
    matrix->add_mass<dim>(body.nodes.mass.cwiseAbs(), more);
}

template void subtract_drag(const Body<2> &, double, const Eigen::VectorXd &, Eigen::VectorXd &);
template void subtract_drag(const Body<3> &, double, const Eigen::VectorXd &, Eigen::VectorXd &);
template void
resist_more(const Body<2> &, double, const Eigen::VectorXd &, Eigen::VectorXd &, SystemMatrix *);
template void
resist_more(const Body<3> &, double, const Eigen::VectorXd &, Eigen::VectorXd &, SystemMatrix *);

BodyResistance::BodyResistance(const BodyStart &start)
    : dt(start.plan.dt)
    , shift(start.plan.regularisation * dt * dt * start.softest / start.body.nodes.mass.sum())
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
  subtract_drag(body, shift, v, missing);
  if (weight > 0.)
    missing -= weight * rotation.dot(v) * rotation;
}

void BodyResistance::add_mass(const Body<2> &body, SystemMatrix &matrix) const
{
  matrix.add_mass<2>(body.nodes.mass.cwiseAbs(), shift);
}

void BodyResistance::resist_more(const Body<2> &body,
                                 const double factor,
                                 const Eigen::VectorXd &v,
                                 Eigen::VectorXd &missing,
                                 SystemMatrix *const matrix)
{
  mpm::resist_more(body, (factor - 1.) * shift, v, missing, matrix);
  shift *= factor;
}

double BodyResistance::regularisation_work(const Body<2> &body, const Eigen::VectorXd &increment) const
{
  // What is out of balance at the start goes over to this step: like walls, the mean of both ends.
  const double mass = body.nodes.mass.sum();
  double work = 0.;
  dealii::Tensor<1, 2> way; // of the centre of mass
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
  {
    work += 0.5 * shift / (dt * dt) * drag(body, i) * increment.segment<2>(2 * i).squaredNorm();
    for (unsigned int d = 0; d < 2; ++d)
      way[d] += body.nodes.mass[i] / mass * increment[2 * i + d];
  }
  return work + 0.5 * before * way;
}

dealii::Tensor<1, 2> BodyResistance::resistance(const Body<2> &body, const Eigen::VectorXd &increment) const
{
  dealii::Tensor<1, 2> force;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      force[d] += shift / (dt * dt) * drag(body, i) * increment[2 * i + d];
  return force;
}

double BodyResistance::held_back(const Body<2> &body, const Eigen::VectorXd &increment) const
{
  double sum = 0.;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    sum += shift / (dt * dt) * drag(body, i) * increment.segment<2>(2 * i).norm();
  return sum;
}
} // namespace softgrain::mpm
