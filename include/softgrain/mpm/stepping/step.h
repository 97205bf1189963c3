// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_step_h
#define softgrain_mpm_stepping_step_h

#include <softgrain/mpm/model/problem.h>
#include <softgrain/mpm/model/state.h>
#include <softgrain/mpm/model/workspace.h>

#include <Eigen/Core>

#include <limits>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/// What a step is to do.
struct StepPlan
{
  double dt = 0;             ///< [s]
  bool held = false;         ///< walls and loads stand still and no time passes: the bodies come to balance
  double regularisation = 0; ///< of quasi_static: stiffness against motion per body, over Young's modulus
  /// Newton's method goes on to its tolerances. A held step that is only on the way to balance may end
  /// sooner.
  bool exact = true;
  /// Bodies resist so much that none goes further than rays have looked. That is for a step that
  /// has failed, as under a load that nothing bears yet: it would take bodies into others that no ray has
  /// seen.
  bool careful = false;
  /// Regularisation from which on a step without a minimum fails, in place of one in which bodies resist
  /// more.
  double most_resistance = std::numeric_limits<double>::max();

  /// Whether the step may fail, for it is made shorter then.
  bool may_be_shorter() const { return most_resistance < std::numeric_limits<double>::max(); }
  /// Time that passes for laws; none while bodies come to balance [s].
  double law_dt() const { return held ? 0. : dt; }
};

/// What a step tried and found; only an accepted one is written into the state.
struct StepOutcome
{
  bool accepted = false;
  std::string reason;    ///< why not: names body, place and what happened
  double share = 0.5;    ///< of the step with which it is to be tried again when it is not accepted
  bool law_asks = false; ///< it is not accepted only because a law asks for a shorter one
  unsigned int newton_iterations = 0, contact_sweeps = 0;
  double newton_residual = 0, contact_residual = 0, max_penetration = 0;
  double largest_move = 0;     ///< of a node over the step [m]
  unsigned int held_steps = 0; ///< of quasi_static, after the step itself
  double raised = 1;           ///< factor by which bodies had to resist motion more
  double unbalanced = 0;       ///< unbalanced_force() at the end, of quasi_static
  bool exact = true;           ///< Newton's method came to its tolerances
  bool too_long = false;       ///< it is not accepted, and a shorter one may be: more resistance is no help
};

/// One implicit step (moreau_jean, newmark, quasi_static); @p state goes on only if it is accepted.
StepOutcome implicit_step(const Problem &problem, State &state, Workspace &work, const StepPlan &plan);

/// One step of symplectic Euler.
StepOutcome explicit_step(const Problem &problem, State &state, Workspace &work, double dt);
} // namespace softgrain::mpm

#endif
