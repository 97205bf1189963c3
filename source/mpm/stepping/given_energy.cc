// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/given_energy.h>
#include <softgrain/mpm/stepping/step_rows.h>
#include <softgrain/mpm/stepping/stored_energy.h>

#include <algorithm>
#include <numeric>

namespace softgrain::mpm
{
namespace
{
constexpr double allowed = 1e-5; ///< share of what all bodies store that contact may give in a step
/// The same of a step with inertia whose rows have settled: bodies that go far past each other come to lie in
/// each other, since gaps are not linear in their way.
constexpr double allowed_on_the_way = 1.5e-3;
constexpr double shallow = 1e-3;   ///< more of overlap in which such a step gives next to nothing [cells]
constexpr double strongest = 100.; ///< regularisation of held steps so short that what they gain is rounding
constexpr double floor_strain = 1e-7; ///< energy of such a strain is rounding

double sum(const std::vector<double> &numbers)
{
  return std::accumulate(numbers.begin(), numbers.end(), 0.);
}
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

double GivenEnergy::work_of_overlaps(const double share, const bool grown) const
{
  const GapsByRow gaps = true_gaps_of_all(problem, state, work, motion, plan.dt, equations.increment, share);
  const auto &rows = work.contact.contact_rows();
  const std::vector<double> dents = work.contact.subgrid_overlap(plan.dt);
  double sum = 0.;
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    const auto gap = gaps.find(rows[r].key);
    if (gap == gaps.end())
      continue;
    double overlap = -gap->second - dents[r];
    if (grown)
      overlap -= std::max(0., -rows[r].gap);
    sum += work.contact.impulses()[r * work.contact.n_components()] / plan.dt * std::max(0., overlap);
  }
  return sum;
}

double GivenEnergy::work_of_free_walls() const
{
  double sum = 0.;
  for (const FreeWall<2> &free : work.contact.free_walls.list)
  {
    const Wall &wall = state.walls[free.wall];
    sum += (free.slides() ? wall.slide_load : wall.load) * plan.dt * free.speed;
  }
  return sum;
}

bool GivenEnergy::is_given(const bool settled, const double deeper) const
{
  const bool on_the_way = settled && problem.settings.scheme.inertia;
  if (!problem.settings.rows_follow() || !problem.slippery() || work.contact.empty() ||
      (settled && !plan.held && !on_the_way) || (plan.held && plan.regularisation >= strongest))
    return false;
  if (on_the_way && deeper < shallow * problem.lattice->cell_size())
    return false;
  // What a step with inertia finds in each other is opened slowly (row_velocity()): it gives nothing that
  // why_contact_gives() does not see.
  double gain = settled && !on_the_way ? 0. : work_of_overlaps(1., problem.settings.scheme.inertia);
  if (!plan.held && gain == 0.)
    return false;

  const double dents = work.contact.subgrid_energy(state.bodies, problem.subgrid(), plan.dt);
  const double stored = elastic_energy(state, work.share, &equations.increment) + dents;
  std::vector<double> kinetic(state.bodies.size(), 0.), floor = kinetic, external_work = kinetic;
  work.share.for_mine(
      state.bodies,
      [&](const Body<2> &body)
      {
        const unsigned int b = body.index;
        if (problem.settings.scheme.inertia)
          kinetic[b] = body.kinetic_energy();
        floor[b] = floor_strain * floor_strain * body.law->young_modulus() * body.rest_area;
        if (equations.external[b].size() > 0)
          external_work[b] = equations.external[b].dot(equations.increment[b]);
      },
      [&](BodyShare::Message &message)
      {
        for (std::vector<double> *const numbers : {&kinetic, &floor, &external_work})
          message.add(*numbers);
      });
  const double limit = (on_the_way ? allowed_on_the_way : allowed) * (stored + sum(kinetic)) + sum(floor);
  if (!plan.held)
    return gain > limit;
  gain += stored - stored_energy(state, work.share) - sum(external_work) - work_of_free_walls();
  // What pushes bodies out of each other that were too deep is not given.
  return gain > limit && gain - work_of_overlaps(0.) > limit;
}
} // namespace softgrain::mpm
