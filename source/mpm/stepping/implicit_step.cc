// SPDX-License-Identifier: LGPL-2.1-or-later
// One implicit step with rows that are found once, line by line as doc/theory.md tells it in "One step".
#include <softgrain/base/interruption.h>
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/stepping/accept_step.h>
#include <softgrain/mpm/stepping/begin_step.h>
#include <softgrain/mpm/stepping/contact_work.h>
#include <softgrain/mpm/stepping/judge_step.h>
#include <softgrain/mpm/stepping/newton_search.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/ray_step.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/step_contact.h>
#include <softgrain/mpm/stepping/step_equations.h>
#include <softgrain/mpm/stepping/step_rows.h>

#include <algorithm>
#include <array>

namespace softgrain::mpm
{
namespace
{
using Vectors = StepEquations::Vectors;

/// Newton's method with contact for the velocities v⁺ at the end of a step.
class ImplicitStep
{
public:
  ImplicitStep(const Problem &problem,
               const State &state,
               Workspace &work,
               const StepPlan &plan,
               std::vector<WallMotion<2>> &motion)
      : problem(problem)
      , state(state)
      , work(work)
      , plan(plan)
      , motion(motion)
      , equations(problem, state, work, plan)
      , contact(problem, state, work, plan, motion, equations, outcome)
      , search(problem, state, work, equations)
      , trial(state.bodies.size())
      , direction(state.bodies.size())
  {
  }

  /// Looks for v⁺. @return why it is not found, empty when it is
  std::string find()
  {
    if (!first_guess())
      return equations.why_not();
    for (outcome.newton_iterations = 0;; ++outcome.newton_iterations)
    {
      stop_if_interrupted();
      if (in_balance())
        return at_end();
      if (outcome.newton_iterations == problem.settings.max_newton)
        return "Newton did not converge in " + std::to_string(problem.settings.max_newton) +
               " iterations ('Newton/Maximum iterations'); relative residual " +
               short_number(outcome.newton_residual) + ", 'Newton/Residual tolerance' is " +
               short_number(problem.settings.residual_tolerance) + "; most of it at " +
               equations.worst_body();
      if (std::string trouble = newton_step(); !trouble.empty())
        return trouble;
    }
  }

  /// Writes what find() has found into @p state.
  void accept(State &state_to_change);

  StepOutcome outcome;

private:
  bool first_guess();
  bool in_balance();
  std::string newton_step();
  std::string iterate();
  std::string at_end();

