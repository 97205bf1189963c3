// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/given_energy.h>
#include <softgrain/mpm/stepping/step_rows.h>
#include <softgrain/mpm/stepping/stress.h>

#include <algorithm>
#include <numeric>

namespace softgrain::mpm
{
namespace
{
constexpr double allowed = 1e-5;   ///< share of what all bodies store that contact may give in a step
constexpr double strongest = 100.; ///< regularisation of held steps so short that what they gain is rounding
constexpr double floor_strain = 1e-7; ///< energy of such a strain is rounding
} // namespace

GivenEnergy::GivenEnergy(const Problem &problem,
                         const State &state,
                         const Workspace &work,
                         const StepPlan &plan,
                         const std::vector<WallMotion<2>> &motion,
                         const StepEquations &equations)
    : problem(problem), state(state), work(work), plan(plan), motion(motion), equations(equations)
{
}

double GivenEnergy::work_of_overlaps(const Vectors &increment) const
{
  const GapsByRow gaps = true_gaps(problem, state, work, motion, plan.dt, increment, 1.);
  const auto &rows = work.contact.contact_rows();
  const std::vector<double> dents = work.contact.subgrid_overlap(plan.dt);
  double sum = 0.;
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    const auto gap = gaps.find(rows[r].key);
    if (gap != gaps.end())
      sum += work.contact.impulses()[r * work.contact.n_components()] / plan.dt *
             std::max(0., -gap->second - dents[r]);
  }
  return sum;
}

bool GivenEnergy::is_given(const bool settled) const
{
  const bool descends = plan.held && work.contact.free_walls.list.empty();
  if (!problem.settings.rows_follow() || !problem.slippery() || work.contact.empty() ||
      (settled && !descends) || (plan.held && plan.regularisation >= strongest))
    return false;
  double gain = settled ? 0. : work_of_overlaps(equations.increment);
  if (!descends && gain == 0.)
    return false;

  std::vector<double> stored(state.bodies.size(), 0.), change(state.bodies.size(), 0.),
      floor(state.bodies.size(), 0.);
  work.share.for_mine(
      state.bodies,
      [&](const Body<2> &body)
      {
        const unsigned int b = body.index;
        const Eigen::VectorXd none = Eigen::VectorXd::Zero(body.field.n_dofs());
        stored[b] =
            measure_points(body, Eigen::VectorXd(body.displacement + equations.increment[b]), none).energy;
        floor[b] = floor_strain * floor_strain * body.law->young_modulus() * body.rest_area;
        if (!descends)
        {
          if (problem.settings.scheme.inertia)
            stored[b] += body.kinetic_energy();
          return;
        }
        change[b] = stored[b] - measure_points(body, body.displacement, none).energy;
        if (equations.external[b].size() > 0)
          change[b] -= equations.external[b].dot(equations.increment[b]);
      },
      [&](BodyShare::Message &message)
      {
        for (std::vector<double> *const numbers : {&stored, &change, &floor})
          message.add(*numbers);
      });
  const double dents = work.contact.subgrid_energy(state.bodies, problem.subgrid(), plan.dt);
  const double scale = dents + std::accumulate(stored.begin(), stored.end(), 0.) +
                       std::accumulate(floor.begin(), floor.end(), 0.) / allowed;
  if (descends)
    gain = std::accumulate(change.begin(), change.end(), gain + dents - state.balance.subgrid_energy);
  if (gain <= allowed * scale || !descends)
    return gain > allowed * scale;
  // What pushes bodies out of each other that were too deep is not given.
  Vectors rest = equations.increment;
  for (Eigen::VectorXd &u : rest)
    u.setZero();
  return gain - work_of_overlaps(rest) > allowed * scale;
}
} // namespace softgrain::mpm
