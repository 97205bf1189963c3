// SPDX-License-Identifier: LGPL-2.1-or-later
// One implicit step, line by line as doc/theory.md tells it in "One step".
#include <softgrain/base/interruption.h>
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/contact/moved_boundary.h>
#include <softgrain/mpm/stepping/accept_step.h>
#include <softgrain/mpm/stepping/begin_step.h>
#include <softgrain/mpm/stepping/contact_work.h>
#include <softgrain/mpm/stepping/following_rows.h>
#include <softgrain/mpm/stepping/given_energy.h>
#include <softgrain/mpm/stepping/judge_step.h>
#include <softgrain/mpm/stepping/newton_search.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/ray_step.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/step_contact.h>
#include <softgrain/mpm/stepping/step_equations.h>

#include <algorithm>
#include <array>

namespace softgrain::mpm
{
namespace
{
using Vectors = StepEquations::Vectors;

constexpr unsigned int searches_before_mixing = 4; ///< for contact rows, with inertia
/// For rows without friction, with inertia or where walls are free: where rows do not settle, contact gives
/// energy, and a refused step is made in several shorter ones.
constexpr unsigned int searches_to_settle = 20;

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
      , rows(problem, state, work, plan.dt, motion)
      , contact(problem, state, work, plan, motion, equations, outcome)
      , search(problem, state, work, equations)
      , trial(state.bodies.size())
      , direction(state.bodies.size())
  {
  }