  const Problem &problem;
  const State &state;
  Workspace &work;
  const StepPlan &plan;
  std::vector<WallMotion<2>> &motion;
  StepEquations equations;
  StepContact contact;
  NewtonSearch search;
  Vectors trial, direction; ///< v⁺ of owned bodies, and where Newton's method sends it [m/s]
};

// v⁺ = v: bodies go on as they did. A guess that turns a point inside out is replaced by rest. Returns false
// when that fails too, and the step is too long. Then w = H v⁺.
bool ImplicitStep::first_guess()
{
  for (const bool rest : {false, true})
  {
    for (unsigned int b = 0; b < trial.size(); ++b)
      if (work.share.mine(b))
        trial[b] =
            rest ? Eigen::VectorXd::Zero(state.bodies[b].field.n_dofs()) : state.bodies[b].nodes.velocity;
    if (!equations.evaluate(trial))
      continue;
    follow_free_walls(problem, work, motion);
    find_rows(problem, state, work, motion, plan.dt);
    equations.rows_changed();
    return true;
  }
  return false;
}

// M (v⁺ - v) = Δt [(1-θ) f_old + θ f⁺ + f_ext] + Hᵀ P, and contact, to the tolerances.
bool ImplicitStep::in_balance()
{
  if (outcome.newton_iterations == 0)
    return false;
  outcome.newton_residual = equations.residual();
  return contact.converged() && search.converged();
}

// One iteration; factors of the one before that turn out to be too old are made anew.
std::string ImplicitStep::newton_step()
{
  const bool old_factors = search.factors_serve;
  const auto try_it = [this]() { return iterate(); };
  std::string trouble = or_why_it_failed(try_it);
  if (trouble.empty() || !old_factors)
    return trouble;
  search.factors_serve = false;
  return or_why_it_failed(try_it);
}

std::string ImplicitStep::iterate()
{
  const bool condensed = problem.settings.coupling == ContactCoupling::condensed,
             new_factors = !search.factors_serve, touches = !work.contact.empty();
  if (new_factors)
  {
    const std::string trouble = equations.factorise(); // A = M + θ² Δt² K
    stop_if_interrupted();
    if (!trouble.empty())
      return trouble;
  }
  if (condensed && touches && new_factors)
    contact.condense(); // W = H A⁻¹ Hᵀ
  StepEquations::Slope slope;
  if (condensed || !touches)
    slope = equations.solve(false, direction); // A (v⁺ - v⁺ᵢ) = missing impulse
  if (touches)
  {
    const std::string trouble = // P by Signorini and Coulomb
        condensed ? contact.solve_condensed(trial, direction) : contact.solve_lumped(trial);
    if (!trouble.empty())
      return trouble;
    slope = equations.solve(true, direction); // A (v⁺ - v⁺ᵢ) = missing impulse + Hᵀ P
  }
  return search.go(trial, direction, slope, outcome.newton_iterations == 0);
}

// Whether a step in balance may be taken as it is. @return why not; empty too when a law asks for a shorter
// one, which the outcome tells
std::string ImplicitStep::at_end()
{
  settle_free_walls(problem, state, work, motion);
  if (walls_are_on_their_way(work))
    return "a wall under a load would go further than 'Wall motion' allows";
  for (const double gap : end_gaps(state, work, equations.increment, motion, plan.dt))
    outcome.max_penetration = std::max(outcome.max_penetration, -gap);
  heed_laws(state.bodies, equations.stress_outcome(), outcome);
  if (outcome.law_asks)
    return outcome.reason;
  const std::string given = why_contact_gives(problem, state, work, plan.dt, motion, equations.increment);
  return given.empty() ? judge_step(problem, state, work, motion, plan.dt, equations.increment, outcome)
                       : given;
}

void ImplicitStep::accept(State &state_to_change)
{
  // Of a body: what the scheme takes from it, and what holds it against turning.
  std::vector<StepEquations::Told> told(trial.size());
  work.share.for_mine(
      state.bodies,
      [&](const Body<2> &body)
      {
        const unsigned int b = body.index;
        const BodyTerms<2> &terms = equations.terms(b);
        told[b] = {terms.damping(body, trial[b], equations.increment[b], equations.internal[b]),
                   terms.regularisation_work(body, equations.increment[b])};
        spread_imbalance(body, equations.unbalanced(b), trial[b]);
      },
      [&](BodyShare::Message &message)
      {
        message.add(state.bodies, trial);
        equations.tell(told, message);
      });
  Vectors rate(trial.size());
  for (unsigned int b = 0; b < trial.size(); ++b)
    if (work.share.mine(b) || equations.external[b].size() > 0)
      rate[b] = equations.increment[b] / plan.dt;
  FoundStep found{plan,
                  motion,
                  trial,
                  equations.internal,
                  equations.increment,
                  rate,
                  equations.external,
                  equations.load_times()};
  for (unsigned int b = 0; b < trial.size(); ++b)
  {
    found.losses.add(loss::scheme, told[b][0]);
    found.losses.add(loss::regularisation, told[b][1]);
  }
  accept_step(problem, state_to_change, work, found);
}
} // namespace

StepOutcome implicit_step(const Problem &problem, State &state, Workspace &work, const StepPlan &plan)
{
  if (problem.settings.meets_by_rays())
    return ray_step(problem, state, work, plan);
  std::vector<WallMotion<2>> motion = begin_step(problem, state, work, plan);
  ImplicitStep step(problem, state, work, plan, motion);
  step.outcome.reason = step.find();
  step.outcome.accepted = step.outcome.reason.empty();
  if (step.outcome.accepted)
    step.accept(state);
  return step.outcome;
}
} // namespace softgrain::mpm
