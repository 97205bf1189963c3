// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/mpm/stepping/keep_points.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/ray_step.h>
#include <softgrain/mpm/stepping/rays_at_rest.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/ways_of_bodies.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
constexpr double least_force = 1e-2; ///< that counts, over Young's modulus times a cell
/// Resistance to which held steps come: what weak forces alone hold creeps where it resists more. Where steps
/// do not go well with so little, it is more, but no more than the other: a balance that is far would take
/// too many.
constexpr double least_when_held = 1e-6, most_of_the_least = 1e-4, ease_of_least = 0.8;
constexpr unsigned int creeps_after = 20; ///< held steps
constexpr double ease = 0.3;              ///< of resistance, after a step that went well
constexpr double rise = 10.;              ///< of it, after one that did not
constexpr double most_resistance = 1e4;   ///< beyond which bodies do not move in a step
/// Of a step that can still be made shorter. Where bodies resist more, walls do work on them that belongs to
/// no path of balances.
constexpr double most_if_shorter = 0.1;
constexpr double short_enough = 0.125;   ///< of the wanted step
constexpr double most_on_the_way = 1e-3; ///< likewise with walls on their way, which resistance hinders

/// Of the plane, with walls under loads.
class PlaneAtRest final : public RaysAtRest
{
public:
  PlaneAtRest(const Problem &problem, State &state, Workspace &work)
      : RaysAtRest(problem.settings), problem(problem), state(state), work(work), ways(problem, state)
  {
  }

  double unbalanced() override
  {
    if (state.held_back.empty())
      return 0.;
    return std::max(
        unbalanced_rays(state.bodies, state.frames, state.held_back, problem.lattice->cell_size()),
        unbalanced_walls(problem, state));
  }

protected:
  StepOutcome step(const StepPlan &plan) override
  {
    dt = plan.dt;
    return ray_step(problem, state, work, plan);
  }

  void held(StepOutcome &sum) override
  {
    slid += slid_on_their_way(work, dt);
    check_room_of_walls(problem, state, slid);
    if (sum.largest_move > problem.lattice->cell_size())
      ways.check(state, work, sum.held_steps);
  }

  double time() const override { return state.time; }

  bool walls_yield() const override
  {
    return std::any_of(state.walls.begin(), state.walls.end(),
                       [](const Wall<2> &wall) { return is_free(wall); });
  }

  bool remembers() const override { return state.adhesion.remembers() || any_history(state.bodies); }

  std::string least_balanced() const override
  {
    const double of_bodies =
        unbalanced_rays(state.bodies, state.frames, state.held_back, problem.lattice->cell_size());
    if (unbalanced_walls(problem, state) > of_bodies)
      return least_balanced_wall(problem, state);
    return least_balanced_body(state.bodies, state.held_back);
  }

private:
  const Problem &problem;
  State &state;
  Workspace &work;
  const WaysOfBodies ways;
  double dt = 0., slid = 0.;
};
} // namespace

template <int dim>
double unbalanced_rays(const std::vector<Body<dim>> &bodies,
                       const std::vector<ContactFrame<dim>> &frames,
                       const std::vector<double> &held_back,
                       const double cell_size)
{
  double sum = 0., worst = 0., floor = 0.;
  unsigned int n_pressed = 0;
  for (const ContactFrame<dim> &frame : frames)
  {
    double force = 0.;
    for (const auto &ray : frame.rays)
      force += std::abs(ray.force);
    sum += force;
    n_pressed += force > 0.;
  }
  for (const Body<dim> &body : bodies)
  {
    worst = std::max(worst, held_back[body.index]);
    floor = std::max(floor, least_force * body.material.law->young_modulus() *
                                (dim == 2 ? cell_size : cell_size * cell_size));
  }
  return worst / std::max(sum / std::max(n_pressed, 1u), floor);
}

template <int dim>
std::string least_balanced_body(const std::vector<Body<dim>> &bodies, const std::vector<double> &held_back)
{
  const auto most = std::max_element(held_back.begin(), held_back.end());
  const Body<dim> &body = bodies[most - held_back.begin()];
  std::ostringstream text;
  text << "most is unbalanced at body '" << body.name << "', whose middle is at (" << body.center() << ") m";
  return text.str();
}

