// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/interruption.h>
#include <softgrain/mpm/contact/frame_adhesion.h>
#include <softgrain/mpm/contact/moved_boundary.h>
#include <softgrain/mpm/stepping/ray_newton.h>
#include <softgrain/mpm/stepping/refused_step.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace softgrain::mpm
{
namespace
{
constexpr double gap_tolerance = 1e-5; ///< cells
/// Share of all forces by which those may be off whose friction is that of the iterate before.
constexpr double kept_tolerance = 1e-3;
constexpr unsigned int most_halvings = 8; ///< of a way that cannot be gone
constexpr unsigned int halvings_with_all_rays = 2;
constexpr unsigned int most_strained =
    2;                       ///< iterations in a row that are halved as they deform bodies too much
constexpr double rise = 10.; ///< of what resists motion, where a step has no minimum
constexpr unsigned int most_rises = 8;
constexpr double back_from = 100.;         ///< rise from which on a step begins anew
constexpr double keeps_dents_from = 0.3;   ///< resistance
constexpr double old_factors_below = 1e-2; ///< residual from which on factors serve for more iterations
constexpr double longest_way = 0.3;        ///< of a place that presses, in an iteration [cells]
/// Residual and gap [cells] with which a held step may end that is only on the way to balance.
constexpr double nearly = 0.1, nearly_closed = 1e-2;
} // namespace

template <int dim>
bool RayNewton<dim>::good_enough() const
{
  return !plan.exact && residual < nearly && deepest_by_force < nearly_closed * h;
}

template <int dim>
bool RayNewton<dim>::converged() const
{
  return (residual < world.settings.residual_tolerance || at_rounding()) &&
         deepest_by_force < gap_tolerance * h && system.kept_off < kept_tolerance;
}

template <int dim>
void RayNewton<dim>::find_factors()
{
  if (!matrices.assembled)
    assemble();
  matrices.assembled = true;
  matrices.negative = factorise();
}

/// Forces of rays for the factors at hand. @return whether there are any, with which the bodies are near a
/// minimum
template <int dim>
bool RayNewton<dim>::solve_contact()
{
  if (!matrices.negative)
    return false;
  Vectors y(way.size());
  {
    dealii::TimerOutput::Scope section(world.timer, "linear solves");
    world.share.for_mine(world.bodies,
                         [&](const Body<dim> &body)
                         {
                           world.solvers[body.index]->solve(equations.missing(body.index), y[body.index]);
                           y[body.index] *= theta * plan.dt;
                         });
  }
  {
    dealii::TimerOutput::Scope section(world.timer, "condensation");
    // In the first iteration walls have moved and bodies have not.
    system.condense(scene, frames, force, rubbing,
                    candidates_within() + (outcome.newton_iterations == 0 ? largest_way() : 0.), y);
  }
  dealii::TimerOutput::Scope section(world.timer, "contact solve");
  const bool begins = outcome.newton_iterations == 0 && outcome.raised == 1. && system.ways.empty();
  for (const auto &[f, k] : system.kept)
    frames[f].keep_friction(k, false);
  const bool solved = system.solve(h, *matrices.negative, begins);
  for (const auto &[f, k] : system.kept)
    frames[f].keep_friction(k, true);
  return solved && system.wrong_inertia(*matrices.negative) == 0;
}

/// Forces of rays for Newton's equations; bodies resist more where these have no minimum.
template <int dim>
std::string RayNewton<dim>::find_forces()
{
  if (matrices.serve && solve_contact())
    return "";
  matrices.serve = false;
  for (unsigned int attempt = 0;; ++attempt)
  {
    find_factors();
    if (solve_contact())
      return "";
    // A step that begins in a minimum succeeds when it is short enough, and no resistance helps it.
    outcome.too_long = plan.may_be_shorter() && system.began_in_minimum && presses_more_than_resists();
    if (inertia || outcome.too_long || attempt == most_rises ||
        outcome.raised * plan.regularisation >= plan.most_resistance)
      return "no forces of contacts are found";
    if (!resist_more())
      return why_not();
  }
}

/// Whether contacts bear more when a step begins, in the mean, than the most that would resist its way.
template <int dim>
bool RayNewton<dim>::presses_more_than_resists() const
{
  double sum = 0.;
  unsigned int n_pressed = 0;
  for (const FrameState<dim> &frame : frames)
  {
    const auto &rays = frame.layout().rays;
    const double pressed =
        std::accumulate(rays.begin(), rays.end(), 0.,
                        [](const double so_far, const auto &ray) { return so_far + ray.force; });
    sum += pressed;
    n_pressed += pressed > 0.;
  }
  return sum > n_pressed * plan.most_resistance * softest_pair * largest_way();
}

template <int dim>
bool RayNewton<dim>::resist_more()
{
  outcome.raised *= rise;
  equations.resist_more(rise, trial, matrices.assembled);
  const bool kept_now = keep_dents();
  if (outcome.newton_iterations > 0 && outcome.raised >= back_from)
    return go_back();
  return !kept_now || evaluate(way);
}

/// To where the step began: iterates without a minimum may have gone where no resistance brings them back, as
/// matter that flows does. Walls under loads stay where they have come to.
template <int dim>
bool RayNewton<dim>::go_back()
{
  way = at_rest;
  matrices.assembled = false;
  take_forces_of_start();
  path += h;
  const bool is_there = evaluate(way);
  measure();
  return is_there;
}

/// Where bodies resist much. @return whether any is now kept that was not before
template <int dim>
bool RayNewton<dim>::keep_dents()
{
  if (dents_kept || plan.regularisation * outcome.raised < keeps_dents_from)
    return false;
  for (FrameState<dim> &frame : frames)
    frame.keep_dent();
  matrices.assembled = false;
  return dents_kept = true;
}

/// Whether a surface would go further than rays have looked.
template <int dim>
bool RayNewton<dim>::goes_too_far(const Vectors &direction) const
{
  const auto ways = world.share.template numbers<1>(
      world.bodies,
      [&](const Body<dim> &body)
      {
        const unsigned int b = body.index;
        return std::array<double, 1>{mpm::largest_way(body, Eigen::VectorXd(way[b] + direction[b]))};
      });
  return std::any_of(ways.begin(), ways.end(), [&](const auto &of_body) { return of_body[0] > scene.reach; });
}

template <int dim>
typename RayNewton<dim>::Farthest RayNewton<dim>::farthest(const Vectors &direction) const
{
  const auto ways = world.share.template numbers<2>(
      world.bodies,
      [&](const Body<dim> &body)
      {
        const unsigned int b = body.index;
        double under_rays = 0.;
        for (const auto &[f, side] : system.frames_of[b])
          for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
            if (force[f][k] != 0. || system.found[f][k] != 0.)
              under_rays = std::max(under_rays, frames[f].ray(k).side[side].function.at(direction[b]).norm());
        return std::array<double, 2>{
            under_rays, system.frames_of[b].empty() ? 0. : direction[b].template lpNorm<Eigen::Infinity>()};
      });
  Farthest result;
  for (const auto &[under_rays, node] : ways)
  {
    result.place = std::max(result.place, under_rays);
    result.node = std::max(result.node, node);
  }
  for (unsigned int w = 0; w < system.ways.size(); ++w)
    result.place = std::max(result.place, std::abs(system.found_ways[w] - system.ways[w].at));
  return result;
}

/// Ways for the forces that contact has found.
template <int dim>
void RayNewton<dim>::follow_forces(Vectors &direction)
{
  dealii::TimerOutput::Scope section(world.timer, "linear solves");
  world.share.for_mine(
      world.bodies,
      [&](const Body<dim> &body)
      {
        const unsigned int b = body.index;
        if (system.frames_of[b].empty())
          equations.solve_free(b, direction[b]);
        else
          world.solvers[b]->solve(equations.missing(b) + plan.dt * system.force_on(b), direction[b]);
        direction[b] *= theta * plan.dt;
      },
      [&](BodyShare::Message &message)
      {
        for (const Body<dim> &body : world.bodies)
          if (!body.rigid.driven)
            message.add(body.index, direction[body.index].data(), direction[body.index].size());
      });
}

/// Newton's direction, in which a careful step goes no further than rays have looked.
template <int dim>
std::string RayNewton<dim>::find_direction(Vectors &direction)
{
  for (unsigned int attempt = 0;; ++attempt)
  {
    if (std::string trouble = find_forces(); !trouble.empty())
      return trouble;
    follow_forces(direction);
    if (!plan.careful || attempt == most_rises || !goes_too_far(direction))
      return "";
    if (!resist_more())
      return why_not();
  }
}

template <int dim>
void RayNewton<dim>::go(const Start &from, const Vectors &direction, const double share)
{
  for (unsigned int b = 0; b < way.size(); ++b)
    way[b] = from.way[b] + share * direction[b];
  for (unsigned int f = 0; f < force.size(); ++f)
    for (unsigned int k = 0; k < force[f].size(); ++k)
    {
      // A force that is what adhesion leaves of it is that exactly.
      force[f][k] = share == 1. ? system.found[f][k]
                                : from.force[f][k] + share * (system.found[f][k] - from.force[f][k]);
      rubbing[f][k] = from.rubbing[f][k] + share * (system.found_rubbing[f][k] - from.rubbing[f][k]);
    }
  for (unsigned int w = 0; w < from.walls.size(); ++w)
    system.ways[w].at = from.walls[w] + share * (system.found_ways[w] - from.walls[w]);
}

/// Goes as far as there is a state that can be evaluated. @return why there is none
template <int dim>
std::string RayNewton<dim>::go_along(const Vectors &direction)
{
  Start from{force, rubbing, way, {}};
  for (const FreeWay<dim> &free : system.ways)
    from.walls.push_back(free.at);
  const Farthest largest = farthest(direction);
  double share = largest.place > longest_way * h ? longest_way * h / largest.place : 1.;
  matrices.assembled = false;
  bool too_much = false;
  for (unsigned int halving = 0;; ++halving, share *= 0.5)
  {
    const bool too_long = too_much && plan.may_be_shorter();
    if (halving == most_halvings || (too_long && strained_in_a_row == most_strained))
    {
      outcome.too_long = too_long;
      return "no way along Newton's direction: " + why_not();
    }
    path += share * std::max(largest.place, largest.node);
    go(from, direction, share);
    if (evaluate(way))
      break;
    too_much = not_met == none;
    // A side ends there: the way to its end would be halved again and again.
    if (halving >= halvings_with_all_rays && leave_unmet_rays() && evaluate(way))
      break;
  }
  strained_in_a_row = too_much ? strained_in_a_row + 1 : 0;
  return "";
}

template <int dim>
std::string RayNewton<dim>::iterate()
{
  Vectors direction = at_rest;
  if (std::string trouble = find_direction(direction); !trouble.empty())
    return trouble;
  const double residual_before = residual;
  if (std::string trouble = go_along(direction); !trouble.empty())
    return trouble;
  measure();
  // Masses make most of the matrix: near the end it need not be the latest.
  matrices.serve =
      inertia && residual < old_factors_below && (!matrices.serve || residual < 0.1 * residual_before);
  return "";
}

/// Adhesion is that of the gaps at the start of the step. Where it holds what is apart, rays begin with it.
template <int dim>
void RayNewton<dim>::begin_to_pull()
{
  if constexpr (dim == 2)
    for (FrameState<2> &frame : frames)
      FrameAdhesion<2>::find_pulls(frame, scene, plan.held);
  take_forces_of_start();
}

/// Goes where bodies go by themselves, or without inertia where the last step went; what turns inside out
/// there sets out from rest. Held steps begin at rest. Rays know first where they are when the step begins.
template <int dim>
bool RayNewton<dim>::begin()
{
  const bool adheres = scene.adhesion != nullptr;
  const bool goes_on = inertia || (!plan.held && std::any_of(world.bodies.begin(), world.bodies.end(),
                                                             [](const Body<dim> &body)
                                                             { return body.nodes.kept.size() > 0; }));
  if (goes_on || adheres)
    if (!meet(way))
      leave_unmet_rays();
  if (adheres)
    begin_to_pull();
  if (goes_on)
  {
    way = free_way();
    for (const Eigen::VectorXd &of_body : way)
      path = std::max(path, h + of_body.template lpNorm<Eigen::Infinity>());
    if (evaluate(way))
      return true;
    path += path;
    way = at_rest;
  }
  return evaluate(way);
}

template <int dim>
std::string RayNewton<dim>::converge()
{
  lay();
  keep_dents();
  if (!begin() && !(leave_unmet_rays() && evaluate(way)))
    return why_not();
  measure();
  for (outcome.newton_iterations = 0;; ++outcome.newton_iterations)
  {
    stop_if_interrupted();
    // An iteration has found that a minimum is near.
    const bool may_end = outcome.newton_iterations > 0;
    outcome.exact = may_end && converged();
    if (outcome.exact || (may_end && good_enough()))
      break;
    if (outcome.newton_iterations == world.settings.max_newton)
      return "Newton did not converge in " + std::to_string(world.settings.max_newton) +
             " iterations ('Newton/Maximum iterations'); relative residual " + short_number(residual);
    if (std::string trouble = or_why_it_failed([this]() { return iterate(); }); !trouble.empty())
      return trouble;
  }
  outcome.newton_residual = residual;
  outcome.max_penetration = deepest;
  outcome.contact_sweeps = system.passes;
  return "";
}

template class RayNewton<2>;
template class RayNewton<3>;
} // namespace softgrain::mpm
