// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/moving_equations.h>
#include <softgrain/mpm/stepping/stiffness.h>

#include <limits>

namespace softgrain::mpm
{
MovingEquations::MovingEquations(const std::vector<Body<3>> &bodies,
                                 const Settings &settings,
                                 SpaceWorkspace &work,
                                 const StepPlan &plan,
                                 const double time,
                                 const bool slippery)
    : SpaceEquations(bodies, settings, work, plan, time, false), inertia(bodies.size())
{
  work.share.for_mine(bodies,
                      [&](const Body<3> &body)
                      {
                        const unsigned int b = body.index;
                        inertia[b].begin(body, settings.scheme, plan.dt, slippery && body.boundary.circular,
                                         external[b]);
                      });
  fixed_external = external;
}

void MovingEquations::find_missing(const Body<3> &body, const Eigen::VectorXd &v)
{
  const unsigned int b = body.index;
  if (body.loads.see_velocity())
  {
    external[b] = fixed_external[b];
    add_forces_of_velocity(body, loads, increment[b], external[b]);
    inertia[b].note_load(body, external[b]);
  }
  inertia[b].find_missing(body, v, increment[b], internal[b], external[b], missing_impulse[b]);
}

double MovingEquations::rounding(const Body<3> &body, const double contact) const
{
  double moved = plan.dt * external[body.index].norm();
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    moved += std::abs(body.nodes.mass[i]) * body.nodes.velocity.segment<3>(3 * i).norm();
  return SpaceEquations::rounding(body, contact) + std::numeric_limits<double>::epsilon() * moved;
}

void MovingEquations::assemble_exact(const Body<3> &body)
{
  const unsigned int b = body.index;
  SystemMatrix &matrix = work.matrices[b];
  matrix.set_zero();
  add_stiffness(body, work.trial[b], inertia[b].stiffness_weight(), matrix);
  inertia[b].add_mass(body, matrix);
  if (body.loads.see_velocity())
    add_load_tangent(body, loads, increment[b], settings.scheme.theta * plan.dt, matrix);
  // A ball that is pulled has no stiffness against a turn to be taken back.
  const double weight = inertia[b].held_weight(body, work.trial[b]);
  work.solvers[b]->set_update(weight > 0. ? Eigen::MatrixXd(inertia[b].held())
                                          : Eigen::MatrixXd(body.nodes.displacement.size(), 0),
                              weight);
}
} // namespace softgrain::mpm