template std::string least_balanced_body(const std::vector<Body<2>> &, const std::vector<double> &);
template std::string least_balanced_body(const std::vector<Body<3>> &, const std::vector<double> &);
template double unbalanced_rays(const std::vector<Body<2>> &,
                                const std::vector<ContactFrame<2>> &,
                                const std::vector<double> &,
                                double);
template double unbalanced_rays(const std::vector<Body<3>> &,
                                const std::vector<ContactFrame<3>> &,
                                const std::vector<double> &,
                                double);

StepOutcome RaysAtRest::go(const double dt, const double wanted)
{
  StepPlan plan{dt, false, settings.regularisation};
  if (dt > short_enough * wanted)
    plan.most_resistance = most_if_shorter;
  // However much bodies resist, walls press them as far: a short step moves hardly any wall.
  const double most = dt > short_enough * wanted || walls_yield() ? most_on_the_way : most_resistance;
  for (;; plan.careful = true)
  {
    StepOutcome outcome = step(plan);
    if (outcome.accepted)
      outcome.unbalanced = unbalanced();
    if (outcome.accepted || plan.regularisation > most || outcome.too_long)
      return outcome;
    // The start of the step has no minimum with so much resistance: all that is left would be tried again.
    if (outcome.newton_iterations == 0 && plan.regularisation * outcome.raised >= plan.most_resistance &&
        !walls_yield())
      return outcome;
    if (plan.careful)
      plan.regularisation *= rise;
  }
}

StepOutcome RaysAtRest::settle(const double dt)
{
  StepOutcome sum;
  sum.accepted = true;
  sum.unbalanced = unbalanced();
  StepPlan plan{dt, true, settings.regularisation};
  const double highest = std::min(settings.regularisation, most_of_the_least);
  const double lowest = std::min(settings.regularisation, least_when_held);
  double least = highest;
  while (sum.unbalanced > settings.unbalanced_force || !sum.exact)
  {
    if (sum.held_steps >= settings.max_held_steps)
    {
      if (settings.max_held_steps == 0)
        break;
      throw ComputationError("at time " + short_number(time()) + " s the bodies are not in balance after " +
                             std::to_string(sum.held_steps) +
                             " held steps ('Quasi-static/Held steps'): unbalanced force " +
                             short_number(sum.unbalanced) + " ('Quasi-static/Unbalanced force' is " +
                             short_number(settings.unbalanced_force) + "); " + least_balanced());
    }
    const bool is_last = sum.held_steps + 1 == settings.max_held_steps;
    plan.exact = is_last || remembers() || sum.unbalanced <= settings.unbalanced_force;
    const StepOutcome outcome = step(plan);
    sum.newton_iterations += outcome.newton_iterations;
    sum.contact_sweeps += outcome.contact_sweeps;
    if (!outcome.accepted)
    {
      if (plan.careful && plan.regularisation * outcome.raised > most_resistance)
        throw ComputationError("no balance is found with the walls at rest: " + outcome.reason +
                               "; 'Time/Scheme' = 'moreau_jean' has inertia, which carries bodies on where "
                               "balance is lost");
      if (plan.careful)
        plan.regularisation *= rise;
      plan.careful = true;
      least = std::min(highest, rise * least);
      continue;
    }
    // What a refused step has found is no state.
    sum.newton_residual = outcome.newton_residual;
    sum.max_penetration = outcome.max_penetration;
    sum.exact = outcome.exact;
    plan.careful = false;
    ++sum.held_steps;
    sum.largest_move = std::max(sum.largest_move, outcome.largest_move);
    held(sum);
    sum.unbalanced = unbalanced();
    if (sum.held_steps >= creeps_after)
      least = outcome.raised > 1. ? std::min(highest, rise * least) : std::max(lowest, ease_of_least * least);
    plan.regularisation = std::max(least, ease * plan.regularisation * outcome.raised);
  }
  return sum;
}

StepOutcome
rays_step(const Problem &problem, State &state, Workspace &work, const double dt, const double wanted)
{
  return PlaneAtRest(problem, state, work).go(dt, wanted);
}

StepOutcome settle_rays(const Problem &problem, State &state, Workspace &work, const double dt)
{
  return PlaneAtRest(problem, state, work).settle(dt);
}
} // namespace softgrain::mpm
