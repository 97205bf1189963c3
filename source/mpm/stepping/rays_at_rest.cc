// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/ray_step.h>
#include <softgrain/mpm/stepping/rays_at_rest.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/ways_of_bodies.h>

#include <algorithm>
#include <limits>

namespace softgrain::mpm
{
namespace
{
constexpr double least_force = 1e-2; ///< that counts, over Young's modulus times a cell
/// Resistance to which held steps come: with more of it a balance that is far takes too many.
constexpr double least_when_held = 1e-4;
constexpr double ease = 0.3;            ///< of resistance, after a step that went well
constexpr double rise = 10.;            ///< of it, after one that did not
constexpr double most_resistance = 10.; ///< beyond which bodies hardly move in a step
/// Of a step that can still be made shorter. Where bodies resist more, walls do work on them that belongs to
/// no path of balances.
constexpr double most_if_shorter = 0.1;
constexpr double short_enough = 0.125;   ///< of the wanted step
constexpr double most_on_the_way = 1e-3; ///< likewise with walls on their way, which resistance hinders

/// The largest force that holds back a body over the mean force of a contact. Frames tell the
/// forces: they are part of the state.
double unbalanced(const Problem &problem, const State &state)
{
  double sum = 0., worst = 0., floor = 0.;
  unsigned int n_pressed = 0;
  for (const ContactFrame<2> &frame : state.frames)
  {
    double force = 0.;
    for (const auto &ray : frame.rays)
      force += std::abs(ray.force);
    sum += force;
    n_pressed += force > 0.;
  }
  for (const Body<2> &body : state.bodies)
  {
    worst = std::max(worst, state.held_back[body.index]);
    floor = std::max(floor, least_force * body.law->young_modulus() * problem.lattice->cell_size());
  }
  return std::max(worst / std::max(sum / std::max(n_pressed, 1u), floor), unbalanced_walls(problem, state));
}
} // namespace

StepOutcome
rays_step(const Problem &problem, State &state, Workspace &work, const double dt, const double wanted)
{
  double resistance = problem.settings.regularisation;
  const double most = dt > short_enough * wanted ? most_if_shorter : std::numeric_limits<double>::max();
  for (bool careful = false;; careful = true)
  {
    StepOutcome step = ray_step(problem, state, work, {dt, false, resistance}, careful, most);
    if (step.accepted)
      step.unbalanced = unbalanced(problem, state);
    if (step.accepted || resistance > most_on_the_way)
      return step;
    if (careful)
      resistance *= rise;
  }
}

StepOutcome settle_rays(const Problem &problem, State &state, Workspace &work, const double dt)
{
  const Settings &settings = problem.settings;
  StepOutcome sum;
  sum.accepted = true;
  sum.unbalanced = state.held_back.empty() ? 0. : unbalanced(problem, state);
  double resistance = settings.regularisation, slid = 0.;
  bool careful = false;
  const WaysOfBodies ways(problem, state);
  while (sum.unbalanced > settings.unbalanced_force)
  {
    if (sum.held_steps >= settings.max_held_steps)
    {
      if (settings.max_held_steps == 0)
        break;
      throw ComputationError("at time " + short_number(state.time) +
                             " s the bodies are not in balance after " + std::to_string(sum.held_steps) +
                             " held steps ('Quasi-static/Held steps'): unbalanced force " +
                             short_number(sum.unbalanced) + " ('Quasi-static/Unbalanced force' is " +
                             short_number(settings.unbalanced_force) + ")");
    }
    const StepOutcome held = ray_step(problem, state, work, {dt, true, resistance}, careful);
    sum.newton_iterations += held.newton_iterations;
    sum.contact_sweeps += held.contact_sweeps;
    sum.newton_residual = held.newton_residual;
    sum.max_penetration = held.max_penetration;
    if (!held.accepted)
    {
      if (careful)
        resistance *= rise;
      careful = true;
      if (resistance > most_resistance)
        throw ComputationError("no balance is found with the walls at rest: " + held.reason);
      continue;
    }
    careful = false;
    ++sum.held_steps;
    slid += slid_on_their_way(work, dt);
    check_room_of_walls(problem, state, slid);
    sum.largest_move = std::max(sum.largest_move, held.largest_move);
    if (sum.largest_move > problem.lattice->cell_size())
      ways.check(state, work, sum.held_steps);
    sum.unbalanced = unbalanced(problem, state);
    resistance =
        std::max(std::min(settings.regularisation, least_when_held), ease * resistance * held.raised);
  }
  return sum;
}
} // namespace softgrain::mpm
