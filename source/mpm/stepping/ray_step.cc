// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/interruption.h>
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/contact/frame_memory.h>
#include <softgrain/mpm/contact/frame_rows.h>
#include <softgrain/mpm/stepping/accept_step.h>
#include <softgrain/mpm/stepping/begin_step.h>
#include <softgrain/mpm/stepping/contact_work.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/judge_step.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/ray_equations.h>
#include <softgrain/mpm/stepping/ray_step.h>
#include <softgrain/mpm/stepping/refused_step.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace softgrain::mpm
{
namespace
{
constexpr double gap_tolerance = 1e-5;    ///< cells
constexpr unsigned int most_halvings = 8; ///< of a way that cannot be gone
constexpr unsigned int halvings_with_all_rays = 2;
constexpr double rise = 10.; ///< of what resists motion, where a step has no minimum
constexpr unsigned int most_rises = 8;
constexpr double back_from = 100.;         ///< rise from which on a step begins anew
constexpr double keeps_dents_from = 0.3;   ///< resistance
constexpr double old_factors_below = 1e-2; ///< residual from which on factors serve for more iterations
constexpr double longest_way = 0.3;        ///< of a node in an iteration [cells]

/// A step that finds balance.
class RayStep : private RayEquations
{
public:
  using RayEquations::RayEquations;

  std::string find();
  void accept(State &state_to_change);

  StepOutcome outcome;
  bool careful = false;                                        ///< bodies go no further than rays have looked
  double most_resistance = std::numeric_limits<double>::max(); ///< from which on the step has failed

private:
  bool converged() const
  {
    return (residual < problem.settings.residual_tolerance || at_rounding()) && deepest < gap_tolerance * h &&
           right_inertia;
  }
  bool begin();
  void begin_to_pull();
  void hand_over_rows();
  std::string find_forces();
  bool resist_more();
  bool go_back();
  bool keep_dents();
  bool goes_too_far(const Vectors &direction) const;
  void find_direction(Vectors &direction);
  std::string iterate();

  bool right_inertia = false;
  bool dents_kept = false;
  std::optional<unsigned int> negative; ///< pivots of all bodies' matrices as last factorised
  bool factors_serve = false;           ///< these serve for another iteration
};

/// Forces of rays for Newton's equations; bodies resist more where these have no minimum.
std::string RayStep::find_forces()
{
  Vectors y(way.size());
  for (unsigned int attempt = 0;; ++attempt)
  {
    if (!factors_serve)
    {
      assemble();
      negative = factorise();
    }
    if (negative)
    {
      {
        dealii::TimerOutput::Scope section(*work.timer, "linear solves");
        work.share.for_mine(state.bodies,
                            [&](const Body<2> &body)
                            {
                              work.solvers[body.index]->solve(equations.missing(body.index), y[body.index]);
                              y[body.index] *= theta * plan.dt;
                            });
      }
      {
        dealii::TimerOutput::Scope section(*work.timer, "condensation");
        // In the first iteration walls have moved and bodies have not.
        system.condense(scene, frames, force, rubbing,
                        candidates_within() + (outcome.newton_iterations == 0 ? largest_way() : 0.), y);
      }
      dealii::TimerOutput::Scope section(*work.timer, "contact solve");
      if (system.solve(h, *negative) && system.wrong_inertia(*negative) == 0)
        return "";
    }
    if (factors_serve)
    {
      factors_serve = false;
      continue;
    }
    if (inertia || attempt == most_rises || outcome.raised * plan.regularisation >= most_resistance)
      return "no forces of contacts are found";
    if (!resist_more())
      return why_not();
  }
}

bool RayStep::resist_more()
{
  outcome.raised *= rise;
  equations.resist_more(rise);
  const bool kept_now = keep_dents();
  if (outcome.newton_iterations > 0 && outcome.raised >= back_from)
    return go_back();
  if (kept_now)
    return evaluate(way);
  // Nothing has moved: rays stand as they are.
  return equations.evaluate(trial);
}

/// To where the step began: iterates without a minimum may have gone where no resistance brings them back, as
/// matter that flows does. Walls under loads stay where they have come to.
bool RayStep::go_back()
{
  way = at_rest;
  take_forces_of_start();
  path += h;
  const bool is_there = evaluate(way);
  measure();
  return is_there;
}

/// Where bodies resist much. @return whether any is now kept that was not before
bool RayStep::keep_dents()
{
  if (dents_kept || plan.regularisation * outcome.raised < keeps_dents_from)
    return false;
  for (FrameState<2> &frame : frames)
    frame.keep_dent();
  return dents_kept = true;
}

/// Whether a node would go further than rays have looked.
bool RayStep::goes_too_far(const Vectors &direction) const
{
  double farthest = 0.;
  for (unsigned int b = 0; b < way.size(); ++b)
    farthest = std::max(farthest, (way[b] + direction[b]).lpNorm<Eigen::Infinity>());
  return farthest > scene.reach;
}

void RayStep::find_direction(Vectors &direction)
{
  dealii::TimerOutput::Scope section(*work.timer, "linear solves");
  work.share.for_mine(
      state.bodies,
      [&](const Body<2> &body)
      {
        const unsigned int b = body.index;
        if (system.frames_of[b].empty())
          equations.solve_free(b, direction[b]);
        else
          work.solvers[b]->solve(equations.missing(b) + plan.dt * system.force_on(b), direction[b]);
        direction[b] *= theta * plan.dt;
      },
      [&](BodyShare::Message &message) { message.add(state.bodies, direction); });
}

std::string RayStep::iterate()
{
  Vectors direction = at_rest;
  for (unsigned int attempt = 0;; ++attempt)
  {
    if (std::string trouble = find_forces(); !trouble.empty())
      return trouble;
    find_direction(direction);
    if (!careful || attempt == most_rises || !goes_too_far(direction))
      break;
    if (!resist_more())
      return why_not();
  }
  right_inertia = true;
  double largest = 0.;
  for (unsigned int b = 0; b < direction.size(); ++b)
    if (!system.frames_of[b].empty()) // the others meet nothing on their way
      largest = std::max(largest, direction[b].lpNorm<Eigen::Infinity>());
  std::vector<double> gone;
  for (unsigned int w = 0; w < system.ways.size(); ++w)
  {
    gone.push_back(system.ways[w].at);
    largest = std::max(largest, std::abs(system.found_ways[w] - gone[w]));
  }
  double share = largest > longest_way * h ? longest_way * h / largest : 1.;
  const RayForces before = force, rubbed = rubbing;
  const Vectors from = way;
  for (unsigned int halving = 0;; ++halving, share *= 0.5)
  {
    if (halving == most_halvings)
      return "no way along Newton's direction: " + why_not();
    path += share * largest;
    for (unsigned int b = 0; b < way.size(); ++b)
      way[b] = from[b] + share * direction[b];
    for (unsigned int f = 0; f < force.size(); ++f)
      for (unsigned int k = 0; k < force[f].size(); ++k)
      {
        // A force that is what adhesion leaves of it is that exactly.
        force[f][k] =
            share == 1. ? system.found[f][k] : before[f][k] + share * (system.found[f][k] - before[f][k]);
        rubbing[f][k] = rubbed[f][k] + share * (system.found_rubbing[f][k] - rubbed[f][k]);
      }
    for (unsigned int w = 0; w < gone.size(); ++w)
      system.ways[w].at = gone[w] + share * (system.found_ways[w] - gone[w]);
    if (evaluate(way))
      break;
    // A side ends there: the way to its end would be halved again and again.
    if (halving >= halvings_with_all_rays && leave_unmet_rays() && evaluate(way))
      break;
  }
  const double residual_before = residual;
  measure();
  // Masses make most of the matrix: near the end it need not be the latest.
  factors_serve =
      inertia && residual < old_factors_below && (!factors_serve || residual < 0.1 * residual_before);
  return "";
}

/// Adhesion is that of the gaps at the start of the step. Where it holds what is apart, rays begin with it.
void RayStep::begin_to_pull()
{
  for (FrameState<2> &frame : frames)
    frame.find_pulls(scene, plan.held);
  take_forces_of_start();
}

/// Goes where bodies go by themselves; what turns inside out there sets out from rest.
bool RayStep::begin()
{
  const bool adheres = scene.adhesion != nullptr;
  if (inertia || adheres)
    if (!meet(way))
      leave_unmet_rays();
  if (adheres)
    begin_to_pull();
  if (!inertia)
    return evaluate(way);
  way = free_way();
  for (const Eigen::VectorXd &of_body : way)
    path = std::max(path, h + of_body.lpNorm<Eigen::Infinity>());
  if (evaluate(way))
    return true;
  path += path;
  way = at_rest;
  return evaluate(way);
}

std::string RayStep::find()
{
  outcome.unsolved = true;
  lay();
  keep_dents();
  if (!begin() && !(leave_unmet_rays() && evaluate(way)))
    return why_not();
  measure();
  for (outcome.newton_iterations = 0;; ++outcome.newton_iterations)
  {
    stop_if_interrupted();
    if (outcome.newton_iterations > 0 && converged())
      break;
    if (outcome.newton_iterations == problem.settings.max_newton)
      return "Newton did not converge in " + std::to_string(problem.settings.max_newton) +
             " iterations ('Newton/Maximum iterations'); relative residual " + short_number(residual);
    if (std::string trouble = iterate(); !trouble.empty())
      return trouble;
  }
  outcome.newton_residual = residual;
  outcome.unsolved = false;
  outcome.max_penetration = deepest;
  outcome.contact_sweeps = system.passes;
  if (inertia && walls_are_on_their_way(work))
    return "a wall under a load would go further than 'Wall motion' allows";
  heed_laws(state.bodies, equations.stress_outcome(), outcome);
  if (outcome.law_asks)
    return outcome.reason;
  hand_over_rows();
  const std::string given =
      inertia ? why_contact_gives(problem, state, work, plan.dt, motion, equations.increment) : "";
  if (!given.empty())
  {
    outcome.gives_energy = true;
    return given;
  }
  return judge_step(problem, state, work, motion, plan.dt, equations.increment, outcome);
}

/// Rays that carry force, as those who keep accounts want them.
void RayStep::hand_over_rows()
{
  ContactMemory<2> memory;
  memory.step = plan.dt;
  std::vector<ContactRow<2>> rows = rows_of_frames(scene, frames, force, rubbing, memory);
  work.contact.held = false; // dents are those of the frames
  work.contact.reinit(std::move(rows), work.share, false, state.bodies, plan.dt, &memory);
}

void RayStep::accept(State &state_to_change)
{
  // Of a body: what the scheme or what resists takes from it, and what resists it.
  std::vector<StepEquations::Told> told(way.size(), std::array<double, 5>{});
  work.share.for_mine(
      state.bodies,
      [&](const Body<2> &body)
      {
        const unsigned int b = body.index;
        const FrameState<2>::Vector resistance = equations.resistance(b);
        told[b] = {equations.regularisation_work(b), equations.scheme_damping(b, trial[b]), resistance[0],
                   resistance[1], inertia ? 0. : equations.held_back(b)};
        if (inertia)
          spread_imbalance(body, equations.missing(b) + plan.dt * contact_forces(b), trial[b]);
      },
      [&](BodyShare::Message &message)
      {
        message.add(state.bodies, trial);
        equations.tell(told, message);
      });
  Vectors rate(way.size());
  FoundStep found{plan,
                  motion,
                  trial,
                  equations.internal,
                  equations.increment,
                  rate,
                  plan.held || inertia ? equations.external
                                       : external_forces(state.bodies, work.share, problem.scene.gravity,
                                                         state.time + 0.5 * plan.dt), // for their work
                  std::vector<double>(way.size(), 0.),
                  0.,
                  {}};
  if (!inertia)
    state_to_change.held_back.resize(way.size());
  for (unsigned int b = 0; b < way.size(); ++b)
  {
    rate[b] = way[b] / plan.dt;
    found.regularisation_work += told[b][0];
    found.scheme_damping[b] = told[b][1];
    if (!inertia)
    {
      found.resistance.push_back(FrameState<2>::Vector({told[b][2], told[b][3]}));
      state_to_change.held_back[b] = told[b][4];
    }
    outcome.largest_move = std::max(outcome.largest_move, way[b].lpNorm<Eigen::Infinity>());
  }
  for (unsigned int f = 0; f < frames.size() && !inertia; ++f)
    for (const unsigned int side : {0, 1})
      if (const unsigned int b = frames[f].unknown(side); b != FrameState<2>::none)
        state_to_change.held_back[b] += frames[f].pull_to_come(scene);
  std::vector<ContactFrame<2>> &kept = state_to_change.frames;
  kept.clear();
  for (unsigned int f = 0; f < frames.size(); ++f)
    kept.push_back(frames[f].after(scene, force[f], rubbing[f]));
  accept_step(problem, state_to_change, work, found);
}
} // namespace

StepOutcome ray_step(const Problem &problem,
                     State &state,
                     Workspace &work,
                     const StepPlan &plan,
                     const bool careful,
                     const double most_resistance)
{
  std::vector<WallMotion<2>> motion = begin_step(problem, state, work, plan);
  renew_outlines(state.bodies, work.outlines, state.frames);
  RayStep step(problem, state, work, plan, motion);
  step.careful = careful;
  step.most_resistance = most_resistance;
  step.outcome.reason = step.find();
  step.outcome.accepted = step.outcome.reason.empty();
  if (step.outcome.accepted)
    step.accept(state);
  return step.outcome;
}
} // namespace softgrain::mpm
