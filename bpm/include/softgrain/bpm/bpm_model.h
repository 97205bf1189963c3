// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_bpm_model_h
#define softgrain_bpm_bpm_model_h

#include <softgrain/base/exchange.h>
#include <softgrain/base/expression.h>
#include <softgrain/bpm/dynamics.h>
#include <softgrain/bpm/settings.h>
#include <softgrain/driving/balance.h>
#include <softgrain/driving/folded_bodies.h>
#include <softgrain/driving/step_control.h>
#include <softgrain/driving/wall.h>
#include <softgrain/driving/works.h>
#include <softgrain/model/model.h>
#include <softgrain/scene/scene.h>

#include <memory>
#include <vector>

namespace dealii
{
class TimerOutput;
}

namespace softgrain::bpm
{
class GatheredPrimaries;

/**
 * @brief The bonded-particle model: every body an aggregate of rigid disks that attract each other.
 *
 * One step: Dynamics::step() with the walls driven by velocity or pressure; a step that leaves too deep an
 * overlap is taken back and repeated with half its length.
 */
class BpmModel final : public Model<2>
{
public:
  /**
   * @param scene bodies, walls, loads
   * @param settings of the model
   * @param laws attraction of every material
   * @param law_texts parameters of the laws, for the keys of prepared aggregates
   * @param state that is going to be loaded: it has the primaries; null: aggregates are prepared
   */
  BpmModel(const Scene<2> &scene,
           const Settings &settings,
           const std::vector<std::shared_ptr<const Attraction>> &laws,
           const std::vector<std::string> &law_texts,
           const StateReader *state = nullptr);
  ~BpmModel() override;

  std::string name() const override { return "bpm"; }
  StepReport advance(double dt_limit) override;
  /// An approximate contact solution leaves overlaps, which the next step pushes out, however short it is.
  /// With two equal steps, of 0.8 natural ones in the mean, stress before a snapshot was up to a sixth too
  /// high (doc/results/cost-of-paths.md).
  unsigned int equal_steps() const override { return 8; }
  void take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives) override;
  void forget_attempt() override;
  double time() const override { return now; }
  std::size_t step() const override { return steps; }
  Snapshot<2> snapshot() const override;
  Snapshot<2> touching_state() const override;
  std::vector<WallState<2>> walls() const override;
  std::vector<ObstacleState<2>> obstacles() const override;
  double unbalanced_walls() const override;
  Energies energies() const override;
  double energy_of_rounding() const override;
  double solid_area() const override;
  double coordination() const override;
  double momentum_error() const override;
  std::size_t n_points() const override { return n_all(*dynamics); }
  std::size_t n_bodies() const override { return scene.bodies.size(); }
  SizeReport size_report() const override;
  std::vector<std::pair<std::string, double>> works() const override;
  std::vector<std::pair<std::string, double>> extra_history() const override;
  std::map<std::string, double> phases() const override;
  RankTimes rank_times() const override { return exchange.taken(); }
  void save(StateWriter &) const override;
  void load(StateReader &) override;

private:
  Primaries fill_bodies(const std::vector<std::shared_ptr<const Attraction>> &laws,
                        const std::vector<std::string> &law_texts);
  Primaries primaries_of(const StateReader &state);
  void grade(Primaries &disks) const;
  void check_places() const;
  /// Primaries may lie in each other though their bodies' shapes do not, or in an obstacle. @throw InputError
  void check_apart() const;
  /// Which lie in each other, how deep and where.
  std::string where_is(const Overlap &overlap) const;
  double wanted_step() const;
  /// Velocities up to this are rounding [m/s].
  double rounded_velocity() const;
  /// @throw ComputationError when not all have come to the same step
  void check_ranks_agree(const StepReport &report) const;
  void drive_walls(double dt);
  /// Length of steps, and what depends on it and on forces. @param contact_force of the strongest law [N/m]
  void choose_by_attraction(const Primaries &disks, double contact_force);
  void take_loads(Primaries &disks);
  void weigh(const Primaries &disks);
  /// What is known of why the contact solver finds no solution.
  std::string cause_of_no_solution() const;
  /// Why a step that was not good enough is refused; @p limit of the penetration [m].
  std::string why_not(const DynamicsReport &report, double limit) const;
  /// Finds what loads do to all primaries over a step of @p dt [s].
  void accelerate(double dt);
  /// Means over the step of what pulls on primary @p i. @param loads of the scene; those of its body come
  /// behind them
  void ask_loads(std::size_t i,
                 double dt,
                 std::vector<const Load<2> *> &loads,
                 std::vector<dealii::Tensor<1, 2>> &means) const;
  /// Sums up for primary @p i what each of its loads does.
  void accelerate(std::size_t i, const std::vector<dealii::Tensor<1, 2>> &means);
  /// @param moving see DynamicsSums
  void keep_books(const DynamicsReport &report, double moving);
  /// Closed lines of every body.
  using Outlines = std::vector<std::vector<std::vector<dealii::Point<2>>>>;
  Outlines outlines() const;
  std::vector<double> outlined_areas() const; ///< [m^2]
  void draw_outlines(Outlines &result) const;
  /// Draws the outlines of some bodies where each owner has some primaries. @return which
  std::vector<std::size_t> draw_own_outlines(Outlines &result) const;
  void refresh_solid_area() const;
  /// Writes numbers of all primaries; @p values has those of the primaries here.
  template <class T>
  void write(StateWriter &out, const std::string &name, const std::vector<T> &values) const;
  /// Reads from those of all primaries what belongs to those here.
  template <class T>
  void read(const StateReader &in, const std::string &name, std::vector<T> &here) const;
  bool memory_is_of_attempt = false; ///< of a step that was refused
  void read_wall_contacts(const StateReader &in);
  void show(const GatheredPrimaries &seen, const Outlines &loops, Snapshot<2> &snapshot) const;
  /// Brings bodies into a cell that repeats, and adds the contacts between them and with walls.
  std::optional<FoldedBodies<2>> add_contacts(const GatheredPrimaries &seen, Snapshot<2> &snapshot) const;
  /// Centre of mass of a body of these primaries.
  dealii::Point<2> center_of(const Primaries &disks, std::size_t body) const;
  void show_bodies(const Primaries &disks, const Outlines &loops, Snapshot<2> &snapshot) const;
  ContactState<2> contact_state(const GatheredPrimaries &seen, std::size_t row) const;
  void
  add_inner_forces(const GatheredPrimaries &seen, Snapshot<2> &snapshot, const FoldedBodies<2> *cell) const;
  void add_stresses(const GatheredPrimaries &seen, Snapshot<2> &snapshot) const;
  /// Gives bodies and contacts of @p snapshot from the first one to all.
  void tell_of_bodies(Snapshot<2> &snapshot, const Outlines &loops) const;

