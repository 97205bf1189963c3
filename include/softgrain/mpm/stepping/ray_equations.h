// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_ray_equations_h
#define softgrain_mpm_stepping_ray_equations_h

#include <softgrain/driving/cell_motion.h>
#include <softgrain/mpm/contact/frame_state.h>
#include <softgrain/mpm/contact/frame_system.h>
#include <softgrain/mpm/stepping/step_equations.h>

#include <optional>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief What is unknown in a step whose contacts are met by rays, and how far it is from balance.
 *
 * Unknown are the ways of the nodes, the forces and the friction of all rays, and how far walls under loads
 * go.
 */
class RayEquations
{
public:
  using Vectors = StepEquations::Vectors;

  RayEquations(const Problem &problem,
               const State &state,
               Workspace &work,
               const StepPlan &plan,
               std::vector<WallMotion<2>> &motion);

protected:
  /// Gap of rays that may become pressed [m]. With inertia bodies go nearly where they are expected.
  double candidates_within() const { return (inertia ? 0.05 : 0.15) * h; }

  /// Finds the frames of the step, with the forces that their rays had.
  void lay();
  /// Rays carry what they carried when the step began.
  void take_forces_of_start();
  /// The way of bodies that go on as they do; none without inertia [m].
  Vectors free_way() const;
  /// Stress, and where rays meet the surfaces, after nodes have moved by @p way. @return whether there is
  /// such a state
  bool evaluate(const Vectors &way);
  /// After evaluate() has returned false: leaves out pressed rays whose surfaces have slid away from under
  /// them. @return whether there are any, so that there may be such a state now
  bool leave_unmet_rays();
  /// Where rays meet the surfaces after nodes have moved by @p way. @return whether those that press do
  bool meet(const Vectors &way);
  /// Why there is none, after evaluate() has returned false.
  std::string why_not() const;
  /// Finds residual and deepest for what was last evaluated.
  void measure();
  /// What rays do to the nodes of a body [N/m].
  Eigen::VectorXd contact_forces(unsigned int b) const;
  /// Whether what is unbalanced is what forces round by: nothing smaller is found, whatever is asked for.
  bool at_rounding() const;
  /// Newton's matrix of every body.
  void assemble();
  /// @return negative pivots of all bodies, if all could be factorised
  std::optional<unsigned int> factorise();
  /// The largest by which something that is no unknown brings two places nearer [m].
  double largest_way() const;

  const Problem &problem;
  const State &state;
  Workspace &work;
  const StepPlan &plan;
  std::vector<WallMotion<2>> &motion;
  const double h;
  const bool inertia;
  const double theta; ///< of TimeScheme: a change of the end velocity times theta dt is one of the way
  std::optional<CellMotion> cell;
  std::vector<ObstacleLine> lines;
  StepEquations equations;
  FrameScene<2> scene;
  std::vector<FrameState<2>> frames;
  RayForces force, rubbing; ///< normal forces and friction of rays [N/m]
  FrameSystem<2> system;
  Vectors at_rest, way, trial; ///< no way, that of the step [m], and the velocity for it [m/s]
  double residual = 0.;        ///< largest unbalanced force of a body or a wall over the largest force on one
  double deepest =
      0.;           ///< largest gap of a pressed ray, overlap of another one, or slide of one that sticks [m]
  double path = 0.; ///< no place has moved by more than this, all iterations summed [m]

private:
  FrameState<2>::Vector way_of(const WallMotion<2> &wall) const
  {
    return plan.dt * (wall.velocity * wall.normal + wall.slide * wall.tangent());
  }
  std::vector<FrameState<2>::Vector> ways_of_bodies() const;
  Eigen::VectorXd end_velocity(unsigned int b, const Eigen::VectorXd &way) const;
  std::vector<double> own_ways() const;
  void move_free_walls();
  void find_free_walls();
  double unbalanced_free_walls() const;
  double momentum_of_nodes(const Body<2> &body) const;
  void measure_frame(unsigned int f, double &wrong_friction);

  Vectors displacement;
  static constexpr unsigned int none = FrameState<2>::none;
  unsigned int not_met = none; ///< a frame with a pressed ray that is not met
};
} // namespace softgrain::mpm

#endif
