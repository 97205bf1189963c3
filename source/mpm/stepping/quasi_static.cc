// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/quasi_static.h>
#include <softgrain/mpm/stepping/rays_at_rest.h>
#include <softgrain/mpm/stepping/stored_energy.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace softgrain::mpm
{
namespace
{
using Vector = dealii::Tensor<1, 2>;

/// Adds what one step took to what the steps before it took.
void add(const StepOutcome &step, StepOutcome &sum)
{
  sum.newton_iterations += step.newton_iterations;
  sum.contact_sweeps += step.contact_sweeps;
  sum.newton_residual = step.newton_residual;
  sum.contact_residual = step.contact_residual;
  sum.max_penetration = step.max_penetration;
}

/// What is driven stands still in held steps, too; it goes on afterwards, however they end.
class DrivesAtRest
{
public:
  explicit DrivesAtRest(Workspace &work) : work(work), drives(work.drive)
  {
    work.drive.assign(drives.size(), Vector());
  }
  ~DrivesAtRest() { work.drive = drives; }
  DrivesAtRest(const DrivesAtRest &) = delete;

private:
  Workspace &work;
  const std::vector<Vector> drives;
};

/// Energy that no column of the balance explains [J/m].
double not_booked(const State &state, const BodyShare &share)
{
  return stored_energy(state, share) + state.balance.dissipated() - state.external_work();
}

} // namespace

double unbalanced_force(const Problem &problem,
                        const State &state,
                        const Workspace &work,
                        const double dt,
                        const std::vector<dealii::Tensor<1, 2>> &loads)
{
  const auto &rows = work.contact.contact_rows();
  const unsigned int components = work.contact.n_components();
  std::vector<Vector> net(state.bodies.size());
  std::map<std::tuple<unsigned int, unsigned int, unsigned int, PeriodicCell<2>::Image>, Vector> pairs;
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    Vector force;
    for (unsigned int c = 0; c < components; ++c)
      force += work.contact.impulses()[r * components + c] / dt * direction_of(rows[r], c);
    if (force.norm() == 0.)
      continue;
    net[rows[r].body] += force;
    if (rows[r].partner != ContactRow<2>::none)
      net[rows[r].partner] -= force;
    const bool swapped = rows[r].partner < rows[r].body;
    const PeriodicCell<2>::Image &n = rows[r].cell.image;
    pairs[{std::min(rows[r].body, rows[r].partner), std::max(rows[r].body, rows[r].partner), rows[r].wall,
           swapped ? PeriodicCell<2>::Image{{-n[0], -n[1]}} : n}] += swapped ? -force : force;
  }
  double mean = 0., worst = 0., floor = 0.;
  for (const auto &pair : pairs)
    mean += pair.second.norm() / pairs.size();
  for (const Body<2> &body : state.bodies)
    if (!body.rigid.driven)
    {
      net[body.index] += loads[body.index];
      worst = std::max(worst, net[body.index].norm());
      floor = std::max(floor, 1e-6 * body.material.law->young_modulus() * problem.lattice->cell_size());
    }
  return worst / std::max(mean, floor);
}

StepOutcome
quasi_static_step(const Problem &problem, State &state, Workspace &work, const double dt, const double wanted)
{
  StepOutcome sum = rays_step(problem, state, work, dt, wanted);
  // Walls under pressure go as far as balance lets them.
  if (!sum.accepted || work.contact.free_walls.list.empty())
    return sum;
  const StepOutcome held = find_balance(problem, state, work, dt);
  if (held.held_steps > 0)
    add(held, sum);
  sum.held_steps = held.held_steps;
  sum.unbalanced = held.unbalanced;
  sum.largest_move = std::max(sum.largest_move, held.largest_move);
  return sum;
}

StepOutcome find_balance(const Problem &problem, State &state, Workspace &work, const double dt)
{
  const double before = not_booked(state, work.share);
  const DrivesAtRest rest(work);
  const StepOutcome outcome = settle_rays(problem, state, work, dt);
  if (outcome.held_steps > 0)
    state.balance.losses.add(loss::released, before - not_booked(state, work.share));
  return outcome;
}
} // namespace softgrain::mpm
