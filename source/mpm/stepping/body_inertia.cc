// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/body_inertia.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double torque = 30.; ///< torque that keeps a spin, over E A per radian

/// Square of the time in which a wave goes from the middle of a round body to its rim [s^2].
template <int dim>
double square_of_crossing(const Body<dim> &body)
{
  const double ball = dim == 2 ? dealii::numbers::PI : 4. / 3. * dealii::numbers::PI;
  const double radius = std::pow(body.rest.area / ball, 1. / dim);
  return radius * radius * body.material.density / body.material.law->wave_modulus();
}
} // namespace

template <int dim>
void BodyInertia<dim>::begin(const Body<dim> &body,
                             const TimeScheme &scheme,
                             const double step,
                             const bool keeps_spin,
                             const Eigen::VectorXd &load)
{
  theta = scheme.theta;
  dt = step;
  const double beyond = keeps_spin ? dt * dt - square_of_crossing(body) : 0.;
  keeps = beyond > 0.;
  rotation = whole_rotation(body);
  half_turn.setZero();
  holding.setZero();
  weight = keeps ? torque * beyond * body.material.law->young_modulus() * body.rest.area : 0.;
  note_load(body, load);
}

template <int dim>
void BodyInertia<dim>::note_load(const Body<dim> &body, const Eigen::VectorXd &load)
{
  spin.setZero();
  if (!keeps || load.size() == 0)
    return;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    spin += dt / body.nodes.mass[i] *
            (rotation.template middleRows<dim>(dim * i).transpose() * load.segment<dim>(dim * i));
}

template <int dim>
Eigen::VectorXd BodyInertia<dim>::increment(const Body<dim> &body, const Eigen::VectorXd &v) const
{
  return dt * ((1. - theta) * body.nodes.velocity + theta * v);
}

template <int dim>
Eigen::VectorXd BodyInertia<dim>::end_velocity(const Body<dim> &body, const Eigen::VectorXd &way) const
{
  return (way / dt - (1. - theta) * body.nodes.velocity) / theta;
}

template <int dim>
void BodyInertia<dim>::find_missing(const Body<dim> &body,
                                    const Eigen::VectorXd &v,
                                    const Eigen::VectorXd &increment,
                                    const Eigen::VectorXd &internal,
                                    const Eigen::VectorXd &load,
                                    Eigen::VectorXd &missing)
{
  half_turn = 0.5 * (rotation.transpose() * increment);
  missing = dt * acting_force(body, internal);
  if (load.size() > 0)
    missing += dt * load;
  const Eigen::VectorXd change = v - body.nodes.velocity;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    missing.segment<dim>(dim * i) -= body.nodes.mass[i] * change.segment<dim>(dim * i);
  if (!keeps)
    return;
  lever = whole_rotation<dim>(body, 0.5 * increment);
  holding = weight * (lever.transpose() * change - spin);
  missing -= lever * holding;
}

template <int dim>
Eigen::VectorXd BodyInertia<dim>::acting_force(const Body<dim> &body, const Eigen::VectorXd &internal) const
{
  const Eigen::VectorXd &before = body.nodes.internal_force;
  if (theta == 1.)
    return internal;
  if (half_turn.isZero(0.))
    return (1. - theta) * before + theta * internal;
  // Forces at the end and at the start have a torque (2 θ - 1) p A φ about where a body is halfway, which
  // would spin it up: what damps is the change of forces but for a turn.
  return 0.5 * (before + internal) + (theta - 0.5) * (internal - turned<dim>(before, 2. * half_turn));
}

template <int dim>
double BodyInertia<dim>::held_weight(const Body<dim> &body, const StepState<dim> &trial) const
{
  // What theta > 1/2 damps is no turn, see acting_force(). Its stiffness against a turn, -2 p A, is taken
  // back: left in, Newton's method diverges where grains roll in long steps.
  return weight + (theta > 0.5 ? (2. * theta - 1.) * theta * dt * dt * pressure_area(body, trial) : 0.);
}

template <int dim>
double BodyInertia<dim>::damping(const Body<dim> &body,
                                 const Eigen::VectorXd &v,
                                 const Eigen::VectorXd &increment,
                                 const Eigen::VectorXd &internal) const
{
  // What impulses and forces at theta do more than their mean over the step.
  double sum = 0.;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    sum += body.nodes.mass[i] * (v - body.nodes.velocity).template segment<dim>(dim * i).squaredNorm();
  return (theta - 0.5) * sum +
         (0.5 * (internal + body.nodes.internal_force) - acting_force(body, internal)).dot(increment);
}

template <int dim>
typename BodyTerms<dim>::Momentum BodyInertia<dim>::momentum_of_nodes(const Body<dim> &body) const
{
  typename BodyTerms<dim>::Momentum momentum;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
  {
    const double of_node = body.nodes.mass[i] * body.nodes.velocity.template segment<dim>(dim * i).norm();
    momentum.largest = std::max(momentum.largest, of_node);
    momentum.sum += of_node;
  }
  return momentum;
}

template class BodyInertia<2>;
template class BodyInertia<3>;
} // namespace softgrain::mpm
