// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_time_integrator_h
#define softgrain_mpm_stepping_time_integrator_h

#include <softgrain/base/registry.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/stepping/body_terms.h>
#include <softgrain/mpm/stepping/time_scheme.h>

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <memory>

namespace softgrain::mpm
{
struct Problem;
struct State;
struct StepOutcome;
struct StepPlan;
struct Workspace;

/// What is known of a body as a step begins.
struct BodyStart
{
  const Body<2> &body;
  const TimeScheme &scheme;
  const StepPlan &plan;
  /// A round body that nothing holds is the same when it is turned: without inertia, that it stays is a
  /// choice of one of many equal answers. Steps with inertia that resolve no hit hold its spin, too.
  bool nothing_turns_it;
  const Eigen::VectorXd &load;     ///< on its nodes, empty where there is none [N/m]
  dealii::Tensor<1, 2> resistance; ///< what has resisted its motion at the end of the step before [N/m]
  double softest;                  ///< Young's modulus of the softest body of the scene [Pa]
};

/// What has become of a body in a step.
struct BodyEnd
{
  const Body<2> &before; ///< as the step began
  const StepPlan &plan;
  const Eigen::VectorXd &velocity; ///< of the nodes at the end [m/s]
  const Eigen::VectorXd &rate;     ///< mean over the step [m/s]
  const Eigen::VectorXd &load;     ///< as in BodyStart
};

/**
 * @brief A way to make a step: `Time/Scheme` names a member of this family.
 *
 * Many are a choice of terms() and implicit_step() with them. One whose equation is another one gives
 * terms_of() its own, and kept() what these need to know of the step before.
 */
class TimeIntegrator
{
public:
  virtual ~TimeIntegrator() = default;

  /// What it is in numbers. @param theta 'Time/Theta'
  virtual TimeScheme terms(double theta) const = 0;

  /// Whether theta changes anything.
  bool reads_theta() const { return terms(0.5).theta != terms(1.).theta; }

  /// Whether it makes steps in space.
  virtual bool in_space() const { return false; }

  /// What it adds to the forces of one body in its equation of a step.
  virtual std::unique_ptr<BodyTerms<2>> terms_of(const BodyStart &start) const;

  /// What the next step is to know of the nodes beside where they are and how fast, in NodalState::kept;
  /// empty: nothing.
  virtual Eigen::VectorXd kept(const BodyEnd & /*end*/) const { return {}; }

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
   * @brief Makes a state that may be written of the one in which a step of length @p dt [s] ended, while time
   * stands still. For most schemes both are the same.
   * @throw ComputationError when it is not found
   */
  virtual StepOutcome settle(const Problem &problem, State &state, Workspace &work, double dt) const;
};
} // namespace softgrain::mpm

template <>
softgrain::Registry<softgrain::mpm::TimeIntegrator> &
softgrain::Registry<softgrain::mpm::TimeIntegrator>::instance();

#endif
