// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_rays_at_rest_h
#define softgrain_mpm_stepping_rays_at_rest_h

#include <softgrain/mpm/stepping/step.h>

#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief How `quasi_static` goes on where contact is found by rays, in the plane and in space: steps with
 * walls on their way, in which bodies that find no minimum resist more, and held ones until what resists them
 * is small.
 */
class RaysAtRest
{
public:
  explicit RaysAtRest(const Settings &settings) : settings(settings) {}
  virtual ~RaysAtRest() = default;

  /// A step with walls on their way. @param wanted length of a step that is not made shorter [s]
  StepOutcome go(double dt, double wanted);

  /// Held steps until the unbalanced force is no more than 'Quasi-static/Unbalanced force'.
  /// @throw ComputationError where there is no end of it
  StepOutcome settle(double dt);

protected:
  /// One step, see ray_step().
  virtual StepOutcome step(const StepPlan &plan) = 0;
  /// What holds bodies back where they are, over the mean force of a contact.
  virtual double unbalanced() = 0;
  /// Called after every held step that was accepted, with the sum of all so far.
  virtual void held(StepOutcome & /*sum*/) {}
  virtual double time() const = 0; ///< [s]
  /// Whether walls go where loads push them. They see the resistance that a step starts with.
  virtual bool walls_yield() const { return false; }
  /// Whether laws remember where bodies have been: each held step is then an exact one.
  virtual bool remembers() const { return false; }
  /// What is furthest from balance, for messages.
  virtual std::string least_balanced() const = 0;

private:
  const Settings &settings;
};

/// The largest force that holds back a body over the mean force of a contact. Forces below a hundredth of
/// Young's modulus times a cell, or its side in space, count as that much: between bodies that hardly touch
/// nothing else than resistance acts.
/// @param held_back see State::held_back
template <int dim>
double unbalanced_rays(const std::vector<Body<dim>> &bodies,
                       const std::vector<ContactFrame<dim>> &frames,
                       const std::vector<double> &held_back,
                       double cell_size);

/// Which body is held back most and where it is, for messages. @param held_back as above, of some body
template <int dim>
std::string least_balanced_body(const std::vector<Body<dim>> &bodies, const std::vector<double> &held_back);

/// quasi_static_step() where contact is found by rays.
StepOutcome rays_step(const Problem &problem, State &state, Workspace &work, double dt, double wanted);

/// Held steps of it.
/// @throw ComputationError as find_balance()
StepOutcome settle_rays(const Problem &problem, State &state, Workspace &work, double dt);
} // namespace softgrain::mpm

#endif
