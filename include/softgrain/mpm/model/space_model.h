// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_space_model_h
#define softgrain_mpm_model_space_model_h

#include <softgrain/driving/step_control.h>
#include <softgrain/driving/wall.h>
#include <softgrain/model/model.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/field/lattice.h>
#include <softgrain/mpm/field/shape_function.h>
#include <softgrain/mpm/stepping/driven_work.h>
#include <softgrain/mpm/stepping/space_ray_step.h>
#include <softgrain/scene/scene.h>

#include <deal.II/base/timer.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The material point model of a scene in space, as far as it goes: bodies of any law, at rest or
 * moving, between flat walls and obstacles that are told how to move, with Coulomb's friction. Contacts are
 * met by rays, as in the plane.
 *
 * At rest works of walls that are told how to move are those of the mean of their forces at both ends of a
 * step, and of what kinks of contacts add; a load works with its mean over the step. With inertia works are
 * those of the force in the step.
 */
class SpaceModel final : public Model<3>
{
public:
  using Laws = std::vector<std::shared_ptr<const constitutive::Law<3>>>;

  /// @param laws of the materials
  /// @throw InputError when a body reaches out of the mesh
  SpaceModel(const Scene<3> &scene, const Settings &settings, const Laws &laws);

  std::string name() const override { return "mpm"; }
  StepReport advance(double dt_limit) override;
  void settle(StepReport &report) override;
  void take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives) override;
  double time() const override { return state.time; }
  std::size_t step() const override { return steps; }
  Snapshot<3> snapshot() const override;
  std::vector<WallState<3>> walls() const override;
  std::vector<ObstacleState<3>> obstacles() const override { return states_of(state.obstacles); }
  Energies energies() const override;
  double energy_of_rounding() const override;
  double solid_area() const override;
  double coordination() const override;
  double momentum_error() const override;
  std::size_t n_points() const override;
  std::size_t n_bodies() const override { return state.bodies.size(); }
  SizeReport size_report() const override;
  std::vector<std::pair<std::string, double>> works() const override;
  std::vector<std::pair<std::string, double>> extra_history() const override;
  std::map<std::string, double> phases() const override;
  RankTimes rank_times() const override { return work.share.exchange.taken(); }
  void save(StateWriter &out) const override;
  void load(StateReader &in) override;

  /// What tests look at.
  const SpaceState &space() const { return state; }

private:
  /// What the points of a body stand on: a lattice of its own, whose cells are those of the mesh.
  struct Ground
  {
    Ground(const Lattice<3> &lattice, const PointLayout<3> &layout)
        : lattice(lattice), store(this->lattice, layout)
    {
      store.cover_all();
    }
    const Lattice<3> lattice;
    PointStore<3> store;
  };

  /// Whether steps end in balance.
  bool at_rest() const { return settings.scheme.ends_in_balance(); }
  void add_body(const BodyDescription<3> &description,
                const std::shared_ptr<const constitutive::Law<3>> &law,
                double density);
  /// Gives bodies to ranks by where they are.
  void share_out_bodies();
  /// Gives a body the velocity with which it begins.
  void start(const BodyDescription<3> &description, Body<3> &body) const;
  double cfl_step() const; ///< in which a wave goes through a cell [s]
  double wanted_step() const;
  SpaceScene scene() { return {work, settings, subgrid, pairs, wall_names, frictionless}; }
  /// One step. @param cuts_before by laws, since the start, when it was tried first @return why it is no good
  Attempt try_step(double dt, double wanted, std::size_t cuts_before, StepReport &report);
  /// What all does in a step of @p dt; 0: it stands [s].
  SpaceMotion motion(double dt) const;
  void note(const StepOutcome &outcome, StepReport &report) const;
  /// Books what walls and obstacles did in a step that has been accepted.
  void book(const SpaceMotion &motion, double dt);
  /// @param of_load gets what bodies get of a load beside the work of its mean force [J]
  void book_wall(
      std::size_t w, const SpaceMotion &motion, double dt, double &of_load, std::vector<DrivenWork> &works);
  /// Takes over what a step has found out of walls: how far loads have moved them, what those have done, and
  /// where the cell above stands.
  void follow_step();
  /// A wall under a load goes on from where it has come to.
  void begin_under_load(std::size_t w);
  void book_obstacles(const SpaceMotion &motion, std::vector<DrivenWork> &works);
  /// The fastest of obstacles in a step from now on [m/s].
  double fastest_obstacle(double dt) const;
  dealii::Tensor<1, 3> momentum() const;
  BodyState<3> body_state(const Body<3> &body) const;
  void add_points(const Body<3> &body, BodyState<3> &of_body, PointStates<3> &points) const;
  /// Stress of a body as it is.
  StepState<3> stress_of(const Body<3> &body) const;

  /// What a step changes.
  struct Before
  {
    std::vector<Eigen::VectorXd> displacement;
    SpaceProgress progress;
    double last_dt;
    std::vector<Wall<3>> driven;
    std::size_t steps;
    std::vector<double> points; ///< see remembered_by_points()
  };
  void keep_before();
  void go_back();

  Settings settings;
  const std::unique_ptr<ShapeFunction> function;
  const Lattice<3> lattice; ///< of the mesh
  const HertzCompliance subgrid;
  const ContactPairs pairs;
  const Loads<3> loads;
  const bool moved_by_more; ///< whether bodies are moved by more than walls
  const bool frictionless;  ///< nothing rubs, obstacles counted in
  std::vector<std::unique_ptr<Ground>> grounds;
  SpaceState state;
  SpaceWorkspace work;
  std::vector<Wall<3>> driven;
  std::vector<std::string> wall_names;
  StepControl step_control{1.5};
  double last_dt = 0.; ///< [s]
  std::size_t steps = 0;
  Before before_step{};
  std::unique_ptr<dealii::TimerOutput> timer;
};
} // namespace softgrain::mpm

#endif
