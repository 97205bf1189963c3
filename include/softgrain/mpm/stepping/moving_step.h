// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_moving_step_h
#define softgrain_mpm_stepping_moving_step_h

#include <softgrain/mpm/stepping/space_ray_step.h>

#include <array>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/// A step with inertia in space: how it finds ways and forces is a scheme's own, what becomes of them is not.
class MovingStep : public SpaceRayStep
{
public:
  MovingStep(SpaceState &state,
             const SpaceScene &space,
             SpaceMotion &motion,
             const StepPlan &plan,
             SpaceEquations &equations);

  /// @return why there is no step
  std::string find();
  void accept(SpaceState &state);

protected:
  /// Finds ways, forces and friction of rays, and trial, the velocities at the end. @return why there are
  /// none
  virtual std::string find_ways() { return SpaceRayStep::find(); }
  /// What rays do to the nodes of an owned body [N].
  virtual Eigen::VectorXd forces_on(const unsigned int b) const { return contact_forces(b); }
  /// The way of an owned body on which impulses and loads of the step do their work [m].
  virtual Eigen::VectorXd way_at_work(const unsigned int b) const { return way[b]; }
  /// Brings trial of an owned body to the end of the step. @return what the scheme damps, and what keeps the
  /// spin of the body takes [J]
  virtual std::array<double, 2> end(const Body<3> &body) = 0;

private:
  void account_pressures(SpaceState &state) const;
  void note_contact_work();
  std::string why_contact_gives() const;
  /// What all learn of a body: what the scheme damped and what held it took [J], the momentum of its nodes,
  /// and the impulse of its loads [N s].
  using OfBody = std::array<double, 6>;
  /// Ends the step of an owned body.
  OfBody end_of(const Body<3> &body);
  void accept_motion(SpaceState &state);

  SpaceEquations &moving;
  std::vector<double> obstacle_work; ///< on the bodies [J]
  double taken = 0.;                 ///< of all work by contact [J]
};

/// One step of `moreau_jean` in space, as ray_step() makes it in the plane; @p state goes on only if it is
/// accepted.
StepOutcome moving_step(SpaceState &state, const SpaceScene &scene, const SpaceMotion &motion, double dt);
} // namespace softgrain::mpm

#endif
