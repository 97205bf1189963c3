// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/stepping/begin_step.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/quasi_static.h>
#include <softgrain/mpm/stepping/rays_at_rest.h>
#include <softgrain/mpm/stepping/relaxation.h>
#include <softgrain/mpm/stepping/step_rows.h>
#include <softgrain/mpm/stepping/stored_energy.h>
#include <softgrain/mpm/stepping/ways_of_bodies.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
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

std::string largest_move_in_cells(const Problem &problem, const StepOutcome &held)
{
  std::ostringstream text;
  text.precision(3);
  text << held.largest_move / problem.lattice->cell_size();
  return text.str();
}

/// How far adhesion is from that of the gaps where the bodies are, over all adhesion (dimensionless): a step
/// pulls with that of the gaps at its start. Of a row either that differs or its gap, times a stiffness, is
/// nearly 0.
double unsettled_adhesion(const Problem &problem, const State &state, const Workspace &work, const double dt)
{
  if (!problem.pairs.adhere())
    return 0.;
  const auto &rows = work.contact.contact_rows();
  double differs = 0., all = 0.;
  for (unsigned int r = 0; r < rows.size(); ++r)
    if (rows[r].adhesion > 0.)
    {
      const double force = work.contact.impulses()[r * work.contact.n_components()] / dt,
                   stiffness = state.bodies[rows[r].body].law->young_modulus();
      all += rows[r].pull;
      differs += std::min(std::abs(force + rows[r].pull), stiffness * std::max(0., rows[r].gap));
    }
  return all > 0. ? differs / all : 0.;
}

StepOutcome make_held_steps(const Problem &problem, State &state, Workspace &work, const double dt)
{
  const Settings &settings = problem.settings;
  StepOutcome sum;
  sum.accepted = true;
  double of_bodies = unbalanced_force_here(problem, state, work, dt);
  const auto unbalanced = [&]()
  {
    return std::max(
        {of_bodies, unbalanced_walls(problem, state), unsettled_adhesion(problem, state, work, dt)});
  };
  sum.unbalanced = unbalanced();
  Relaxation relaxation(problem, state, dt);
  const WaysOfBodies ways(problem, state);
  StepOutcome step;
  double slid = 0.;
  unsigned int near_balance = 0; // held steps since all walls have met what bears them
  for (sum.held_steps = 0; near_balance < settings.max_held_steps; ++sum.held_steps, ++near_balance)
  {
    step = implicit_step(problem, state, work, relaxation.plan());
    add(step, sum);
    if (!step.accepted)
    {
      if (!relaxation.refused())
        throw ComputationError("no balance is found with the walls at rest: " + step.reason);
      continue;
    }
    sum.largest_move = std::max(sum.largest_move, step.largest_move);
    if (sum.largest_move > problem.lattice->cell_size())
      ways.check(state, work, sum.held_steps + 1);
    const double before = of_bodies;
    of_bodies = unbalanced_force_here(problem, state, work, dt);
    sum.unbalanced = unbalanced();
    if (sum.unbalanced <= settings.unbalanced_force &&
        step.largest_move <= settings.held_motion * problem.lattice->cell_size())
    {
      ++sum.held_steps;
      return sum;
    }
    const bool on_their_way = walls_are_on_their_way(work);
    relaxation.accepted(step, state, before, of_bodies, on_their_way);
    if (on_their_way)
    {
      slid += slid_on_their_way(work, dt);
      check_room_of_walls(problem, state, slid);
      near_balance = 0;
    }
  }
  if (settings.max_held_steps == 0)
    return sum;
  std::ostringstream message;
  message << "at time " << state.time << " s the bodies are not in balance after " << sum.held_steps
          << " held steps ('Quasi-static/Held steps'): unbalanced force " << sum.unbalanced
          << " ('Quasi-static/Unbalanced force' is " << settings.unbalanced_force << "), they still move by "
          << largest_move_in_cells(problem, step) << " cells";
  if (unbalanced_walls(problem, state) > of_bodies)
    message << "; " << least_balanced_wall(problem, state);
  throw ComputationError(message.str());
}
} // namespace

double unbalanced_force_here(const Problem &problem, State &state, Workspace &work, const double dt)
{
  // With rows where the bodies are: those of the step may be some way off.
  find_rows(problem, state, work, wall_motion(state, work, {dt, true, 0.}), dt, nullptr, 0., true);
  return unbalanced_force(problem, state, work, dt, loads_of(problem, state, work));
}

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
      force += work.contact.impulses()[r * components + c] / dt * rows[r].resultant(c);
    if (force.norm() == 0.)
      continue;
    net[rows[r].body] += force;
    if (rows[r].partner != ContactRow<2>::none)
      net[rows[r].partner] -= force;
    const bool swapped = rows[r].partner < rows[r].body;
    const PeriodicCell<2>::Image &n = rows[r].image;
    pairs[{std::min(rows[r].body, rows[r].partner), std::max(rows[r].body, rows[r].partner), rows[r].wall,
           swapped ? PeriodicCell<2>::Image{{-n[0], -n[1]}} : n}] += swapped ? -force : force;
  }
  double mean = 0., worst = 0., floor = 0.;
  for (const auto &pair : pairs)
    mean += pair.second.norm() / pairs.size();
  for (const Body<2> &body : state.bodies)
    if (!body.driven)
    {
      net[body.index] += loads[body.index];
      worst = std::max(worst, net[body.index].norm());
      floor = std::max(floor, 1e-6 * body.law->young_modulus() * problem.lattice->cell_size());
    }
  return worst / std::max(mean, floor);
}

StepOutcome
quasi_static_step(const Problem &problem, State &state, Workspace &work, const double dt, const double wanted)
{
  StepOutcome sum;
  if (problem.settings.meets_by_rays())
    sum = rays_step(problem, state, work, dt, wanted);
  else
    // A step in which contact would give energy, or in which rows and bodies chase each other, goes well when
    // bodies resist more; held steps take that off.
    for (double resistance = problem.settings.regularisation * wanted / dt;; resistance *= 10.)
    {
      sum = implicit_step(problem, state, work, {dt, false, resistance});
      if (!(sum.gives_energy || sum.unsolved) || resistance > 10.)
        break;
    }
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
  const StepOutcome outcome = problem.settings.meets_by_rays() ? settle_rays(problem, state, work, dt)
                                                               : make_held_steps(problem, state, work, dt);
  if (outcome.held_steps > 0)
    state.balance.released_energy += before - not_booked(state, work.share);
  return outcome;
}
} // namespace softgrain::mpm
