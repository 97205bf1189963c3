// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_space_step_h
#define softgrain_mpm_stepping_space_step_h

#include <softgrain/driving/named_sums.h>
#include <softgrain/mpm/contact/contact_kinks.h>
#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/stepping/keep_points.h>
#include <softgrain/mpm/stepping/loaded_walls.h>
#include <softgrain/mpm/stepping/rays_at_rest.h>
#include <softgrain/mpm/stepping/space_equations.h>
#include <softgrain/scene/contact_pairs.h>

#include <string>
#include <vector>

namespace softgrain::mpm
{
/// What a ray does in balance.
struct SpaceContact
{
  unsigned int body, partner, wall; ///< one of the latter two is none
  dealii::Point<3> place;           ///< [m]
  dealii::Tensor<1, 3> normal;      ///< unit, out of the partner, at right angles to friction
  dealii::Tensor<1, 3> force;       ///< on the body; the partner feels the opposite [N]
  double gap;                       ///< [m]
  PeriodicCell<3>::Image image{};   ///< of the partner, in a cell that repeats
};

/// Sums since the start of what steps with inertia in space do.
struct MotionBalance
{
  double scheme_damping = 0;    ///< see Balance of the plane [J]
  double contact_loss = 0;      ///< taken by impacts and friction [J]
  double wall_damping = 0;      ///< in the damping of walls under loads [J]
  double cell_work = 0;         ///< of a cell that deforms, beside that of its sides: see CellMotion [J]
  dealii::Tensor<1, 3> impulse; ///< of loads and walls, and the momentum at the start [N s]
  double largest_momentum = 0;  ///< of the nodes of a body [N s]
};

/// What steps at rest in space have lost, beside what laws lose.
struct SpaceLosses
{
  double regularisation = 0; ///< taken by what resists [J]
  double released = 0;       ///< in held steps beside that, see loss::released [J]
  double rubbed = 0;         ///< by friction [J]
};

/// What steps in space change beside the bodies.
struct SpaceProgress
{
  std::vector<ContactFrame<3>> frames;          ///< of the last step
  std::vector<Obstacle<3>> obstacles;           ///< where they are, and what they have felt in the last step
  std::vector<SpaceContact> contacts;           ///< of the last step
  std::vector<double> held_back;                ///< see State::held_back [N]
  std::vector<dealii::Tensor<1, 3>> wall_force; ///< of walls on the bodies [N]
  std::vector<LoadedWall> loaded;               ///< of all walls; those that are told how to move have none
  SpaceLosses losses;                           ///< since the start
  double dent_energy = 0;                       ///< in the dents that the grid misses, now [J]
  WorkOfLaw laws;                               ///< what laws did, since the start
  std::size_t law_cuts = 0;                     ///< steps that a law has asked to be shorter
  NamedSums load_work;                          ///< done by loads, since the start [J]
  MotionBalance motion;                         ///< with inertia
  ContactKinks kinks;                           ///< of the last step
  double cell_offset = 0;                       ///< of the cell above, of one that repeats [m]
  double time = 0;                              ///< [s]
};

/// Where a computation in space has come to.
struct SpaceState : SpaceProgress
{
  std::vector<Body<3>> bodies;
  std::vector<SolidSurface> surfaces; ///< of the bodies, in the configuration of their grids
};

/// What a step in space knows of its scene, beside the state.
struct SpaceScene
{
  SpaceWorkspace &work;
  const Settings &settings;
  const HertzCompliance &subgrid;
  const ContactPairs &pairs;
  const std::vector<std::string> &wall_names;
  const bool frictionless; ///< nothing rubs
};

/// Steps at rest in space.
class SpaceAtRest final : public RaysAtRest
{
public:
  /// @param motion in held steps all stands still but for walls under loads
  SpaceAtRest(SpaceState &state, const SpaceScene &scene, const SpaceMotion &motion)
      : RaysAtRest(scene.settings), state(state), scene(scene), motion(motion), stands(motion)
  {
  }

protected:
  StepOutcome step(const StepPlan &plan) override;
  double unbalanced() override;
  double time() const override { return state.time; }
  void held(StepOutcome &sum) override;
  bool walls_yield() const override;
  bool remembers() const override;
  std::string least_balanced() const override;

private:
  WallImbalance unbalanced_wall() const;

  SpaceState &state;
  const SpaceScene scene;
  const SpaceMotion motion;
  SpaceMotion stands; ///< where the last step has ended
};
} // namespace softgrain::mpm

#endif