  /// Looks for v⁺. @return why it is not found, empty when it is
  std::string find()
  {
    outcome.unsolved = true;
    if (!first_guess())
      return equations.why_not();
    for (outcome.newton_iterations = 0;; ++outcome.newton_iterations)
    {
      stop_if_interrupted();
      const double lag = rows.lag(equations.increment);
      const bool settled = rows.settled(lag);
      if (in_balance() && (settled || rows.searches() >= most_searches()))
        return at_end(settled);
      if (rows_go_on(settled))
        find_rows_again(lag);
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
  void find_rows(bool again);
  void find_rows_again(double lag);
  bool rows_go_on(bool settled) const;
  unsigned int most_searches() const;
  void move_to(const Vectors &increment);
  bool in_balance();
  std::string newton_step();
  std::string iterate();
  std::string at_end(bool settled);
  std::string too_deep();

  const Problem &problem;
  const State &state;
  Workspace &work;
  const StepPlan &plan;
  std::vector<WallMotion<2>> &motion;
  StepEquations equations;
  FollowingRows rows;
  StepContact contact;
  NewtonSearch search;
  Vectors trial, direction; ///< v⁺ of this rank's bodies, and where Newton's method sends it [m/s]
};

// v⁺ = v: bodies go on as they did; without inertia they stay. A guess that turns a point inside out is
// replaced by rest. Returns false when that fails too, and the step is too long
bool ImplicitStep::first_guess()
{
  for (const bool rest : {!problem.settings.scheme.inertia && plan.guess == nullptr, true})
  {
    for (unsigned int b = 0; b < trial.size(); ++b)
      if (work.share.mine(b))
        trial[b] = rest                    ? Eigen::VectorXd::Zero(state.bodies[b].field.n_dofs())
                   : plan.guess == nullptr ? state.bodies[b].velocity
                                           : Eigen::VectorXd((*plan.guess)[b] / plan.dt);
    if (!equations.evaluate(trial))
      continue;
    find_rows(false);
    return true;
  }
  return false;
}

// w = H v⁺: rows of the step as it comes out.
void ImplicitStep::find_rows(const bool again)
{
  follow_free_walls(problem, work, motion);
  rows.find(equations.increment, again);
  equations.rows_changed();
  contact.rows_changed();
}

void ImplicitStep::find_rows_again(const double lag)
{
  // With inertia a few searches mostly do; mixing costs an evaluation of the stress.
  if (!problem.settings.scheme.inertia || rows.searches() >= searches_before_mixing)
  {
    Vectors next = equations.increment;
    if (rows.mix(next, lag, outcome.newton_residual))
      move_to(next);
  }
  find_rows(true);
}

// Whether rows are found again. Those that stay make rotation unstable, and whatever else a tangent holds
// stable that has them follow; else the last few iterations are fast with rows that stay.
bool ImplicitStep::rows_go_on(const bool settled) const
{
  if (settled)
    return problem.settings.rows_follow() && problem.settings.scheme.inertia &&
           outcome.newton_iterations > 0 && equations.rotation_chases_rows();
  return rows.searches() < most_searches() || !equations.rotation_is_gauge() || equations.pressure_follows();
}

unsigned int ImplicitStep::most_searches() const
{
  const Settings &settings = problem.settings;
  const bool must_settle =
      problem.slippery() && (settings.scheme.inertia || !work.contact.free_walls.list.empty());
  return must_settle ? std::max(settings.max_searches, searches_to_settle) : settings.max_searches;
}

// Goes to these increments, unless a point turns inside out there.
void ImplicitStep::move_to(const Vectors &increment)
{
  const Vectors before = trial;
  for (unsigned int b = 0; b < trial.size(); ++b)
    if (equations.moves(b) && work.share.mine(b))
      trial[b] += (increment[b] - equations.increment[b]) / (problem.settings.scheme.theta * plan.dt);
  if (equations.evaluate(trial))
    return;
  trial = before;
  equations.evaluate(trial);
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
  if (condensed && touches)
    contact.condense(new_factors); // W = H A⁻¹ Hᵀ
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
std::string ImplicitStep::at_end(const bool settled)
{
  outcome.unsolved = false;
  outcome.rows_follow = settled || rows.follow(equations.increment);
  settle_free_walls(problem, state, work, motion);
  if (problem.settings.scheme.inertia && walls_are_on_their_way(work))
    return "a wall under a load would go further than 'Wall motion' allows";
  const std::string overlap = too_deep();
  heed_laws(state.bodies, equations.stress_outcome(), outcome);
  if (outcome.law_asks || !overlap.empty())
    return outcome.law_asks ? outcome.reason : overlap;
  outcome.gives_energy = GivenEnergy(problem, state, work, plan, motion, equations)
                             .is_given(settled, outcome.max_penetration - rows.penetration_at_start());
  if (outcome.gives_energy)
    return "contact would give energy: rows and bodies do not settle; most is unbalanced at " +
           equations.worst_body();
  const std::string given = problem.settings.scheme.inertia ? why_contact_gives(problem, state, work, plan.dt,
                                                                                motion, equations.increment)
                                                            : "";
  return given.empty() ? judge_step(problem, state, work, motion, plan.dt, equations.increment, outcome)
                       : given;
}

// Why the step may not end: bodies are deeper in each other than is allowed, and than they were; or empty.
std::string ImplicitStep::too_deep()
{
  const double h = problem.lattice->cell_size();
  outcome.max_penetration = rows.penetration(equations.increment);
  if (!problem.settings.rows_follow())
    return "";
  const double allowed = problem.settings.largest_penetration * h;
  if (outcome.max_penetration <= std::max(allowed, rows.penetration_at_start()))
    return "";
  return "bodies are " + short_number(outcome.max_penetration / h) +
         " cells deep in each other or in walls, which is more than 'Contact/Largest penetration' allows";
}

void ImplicitStep::accept(State &state_to_change)
{
  const bool inertia = problem.settings.scheme.inertia;
  // Of a body: its largest move, what the scheme takes from it, and what resists it.
  std::vector<StepEquations::Told> told(trial.size());
  work.share.for_mine(
      state.bodies,
      [&](const Body<2> &body)
      {
        const unsigned int b = body.index;
        const dealii::Tensor<1, 2> resistance = equations.resistance(b);
        told[b] = {largest_way(body, equations.increment[b]), equations.scheme_damping(b, trial[b]),
                   equations.regularisation_work(b), resistance[0], resistance[1]};
        if (inertia)
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
                  std::vector<double>(trial.size(), 0.),
                  0.,
                  {},
                  {}};
  for (unsigned int b = 0; b < trial.size(); ++b)
  {
    outcome.largest_move = std::max(outcome.largest_move, told[b][0]);
    found.scheme_damping[b] = told[b][1];
    found.regularisation_work += told[b][2];
    if (!inertia)
      found.resistance.push_back(dealii::Tensor<1, 2>({told[b][3], told[b][4]}));
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
