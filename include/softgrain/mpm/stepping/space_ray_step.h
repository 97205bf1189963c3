// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_space_ray_step_h
#define softgrain_mpm_stepping_space_ray_step_h

#include <softgrain/mpm/stepping/ray_newton.h>
#include <softgrain/mpm/stepping/space_step.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/// A step in space, at rest or with inertia: how it finds ways and forces, and what becomes of contacts.
class SpaceRayStep : private RayNewton<3>
{
public:
  SpaceRayStep(SpaceState &state,
               const SpaceScene &space,
               SpaceMotion &motion,
               const StepPlan &plan,
               BodyEquations<3> &equations);

  using RayNewton<3>::outcome;

  std::string find() { return converge(); }

protected:
  using RayNewton<3>::Across;
  using RayNewton<3>::at_rest;
  using RayNewton<3>::contact_forces;
  using RayNewton<3>::force;
  using RayNewton<3>::frames;
  using RayNewton<3>::free_way;
  using RayNewton<3>::h;
  using RayNewton<3>::largest_way;
  using RayNewton<3>::lay;
  using RayNewton<3>::path;
  using RayNewton<3>::plan;
  using RayNewton<3>::rubbing;
  using RayNewton<3>::scene;
  using RayNewton<3>::system;
  using RayNewton<3>::trial;
  using RayNewton<3>::Vectors;
  using RayNewton<3>::way;
  using RayNewton<3>::world;

  SpaceMotion &motion; ///< walls under loads learn here how far they go

  std::vector<unsigned int> pressed; ///< walls under loads, in the order of their unknowns

  /// The obstacle that is the partner of a frame; none: it has another one.
  static constexpr unsigned int none = ContactFrame<3>::none;
  unsigned int obstacle_of(const ContactFrame<3> &frame) const { return mpm::obstacle_of(scene, frame); }
  /// Way over the step of the place of a wall or an obstacle that a ray has met [m].
  dealii::Tensor<1, 3> way_of_partner(const FrameState<3> &frame, unsigned int k) const;

  /// The force of ray @p k of frame @p f on the body of the frame [N].
  dealii::Tensor<1, 3> force_on_body(unsigned int f, unsigned int k) const;
  /// Sum over contacts of the force on a body times the vector to its centre from that of its partner, or
  /// from the place where it meets a wall, as the step begins, see load_sides() [N m].
  dealii::Tensor<2, 3> virial() const;

  /// What each of the loads of a body does over the way @p gone [J]. @param load their force, taken at @p
  /// times
  std::vector<double> works_of_loads(const Body<3> &body,
                                     const Eigen::VectorXd &load,
                                     const Eigen::VectorXd &gone,
                                     const LoadTimes &times) const;
  /// Books what loads do. @param works_of gives works_of_loads() of an owned body; empty: nothing acts on it
  void account_loads(const std::function<std::vector<double>(const Body<3> &)> &works_of,
                     SpaceState &state) const;
  /// Writes contacts, frames and forces on walls into the state, and moves the bodies and their points.
  void accept_ways(SpaceState &state);

  std::optional<CellMotion<3>> cell; ///< that repeats, and how it deforms in the step; nothing: nothing does

private:
  /// Takes over how walls that are sides of a cell move: it takes the bodies along.
  void take_bodies_along();
  void find_free_walls() override;
  void move_free_walls() override;
  double other_way() const override { return std::max(way_of_obstacles, way_of_free_walls); }
  std::string partner_of(const ContactFrame<3> &frame) const override;
  void add_contacts(unsigned int f, SpaceState &state) const;
  /// Moves all bodies, and lets points of owned ones keep what they went through, which all learn.
  void move_bodies(SpaceState &state);

  /// Where a ray presses [m].
  dealii::Point<3> place_of(const FrameState<3> &frame, unsigned int k) const;
  /// Puts forces through the sides of a cell on them, and moves the cell above.
  void load_sides_of_cell(SpaceState &state) const;

  const std::vector<StepState<3>> &of_points; ///< of the trial, body by body
  const std::vector<std::string> &wall_names;
  const std::vector<Obstacle<3>> &obstacles;           ///< as the step begins
  const std::vector<dealii::Tensor<1, 3>> &wall_force; ///< likewise
  const AllRigidRays<3> solids;
  double way_of_obstacles = 0., way_of_free_walls = 0.; ///< the farthest in the step [m]
};
} // namespace softgrain::mpm

#endif
