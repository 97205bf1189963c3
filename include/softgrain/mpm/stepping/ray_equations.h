// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_ray_equations_h
#define softgrain_mpm_stepping_ray_equations_h

#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/contact/frame_state.h>
#include <softgrain/mpm/contact/frame_system.h>
#include <softgrain/mpm/model/settings.h>
#include <softgrain/mpm/stepping/body_equations.h>
#include <softgrain/mpm/stepping/step.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/// What a step whose contacts are met by rays works on, in the plane and in space.
template <int dim>
struct RayWorld
{
  const std::vector<Body<dim>> &bodies;
  const std::vector<BodySurface<dim>> &surfaces;
  const std::vector<ContactFrame<dim>> &frames; ///< of the step before
  const std::vector<WallMotion<dim>> &motion;
  const Settings &settings;
  double cell_size; ///< [m]
  SubgridLaw<dim> subgrid;
  const BodyShare &share;
  std::vector<SystemMatrix> &matrices;
  std::vector<std::unique_ptr<BodySolver<dim>>> &solvers;
  dealii::TimerOutput &timer;
};

/**
 * @brief What is unknown in a step whose contacts are met by rays, and how far it is from balance.
 *
 * Unknown are the ways of the nodes, the forces and the friction of all rays, and how far walls under loads
 * go.
 */
template <int dim>
class RayEquations
{
public:
  using Vectors = std::vector<Eigen::VectorXd>;
  using Vector = dealii::Tensor<1, dim>;
  using Across = dealii::Tensor<1, dim - 1>; ///< a component for each direction across the rays

  RayEquations(const RayWorld<dim> &world, const StepPlan &plan, BodyEquations<dim> &equations);
  virtual ~RayEquations() = default;

protected:
  /// Makes walls under loads unknowns of the step.
  virtual void find_free_walls() {}
  /// Puts walls under loads where they have come to.
  virtual void move_free_walls() {}
  /// The farthest way of what is told how to move, as obstacles and driven bodies are; walls aside [m].
  virtual double other_way() const { return 0.; }
  /// What is on the other side of a frame, for messages.
  virtual std::string partner_of(const ContactFrame<dim> &frame) const = 0;

  /// Gap of rays that may become pressed [m]. With inertia bodies go nearly where they are expected.
  double candidates_within() const { return (inertia ? 0.05 : 0.15) * h; }

  /// Finds the frames of the step, with the forces that their rays had.
  void lay();
  /// Rays carry what they carried when the step began.
  void take_forces_of_start();
  /// The way of bodies that go on as they do [m].
  Vectors free_way() const;
  /// Stress, and where rays meet the surfaces, after nodes have moved by @p way. @return whether there is
  /// such a state
  bool evaluate(const Vectors &way);
  /// Leaves out pressed rays whose surfaces have slid away from under them, after evaluate() has returned
  /// false. @return whether there are any, so that there may be such a state now
  bool leave_unmet_rays();
  /// Where rays meet the surfaces after nodes have moved by @p way. @return whether those that press do
  bool meet(const Vectors &way);
  /// Why there is none, after evaluate() has returned false.
  std::string why_not() const;
  /// Finds residual and deepest for what was last evaluated.
  void measure();
  /// What rays do to the nodes of a body [N/m^(3-dim)].
  Eigen::VectorXd contact_forces(unsigned int b) const;
  /// The frames as the step leaves them. A force that is rounding of the largest is none: which frames last,
  /// and how, hangs on which rays are pressed.
  std::vector<ContactFrame<dim>> frames_after() const;
  /// Whether what is unbalanced is what forces round by: nothing smaller is found, whatever is asked for.
  bool at_rounding() const;
  /// Newton's matrix of every body.
  void assemble();
  /// @return negative pivots of all bodies, if all could be factorised
  std::optional<unsigned int> factorise();
  /// The largest by which something that is no unknown brings two places nearer [m].
  double largest_way() const { return std::max(walls_way(), other_way()); }

  const RayWorld<dim> world;
  const StepPlan &plan;
  const double h;
  const bool inertia; ///< else the step ends in balance
  const double theta; ///< of TimeScheme: a change of the end velocity times theta dt is one of the way
  BodyEquations<dim> &equations;
  FrameScene<dim> scene;
  std::vector<FrameState<dim>> frames;
  RayForces force;          ///< normal forces of rays [N/m^(3-dim)]
  RayFriction<dim> rubbing; ///< their friction
  FrameSystem<dim> system;
  Vectors at_rest, way; ///< no way, and that of the step [m]
  Vectors trial;        ///< the velocity for it, of owned bodies [m/s]
  double residual = 0.; ///< largest unbalanced force of a body or a wall over the largest force on one
  double deepest =
      0.; ///< largest gap of a pressed ray, overlap of another one, or slide of one that sticks [m]
  /// Gaps like the deepest one, times the stiffness of the pair over that of the softest: they tell what
  /// forces are off by [m].
  double deepest_by_force = 0.;
  double softest_pair = 0.; ///< FrameConditions::stiffness() of the softest pair
  double path = 0.;         ///< no place has moved by more than this, all iterations summed [m]
  static constexpr unsigned int none = FrameState<dim>::none;
  unsigned int not_met = none; ///< a frame with a pressed ray that is not met

private:
  double walls_way() const;
  double unbalanced_free_walls() const;
  double momentum_of_nodes(const Body<dim> &body) const;
  void measure_frame(unsigned int f, double &wrong_friction);

  Vectors displacement;
};
} // namespace softgrain::mpm

#endif
