// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/step_equations.h>
#include <softgrain/mpm/stepping/stress.h>
#include <softgrain/mpm/stepping/time_integrator.h>
#include <softgrain/mpm/stepping/wall_imbalance.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
bool sees_velocity(const Body<2> &body)
{
  return body.loads.see_velocity();
}
} // namespace

StepEquations::StepEquations(const Problem &problem,
                             const State &state,
                             Workspace &work,
                             const StepPlan &plan)
    : problem(problem)
    , state(state)
    , work(work)
    , scheme(problem.settings.scheme)
    , plan(plan)
    , dt(plan.dt)
    , scheme_terms(state.bodies.size())
    , missing_impulse(state.bodies.size())
    , measured(state.bodies.size(), std::array<double, 4>{})
{
  increment.resize(state.bodies.size());
  internal.resize(state.bodies.size());
  loads = {state.time + (plan.held ? 0. : scheme.loads_at()) * plan.dt, state.time, plan.dt, false};
  external = external_forces(state.bodies, work.share, loads);
  if (std::any_of(state.bodies.begin(), state.bodies.end(), sees_velocity))
    fixed_external = external;
  for (const Body<2> &body : state.bodies)
    if (body.rigid.driven)
      increment[body.index] = Eigen::VectorXd::Zero(body.field.n_dofs());
  const double softest = mpm::softest(state.bodies);
  for_moving(state.bodies,
             [&](const Body<2> &body)
             {
               const unsigned int b = body.index;
               if (!work.share.mine(b))
                 return;
               scheme_terms[b] = scheme.integrator->terms_of(
                   {body, scheme, this->plan, body.boundary.circular && problem.slippery(), external[b],
                    state.resistance.empty() ? dealii::Tensor<1, 2>() : state.resistance[b], softest});
             });
}

void StepEquations::rows_changed()
{
  rows_known = true;
  if (work.contact.empty() || scheme.theta == 1.)
    return;
  start_relative = work.contact.relative_velocity(work.share, state.bodies, work.drive,
                                                  [&](const unsigned int b) -> const Eigen::VectorXd &
                                                  { return state.bodies[b].nodes.velocity; });
}

bool StepEquations::evaluate(const Vectors &v)
{
  return evaluate_after([](unsigned int) {}, v);
}

bool StepEquations::evaluate_on_way(const Way &way, const double fraction, Vectors &v)
{
  return evaluate_after([&](const unsigned int b) { v[b] = go(b, way, fraction); }, v);
}

bool StepEquations::evaluate_after(const std::function<void(unsigned int)> &before, const Vectors &v)
{
  dealii::TimerOutput::Scope section(*work.timer, "stress and forces");
  const double half_dt = problem.settings.grid_update == GridUpdate::every_step ? 0.5 * dt : 0.;
  stress.assign(state.bodies.size(), StressOutcome());
  const double law_dt = plan.law_dt(), end = state.time + law_dt;
  SharedOutcomes outcomes(work.share, stress);
  work.share.for_mine(
      state.bodies,
      [&](const Body<2> &body)
      {
        const unsigned int b = body.index;
        before(b);
        increment[b] = scheme_terms[b]->increment(body, v[b]);
        stress[b] =
            evaluate_stress(body, Eigen::VectorXd(body.nodes.displacement + increment[b]), increment[b],
                            {half_dt, true, problem.settings.max_strain, law_dt, end}, work.trial[b]);
        if (!stress[b].good())
          return;
        internal_force(body, work.trial[b], internal[b]);
        find_missing_impulse(body, v[b]);
        if (rows_known)
          measure(body, v[b]);
      },
      [&](BodyShare::Message &message)
      {
        if (!problem.settings.meets_by_rays())
          message.add(state.bodies, increment);
        for (unsigned int b = 0; b < measured.size(); ++b)
          message.add(b, measured[b].data(), measured[b].size());
        outcomes.add_to(message);
      });
  outcomes.take();
  for (bad_body = 0; bad_body < stress.size(); ++bad_body)
    if (!stress[bad_body].good())
    {
      trouble = stress[bad_body];
      return false;
    }
  return true;
}

void StepEquations::find_missing_impulse(const Body<2> &body, const Eigen::VectorXd &v)
{
  const unsigned int b = body.index;
  if (body.loads.see_velocity())
  {
    external[b] = fixed_external[b];
    add_forces_of_velocity(body, loads, increment[b], external[b]);
    scheme_terms[b]->note_load(body, external[b]);
  }
  scheme_terms[b]->find_missing(body, v, increment[b], internal[b], external[b], missing_impulse[b]);
}

Eigen::VectorXd StepEquations::unbalanced(const unsigned int b) const
{
  Eigen::VectorXd P = missing_impulse[b];
  work.contact.add_impulses(b, P);
  return P;
}

void StepEquations::measure(const Body<2> &body, const Eigen::VectorXd &v)
{
  const unsigned int b = body.index;
  const double h = problem.lattice->cell_size();
  Eigen::VectorXd contact = Eigen::VectorXd::Zero(body.field.n_dofs());
  work.contact.add_impulses(b, contact);
  double scale = std::max(contact.norm(), dt * internal[b].norm());
  scale = std::max(scale, 1e-6 * scheme_terms[b]->momentum_of_nodes(body).largest);
  if (external[b].size() > 0)
    scale = std::max(scale, dt * external[b].norm());
  // Stresses below this are rounding: of a strain of order one, or of a gradient of what has moved far.
  const double moved = body.nodes.displacement.lpNorm<Eigen::Infinity>();
  scale = std::max(scale, std::max(1e-9, 1e-10 * moved / h) * dt * body.material.law->wave_modulus() * h);
  measured[b] = {unbalanced(b).squaredNorm(), (missing_impulse[b] + contact).norm(), scale, v.squaredNorm()};
}

double StepEquations::unbalanced_norm() const
{
  double sum = 0.;
  for (const auto &[square, norm, scale, length_square] : measured)
    sum += square;
  return std::sqrt(sum);
}

double StepEquations::residual() const
{
  double largest = 0., largest_scale = 0.;
  for (const auto &[square, norm, scale, length_square] : measured)
  {
    // What is not a number stays so, for no step to end with it.
    largest = std::isnan(norm) ? norm : std::max(largest, norm);
    largest_scale = std::max(largest_scale, scale);
  }
  return largest / largest_scale;
}

double StepEquations::trial_length() const
{
  double sum = 0.;
  for (const auto &[square, norm, scale, length_square] : measured)
    sum += length_square;
  return std::sqrt(sum);
}

void StepEquations::tell(std::vector<Told> &told, BodyShare::Message &message)
{
  message.add(state.bodies, internal);
  message.add(state.bodies, increment);
  if (std::any_of(state.bodies.begin(), state.bodies.end(), sees_velocity))
    message.add(state.bodies, external);
  for (unsigned int b = 0; b < told.size(); ++b)
    message.add(b, told[b].data(), told[b].size());
}

Eigen::VectorXd StepEquations::go(const unsigned int b, const Way &way, const double fraction) const
{
  // A trial is a velocity; theta dt of it is displacement.
  Eigen::VectorXd step = (fraction * scheme.theta * dt) * way.direction[b];
  turn_along_circles(state.bodies[b], scheme_terms[b]->turn(),
                     state.bodies[b].nodes.displacement + way.from[b], step);
  return way.x[b] + step / (scheme.theta * dt);
}
} // namespace softgrain::mpm
