// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/judge_step.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/step_rows.h>

#include <algorithm>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
std::string partner_of(const Meeting &meeting, const State &state)
{
  switch (meeting.with)
  {
  case Meeting::With::wall:
    return "wall '" + state.walls[meeting.other].description.name + "'";
  case Meeting::With::obstacle:
    return "obstacle '" + state.obstacles[meeting.other].description.name + "'";
  default:
    return "body '" + state.bodies[meeting.other].name + "'";
  }
}

/// Depth up to which bodies may lie in each other at the end of a step [cells]. Rows that are found once in a
/// step, at nodes, cannot tell places in a cell from each other.
double allowed_depth(const Settings &settings)
{
  constexpr double of_nodes = 2.;
  return settings.meets_by_rays() ? settings.largest_penetration
                                  : std::max(settings.largest_penetration, of_nodes);
}

std::string names(const Meeting &meeting, const State &state)
{
  const std::string body = "body '" + state.bodies[meeting.body].name + "'";
  if (meeting.with == Meeting::With::body && meeting.other == meeting.body)
    return "parts of " + body;
  return body + " and " + partner_of(meeting, state);
}
} // namespace

std::string judge_step(const Problem &problem,
                       const State &state,
                       const Workspace &work,
                       const std::vector<WallMotion<2>> &motion,
                       const double dt,
                       const std::vector<Eigen::VectorXd> &increment,
                       StepOutcome &outcome,
                       Verdict *const told)
{
  const Verdict verdict = judge(problem, state, work, motion, dt, increment, 1.);
  if (told != nullptr)
    *told = verdict;
  const double depth = verdict.deepest.depth, h = problem.lattice->cell_size();
  outcome.max_penetration = std::max(outcome.max_penetration, depth);
  if (verdict.way > 1.)
  {
    outcome.share = 0.9 / verdict.way;
    return names(verdict.passing, state) + " would pass through each other: they move by " +
           short_number(verdict.way) + " times a quarter of the width of the narrower one";
  }
  const double allowed = allowed_depth(problem.settings);
  if (depth <= allowed * h || depth <= judge(problem, state, work, motion, dt, increment, 0.).deepest.depth)
    return "";
  std::ostringstream place;
  place << verdict.deepest.place;
  return names(verdict.overlap, state) + " lie " + short_number(depth / h) +
         " cells deep in each other at (" + place.str() +
         ") m, which is more than 'Contact/Largest penetration' allows";
}
} // namespace softgrain::mpm
