// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_time_integrator_h
#define softgrain_mpm_stepping_time_integrator_h

#include <softgrain/base/registry.h>
#include <softgrain/mpm/stepping/time_scheme.h>

namespace softgrain::mpm
{
struct Problem;
struct State;
struct StepOutcome;
struct Workspace;

/**
 * @brief A way to make a step: `Time/Scheme` names a member of this family.
 *
 * Most are a choice of terms() and implicit_step() with them.
 */
class TimeIntegrator
{
public:
  virtual ~TimeIntegrator() = default;

  /// The terms of its equation. @param theta 'Time/Theta'
  virtual TimeScheme terms(double theta) const = 0;

  /**
   * @brief One attempt at a step; the state goes on only if it is accepted.
   * @param problem what is solved
   * @param state to be moved
   * @param work  what steps work with
   * @param dt length of the step [s]
   * @param wanted length of steps that need not be cut [s]
   */
  virtual StepOutcome
  step(const Problem &problem, State &state, Workspace &work, double dt, double wanted) const = 0;

  /**
   * @brief Goes from where a step of length @p dt [s] ended to what may be written, while time stands still;
   * most schemes are there.
   * @throw ComputationError when it is not found
   */
  virtual StepOutcome settle(const Problem &problem, State &state, Workspace &work, double dt) const;
};
} // namespace softgrain::mpm

template <>
softgrain::Registry<softgrain::mpm::TimeIntegrator> &
softgrain::Registry<softgrain::mpm::TimeIntegrator>::instance();

#endif
