// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/ways_of_bodies.h>

#include <sstream>

namespace softgrain::mpm
{
namespace
{
using Vector = dealii::Tensor<1, 2>;

/// Whether the step left a force between the body and something that is not free to go with it.
bool touches(const Workspace &work, const unsigned int b)
{
  const auto &rows = work.contact.contact_rows();
  for (unsigned int r = 0; r < rows.size(); ++r)
    if ((rows[r].body == b || rows[r].partner == b) && carries_force(work.contact, r))
      return true;
  return false;
}
} // namespace

/// Loads of all bodies now [N/m].
std::vector<Vector> loads_of(const State &state, const Workspace &work)
{
  std::vector<Vector> loads(state.bodies.size());
  const std::vector<Eigen::VectorXd> forces = external_forces(state.bodies, work.share, {state.time});
  for (unsigned int b = 0; b < forces.size(); ++b)
    for (unsigned int i = 0; 2 * i < forces[b].size(); ++i)
      loads[b] += Vector({forces[b][2 * i], forces[b][2 * i + 1]});
  return loads;
}

WaysOfBodies::WaysOfBodies(const Problem &problem, const State &state) : problem(problem)
{
  for (const Body<2> &body : state.bodies)
    start.push_back(body.center());
}

void WaysOfBodies::check(const State &state, const Workspace &work, const unsigned int n_steps) const
{
  // In a cell that repeats bodies may go anywhere.
  if (state.repeats())
    return;
  const double room = problem.settings.mesh_lower.distance(problem.settings.mesh_upper);
  for (const Body<2> &body : state.bodies)
  {
    const Vector way = body.center() - start[body.index];
    if (body.rigid.driven || way.norm() <= room)
      continue;
    const Vector load = loads_of(state, work)[body.index];
    std::ostringstream message;
    message.precision(3);
    message << "at time " << state.time << " s nothing holds body '" << body.name << "': ";
    if (load.norm() > 0.)
      message << "its load of (" << load << ") N/m ";
    else
      message << "what pushes it ";
    message << "has taken it (" << way << ") m far in " << n_steps
            << " held steps, further than the mesh is wide, and "
            << (touches(work, body.index) ? "what it touches does not keep it from sliding or rolling on"
                                          : "it touches nothing")
            << "; without inertia ('Time/Scheme' = 'quasi_static') a wall, an obstacle, a driven body or "
               "friction must bear every load";
    throw ComputationError(message.str());
  }
}
} // namespace softgrain::mpm