  Scene<2> scene;
  Settings settings;
  /// The way by which several share the making of aggregates, and primaries where that can be done: else the
  /// contact solve.
  Exchange exchange;
  std::unique_ptr<dealii::TimerOutput> timer;
  std::unique_ptr<Dynamics> dynamics;
  std::vector<Wall<2>> moving_walls;
  std::vector<Obstacle<2>> moving_obstacles;
  std::vector<std::uint32_t> first_of_body;
  std::vector<bool> fixed;
  std::vector<double> density; ///< of every body
  double natural_time = 0;     ///< attraction_time() of the mean primary of the strongest law, 0 without one
  /// Bodies with the lightest and the heaviest primary that is free to move, and the ratio of these masses.
  std::uint32_t lightest = 0, heaviest = 0;
  double contrast = 1;
  double diameter = 0;                                  ///< mean, of the primaries [m]
  double mass = 0;                                      ///< of all primaries that are free to move [kg/m]
  double characteristic_force = 0;                      ///< F0 of p_I, of the strongest law
  std::vector<std::shared_ptr<const Load<2>>> own_load; ///< of every body beside those of the scene, or null
  std::vector<std::string> load_names;                  ///< of the scene, then that of bodies
  bool is_loaded = false;                               ///< by forces that depend on where a primary started
  bool is_graded = false, rotates = false;              ///< primaries
  std::vector<std::array<double, 2>> acceleration;      ///< of every primary here, empty when nothing pulls
  std::vector<std::vector<std::array<double, 2>>> of_loads; ///< the same of every load but the last

  double now = 0, last_dt = 0;
  StepControl step_control{1.25};
  std::size_t steps = 0;
  std::size_t fallbacks = 0; ///< steps in which the accelerated contact solver gave way to plain sweeps
  Balance balance;
  std::vector<double> area_at_start;    ///< enclosed by the outline of every body [m^2]
  mutable double area_now = -1;         ///< enclosed by all outlines when it was last measured [m^2]
  mutable std::size_t area_of_list = 0; ///< number of neighbour lists made by then
};
} // namespace softgrain::bpm

#endif
