// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_moving_equations_h
#define softgrain_mpm_stepping_moving_equations_h

#include <softgrain/mpm/stepping/body_inertia.h>
#include <softgrain/mpm/stepping/space_equations.h>

#include <vector>

namespace softgrain::mpm
{
/// The equations of a step with inertia in space.
class MovingEquations final : public SpaceEquations
{
public:
  /// @param time at the start [s]
  /// @param slippery nothing rubs, so that balls keep their spins
  MovingEquations(const std::vector<Body<3>> &bodies,
                  const Settings &settings,
                  SpaceWorkspace &work,
                  const StepPlan &plan,
                  double time,
                  bool slippery);

  double rounding(const Body<3> &body, double contact) const override;
  void assemble_exact(const Body<3> &body) override;
  Eigen::VectorXd end_velocity(const Body<3> &body, const Eigen::VectorXd &way) const override
  {
    return inertia[body.index].end_velocity(body, way);
  }
  /// What the scheme takes from a body in the step as last evaluated [J].
  double damping(unsigned int b, const Eigen::VectorXd &v) const
  {
    return inertia[b].damping(bodies[b], v, increment[b], internal[b]);
  }
  /// What keeps its spin takes [J].
  double held_work(const unsigned int b) const { return inertia[b].held_work(increment[b]); }

private:
  Eigen::VectorXd increment_of(const Body<3> &body, const Eigen::VectorXd &v) const override
  {
    return inertia[body.index].increment(body, v);
  }
  void find_missing(const Body<3> &body, const Eigen::VectorXd &v) override;

  Vectors fixed_external; ///< of external, what does not depend on the trial
  std::vector<BodyInertia<3>> inertia;
};
} // namespace softgrain::mpm

#endif
