// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/given_energy.h>
#include <softgrain/mpm/stepping/step_rows.h>
#include <softgrain/mpm/stepping/stored_energy.h>

#include <algorithm>

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

double GivenEnergy::work_of_overlaps(const double share) const
{
  const GapsByRow gaps = true_gaps(problem, state, work, motion, plan.dt, equations.increment, share);
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
  double gain = settled ? 0. : work_of_overlaps(1.);
  if (!descends && gain == 0.)
    return false;

  const double dents = work.contact.subgrid_energy(state.bodies, problem.subgrid(), plan.dt);
  const double stored = elastic_energy(state, &equations.increment) + dents;
  double kinetic = 0., floor = 0., external_work = 0.;
  for (const Body<2> &body : state.bodies)
    if (!body.driven)
    {
      if (problem.settings.scheme.inertia)
        kinetic += body.kinetic_energy();
      floor += floor_strain * floor_strain * body.law->young_modulus() * body.rest_area;
      if (equations.external[body.index].size() > 0)
        external_work += equations.external[body.index].dot(equations.increment[body.index]);
    }
  const double limit = allowed * (stored + kinetic) + floor;
  if (!descends)
    return gain > limit;
  gain += stored - stored_energy(state) - external_work;
  // What pushes bodies out of each other that were too deep is not given.
  return gain > limit && gain - work_of_overlaps(0.) > limit;
}
} // namespace softgrain::mpm
