// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_space_model_h
#define softgrain_bpm_space_model_h

#include <softgrain/bpm/ball_dynamics.h>
#include <softgrain/bpm/settings.h>
#include <softgrain/driving/named_sums.h>
#include <softgrain/driving/step_control.h>
#include <softgrain/driving/wall.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/model/model.h>
#include <softgrain/scene/scene.h>

#include <deal.II/base/timer.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace softgrain::bpm
{
/**
 * @brief The bonded-particle model in space: every body an aggregate of rigid balls that attract each other,
 * between flat walls that are told how to move. What BpmModel is in the plane.
 *
 * One step: BallDynamics::step(); a step that leaves too deep an overlap, or in which a ball goes too far to
 * be seen, is taken back and repeated with half its length.
 */
class SpaceModel final : public Model<3>
{
public:
  using Laws = std::vector<std::shared_ptr<const Attraction>>;

  /// @param laws attraction of every material
  /// @throw InputError when primaries lie in each other or behind a wall
  SpaceModel(const Scene<3> &scene, const Settings &settings, const Laws &laws);

  std::string name() const override { return "bpm"; }
  StepReport advance(double dt_limit) override;
  unsigned int equal_steps() const override { return 8; } ///< as in the plane
  void take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives) override;
  double time() const override { return now; }
  std::size_t step() const override { return steps; }
  Snapshot<3> snapshot() const override;
  Snapshot<3> touching_state() const override;
  std::vector<WallState<3>> walls() const override;
  Energies energies() const override;
  double energy_of_rounding() const override;
  double solid_area() const override;
  double coordination() const override;
  double momentum_error() const override;
  std::size_t n_points() const override { return dynamics->balls().size(); }
  std::size_t n_bodies() const override { return scene.bodies.size(); }
  SizeReport size_report() const override;
  std::vector<std::pair<std::string, double>> works() const override;
  std::vector<std::pair<std::string, double>> extra_history() const override;
  std::map<std::string, double> phases() const override;
  void save(StateWriter &out) const override;
  void load(StateReader &in) override;

  /// What tests look at.
  const BallDynamics &motion() const { return *dynamics; }

private:
  using Accelerations = std::vector<std::vector<std::array<double, 3>>>;

  /// Aggregates for all bodies, each of those that differ once.
  Balls fill_bodies(const Laws &laws);
  void give_spins(Balls &balls) const;
  void check_apart() const;
  std::string where_is(std::size_t row) const;
  std::string why_not(const BallReport &report, double limit) const;
  double wanted_step() const;
  double rounded_velocity() const;
  /// What loads do to the balls in a step.
  Accelerations ask_loads(double dt) const;
  void keep_books(const BallReport &report);
  dealii::Point<3> center_of(std::size_t body) const;
  TriangulatedSurface surface_of(std::size_t body) const;
  ContactState<3> contact_state(std::size_t row) const;
  void show_balls(Snapshot<3> &snapshot) const;
  void show_bodies(Snapshot<3> &snapshot) const;
  void add_contacts(Snapshot<3> &snapshot) const;
  void add_inner_forces(Snapshot<3> &snapshot) const;
  void add_stresses(Snapshot<3> &snapshot) const;
  /// Calls work(a, b, force [N], branch from b to a [m]) for all pairs of one body that have a force: contact
  /// less attraction.
  template <class Work>
  void for_bonds(const Work &work) const;

  Scene<3> scene;
  Settings settings;
  std::unique_ptr<dealii::TimerOutput> timer;
  std::unique_ptr<BallDynamics> dynamics;
  std::vector<Wall<3>> moving_walls;
  std::vector<std::uint32_t> first_of_body;
  std::vector<double> density; ///< of every body [kg/m^3]
  double natural_time = 0;     ///< attraction_time() of the mean primary of the strongest law, 0 without one
  double mass = 0;             ///< of all primaries [kg]
  double characteristic_force = 0; ///< F0 of p_I, of the strongest law [N]
  TriangulatedSurface directions;  ///< of the surfaces that are drawn

  double now = 0, last_dt = 0;
  StepControl step_control{1.25};
  std::size_t steps = 0;
  std::size_t fallbacks = 0;    ///< steps in which the accelerated contact solver gave way to plain sweeps
  double contact_loss = 0;      ///< [J]
  NamedSums load_work;          ///< [J]
  dealii::Tensor<1, 3> impulse; ///< momentum at the start and what was given since [N s]
  double largest_momentum = 0;  ///< [N s]
  std::vector<double> volume_at_start;    ///< enclosed by the surface of every body [m^3]
  mutable double volume_now = -1;         ///< enclosed by all surfaces when it was last measured [m^3]
  mutable std::size_t volume_of_list = 0; ///< number of neighbour lists made by then
};
} // namespace softgrain::bpm

#endif
