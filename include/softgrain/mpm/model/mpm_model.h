// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_mpm_model_h
#define softgrain_mpm_model_mpm_model_h

#include <softgrain/driving/step_control.h>
#include <softgrain/model/memory_state.h>
#include <softgrain/model/model.h>
#include <softgrain/mpm/model/load_balance.h>
#include <softgrain/mpm/stepping/step.h>
#include <softgrain/mpm/stepping/time_integrator.h>

#include <array>
#include <memory>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The material point model of a scene: one field per body on a shared lattice, bodies and walls meet
 * at rows.
 */
class MpmModel final : public Model<2>
{
public:
  /**
   * @param laws one per material of the scene
   * @throw InputError when scene and settings do not fit together
   */
  MpmModel(const Scene<2> &scene,
           const Settings &settings,
           std::vector<std::shared_ptr<const constitutive::Law<2>>> laws);
  ~MpmModel() override;

  std::string name() const override { return "mpm"; }
  StepReport advance(double dt_limit) override;
  void forget_attempt() override { last_dt = 0.; }
  void settle(StepReport &report) override;
  std::string share_out_anew() override;
  void take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives) override;
  double time() const override { return state.time; }
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
  std::size_t n_points() const override;
  std::size_t n_bodies() const override;
  RankTimes rank_times() const override { return work.share.exchange.taken(); }
  SizeReport size_report() const override;
  std::vector<std::pair<std::string, double>> works() const override;
  std::vector<std::pair<std::string, double>> extra_history() const override;
  std::map<std::string, double> phases() const override;
  void save(StateWriter &) const override;
  void load(StateReader &) override;

  /// Cell size over the speed of pressure waves, the smallest of all bodies [s].
  double cfl_step() const;
  /// The step that the settings ask for [s].
  double wanted_step() const;

  const std::vector<Body<2>> &bodies() const { return state.bodies; }

  /// Gives every body to an owner between steps, with its points and all else that its owner alone has. No
  /// result depends on it. All call it with the same @p owners.
  void move_bodies(std::vector<unsigned int> owners);

private:
  /// Whether a step that nothing was said of resolves what bodies do by themselves.
  bool waves_count() const;
  /// Speed of the fastest of those that move rigidly, whatever they meet [m/s].
  double fastest_driven_body() const;
  double rotational_energy() const;
  bool laws_limit_step() const;
  void build(std::vector<std::shared_ptr<const constitutive::Law<2>>> laws);
  StepReport try_steps(double dt_limit);
  /// Name, place and speed of the fastest body, for messages.
  std::string fastest_body() const;
  /// Whether steps end in balance. They keep the state before them: held steps may end early, and leave
  /// nothing behind then.
  bool at_rest() const { return problem.settings.scheme.ends_in_balance(); }
  void renew_grids();
  /// Distortions of the grids of all bodies, see grid_distortion(); found only where they are asked for.
  std::vector<double> grid_distortions() const;
  /// Makes the mesh where points of owned bodies may be.
  void cover_points();
  /// Makes the points of all bodies, and lays their first grids: each owner for its own.
  void fill_bodies(const std::vector<BodyDescription<2>> &descriptions);
  /// Gives every body to an owner, if there are several.
  void share_out_bodies(const std::vector<BodyDescription<2>> &descriptions);
  /// Whether the points of every body lie here when these own the bodies.
  std::vector<char> held_here(const std::vector<unsigned int> &owners) const;
  /// Takes points of bodies that have moved: @p points are those that were here, as save_points() writes
  /// them.
  void take_moved(const StateReader &points, const std::vector<char> &comes, const std::vector<char> &goes);
  /// Keeps what all know of a body whose points have gone to another owner.
  void keep_outline(Body<2> &body);
  /// Whether the matrix of a body is needed here.
  bool needs_matrix(const Body<2> &body) const;
  /// Matrix and solver of a body, where they are needed.
  void prepare_solver(const Body<2> &body);
  /// The same matrix for another grid.
  void lay_out_matrix(const Body<2> &body);
  std::vector<unsigned int> all_bodies() const;
  /// Moves the points of these bodies along with their grids and lays new ones.
  void lay_grids_anew(const std::vector<unsigned int> &bodies);
  /// Tells other owners what belongs to nodes and outlines, after grids were laid.
  void share_grids(const std::vector<unsigned int> &of_bodies);
  void share_trial_volumes(const std::vector<unsigned int> &of_bodies);
  /// What a checkpoint holds; @p of_all: of the points of all owners, to be called by all, else of those
  /// here.
  void write_state(StateWriter &out, bool of_all) const;
  void save_points(StateWriter &out, bool of_all) const;
  /// Reads back what write_state() has written, of the points of all owners or of those here.
  void read_state(StateReader &in, bool of_all);
  void read_progress(const StateReader &in);
  void read_contacts(const StateReader &in);
  void read_nodes(const StateReader &in, Body<2> &body);
  void load_points(const StateReader &in, bool of_all);
  /// Mean stress of every body times its volume, and the volume, each from the body's owner.
  std::vector<std::array<double, 4>> stress_sums() const;
  PointStates<2> point_states() const;
  /// Brings bodies into a cell that repeats, and adds the contacts.
  void add_contacts(Snapshot<2> &snapshot) const;
  /// What came of that.
  void add_ranks(SizeReport &report) const;
  void check_energy() const;
  void update_momentum_scale();
  void refresh_forces(Body<2> &body);
  /// A body that has come to another copy of the cell that repeats is the same there.
  void bring_into_cell(Body<2> &body) const;
  dealii::Tensor<1, 2> momentum() const;
  BodyState<2> body_state(const Body<2> &body, const std::array<double, 4> &stress_sum) const;

  Problem problem;
  State state;
  Workspace work;
  LoadBalance balance;
  std::unique_ptr<dealii::TimerOutput> timer;
  std::size_t steps = 0;
  bool moved_by_more = false; ///< whether bodies are moved by more than walls
  StepControl step_control{1.5};
  std::uint64_t held_steps = 0;
  std::uint64_t law_cuts = 0;   ///< steps that were tried again shorter because a law asked for it
  std::size_t settled_step = 0; ///< the last step after which settle() had its way
  MemoryState before_step;      ///< if at_rest()
  double last_unbalanced = 0.;
  double last_dt = 0.;
  double initial_energy = 0.; ///< [J/m]
};
} // namespace softgrain::mpm

#endif
