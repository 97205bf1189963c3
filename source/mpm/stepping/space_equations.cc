// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/stepping/nodal_resistance.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/space_equations.h>
#include <softgrain/mpm/stepping/stiffness.h>
#include <softgrain/mpm/stepping/wall_imbalance.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
/// Widest band in space, where factors fill so that a band is best up to some 1500 nodes.
constexpr unsigned int widest_band = 2000;
/// Of the torque that keeps a round body from turning, see StepEquations. Other bodies resist turning as they
/// resist all motion.
constexpr double locked = 1e4;

/// Steps that solve no equations know where bodies are when they begin, and no more.
LoadTimes times_of_loads(const TimeScheme &scheme, const StepPlan &plan, const double time)
{
  const double share = plan.held || !scheme.solves_equations() ? 0. : scheme.loads_at();
  return {time + share * plan.dt, time, plan.dt, !scheme.solves_equations()};
}
} // namespace

void SpaceWorkspace::reinit(const std::vector<Body<3>> &bodies,
                            const LinearSolverSettings &settings,
                            const bool equations)
{
  LinearSolverSettings of_space = settings;
  of_space.automatic_band = widest_band;
  trial.resize(bodies.size());
  matrices = std::vector<SystemMatrix>(bodies.size());
  solvers.clear();
  for (const Body<3> &body : bodies)
  {
    solvers.emplace_back();
    if (!equations || !share.mine(body.index))
      continue;
    lay_out_stiffness(body.field, matrices[body.index], true);
    solvers.back() =
        std::make_unique<LowRankSolver>(create_linear_solver(of_space, matrices[body.index], 3, true));
  }
}

SpaceEquations::SpaceEquations(const std::vector<Body<3>> &bodies,
                               const Settings &settings,
                               SpaceWorkspace &work,
                               const StepPlan &plan,
                               const double time,
                               const bool frictionless)
    : bodies(bodies)
    , settings(settings)
    , work(work)
    , plan(plan)
    , loads(times_of_loads(settings.scheme, plan, time))
    , missing_impulse(bodies.size())
    , resistance(bodies.size())
    , rotations(bodies.size())
    , rotation_weight(bodies.size())
    , end(time + plan.law_dt())
{
  increment.resize(bodies.size());
  internal.resize(bodies.size());
  external.resize(bodies.size());
  const double young = softest(bodies);
  work.share.for_mine(bodies,
                      [&](const Body<3> &body)
                      {
                        const unsigned int b = body.index;
                        if (!external_force(body, loads, external[b]))
                          external[b].resize(0);
                        const double dt_2 = plan.dt * plan.dt;
                        resistance[b] = NodalResistance<3>(body.nodes.mass, plan.regularisation,
                                                           dt_2 * young * std::cbrt(body.rest.area));
                        rotations[b] = frictionless ? Eigen::MatrixXd(whole_rotation(body))
                                                    : Eigen::MatrixXd(body.nodes.displacement.size(), 0);
                        rotation_weight[b] = 30. * (body.boundary.circular ? locked : plan.regularisation) *
                                             dt_2 * young * body.rest.area;
                      });
}

bool SpaceEquations::evaluate(const Vectors &v)
{
  dealii::TimerOutput::Scope section(*work.timer, "stress and forces");
  stress.assign(bodies.size(), StressOutcome());
  SharedOutcomes outcomes(work.share, stress);
  work.share.for_mine(
      bodies,
      [&](const Body<3> &body)
      {
        const unsigned int b = body.index;
        increment[b] = increment_of(body, v[b]);
        Trial asked;
        asked.tangent = settings.scheme.solves_equations();
        asked.max_strain = settings.max_strain;
        asked.dt = plan.law_dt();
        asked.time = end;
        stress[b] = evaluate_stress(body, Eigen::VectorXd(body.nodes.displacement + increment[b]),
                                    increment[b], asked, work.trial[b]);
        if (!stress[b].good())
          return;
        internal_force(body, work.trial[b], internal[b]);
        find_missing(body, v[b]);
      },
      [&](BodyShare::Message &message) { outcomes.add_to(message); });
  outcomes.take();
  for (bad_body = 0; bad_body < stress.size(); ++bad_body)
    if (!stress[bad_body].good())
      return false;
  return true;
}

Eigen::VectorXd SpaceEquations::increment_of(const Body<3> &, const Eigen::VectorXd &v) const
{
  return plan.dt * v;
}

void SpaceEquations::find_missing(const Body<3> &body, const Eigen::VectorXd &v)
{
  const unsigned int b = body.index;
  missing_impulse[b] = plan.dt * internal[b];
  if (external[b].size() > 0)
    missing_impulse[b] += plan.dt * external[b];
  resistance[b].subtract(v, missing_impulse[b]);
  missing_impulse[b] -= rotations[b] * (rotation_weight[b] * (rotations[b].transpose() * v));
}

std::string SpaceEquations::why_not() const
{
  return mpm::why_not(bodies[bad_body], stress[bad_body]);
}

double SpaceEquations::rounding(const Body<3> &body, const double contact) const
{
  const unsigned int b = body.index;
  return std::numeric_limits<double>::epsilon() *
         summed_in_forces(body, work.trial[b], settings.cell_size, contact, internal[b].norm(), plan.dt);
}

void SpaceEquations::assemble_exact(const Body<3> &body)
{
  const unsigned int b = body.index;
  SystemMatrix &matrix = work.matrices[b];
  matrix.set_zero();
  add_stiffness(body, work.trial[b], plan.dt * plan.dt, matrix);
  resistance[b].add_to(matrix);
  work.solvers[b]->set_update(rotations[b], rotation_weight[b]);
}

void SpaceEquations::resist_more(const double factor, const Vectors &v, const bool in_matrices)
{
  work.share.for_mine(bodies,
                      [&](const Body<3> &body)
                      {
                        const unsigned int b = body.index;
                        resistance[b].rise(factor, v[b], missing_impulse[b],
                                           in_matrices ? &work.matrices[b] : nullptr);
                      });
}

void SpaceEquations::solve_free(const unsigned int b, Eigen::VectorXd &x) const
{
  work.solvers[b]->solve(missing_impulse[b], x);
}

double SpaceEquations::held_back(const unsigned int b) const
{
  return resistance[b].amounts(increment[b]) / (plan.dt * plan.dt);
}

double SpaceEquations::regularisation_work(const unsigned int b) const
{
  return 0.5 * resistance[b].times_way(increment[b]) / (plan.dt * plan.dt);
}
} // namespace softgrain::mpm
