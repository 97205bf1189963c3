// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_dynamics_h
#define softgrain_bpm_dynamics_h

#include <softgrain/base/exact_sum.h>
#include <softgrain/bpm/attraction.h>
#include <softgrain/bpm/attraction_batch.h>
#include <softgrain/bpm/contact_memories.h>
#include <softgrain/bpm/dynamics_report.h>
#include <softgrain/bpm/dynamics_settings.h>
#include <softgrain/bpm/dynamics_sums.h>
#include <softgrain/bpm/present_contacts.h>
#include <softgrain/bpm/primaries.h>
#include <softgrain/bpm/strip_share.h>
#include <softgrain/contact/disk_system.h>
#include <softgrain/contact/neighbour_list.h>
#include <softgrain/driving/cell_motion.h>
#include <softgrain/driving/obstacle.h>
#include <softgrain/driving/obstacle_feet.h>
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/model/state_file.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace dealii
{
class TimerOutput;
}

namespace softgrain::bpm
{
/**
 * @brief Moreau–Jean steps (θ = 1) of rigid disks: attraction, contacts (Signorini, Coulomb), walls.
 *
 * A step: forces and contacts are known for the present places; free velocities; contacts; places move with
 * the velocities after contact; forces and contacts for the new places. In a cell that repeats, places are
 * anywhere in its lattice, and velocities those beside the motion of the cell (see CellMotion).
 *
 * Several owners that have been told to part() have some primaries each, see StripShare; all call the same in
 * the same order. On the first one, copies of primaries at walls stand behind the others. What a step
 * reports, and sums and counts, are those of all.
 */
class Dynamics
{
public:
  /**
   * @param primaries disks; those of a body follow each other; without angular velocities unless needed
   * @param attraction law of every body, null: none
   * @param fixed bodies that keep their velocity whatever they meet; empty: none
   * @param settings how to step
   * @param timer sections of its work go there; may be null
   */
  Dynamics(Primaries primaries,
           std::vector<std::shared_ptr<const Attraction>> attraction,
           std::vector<bool> fixed,
           const DynamicsSettings &settings,
           dealii::TimerOutput *timer = nullptr);

  /// Forces and contacts of the present places; called once before the first step and after a change of
  /// state.
  void detect(const std::vector<Wall<2>> &walls);

  /**
   * @brief One step of @p dt [s].
   * @param dt length [s]
   * @param walls with the speed they are to have (prescribed) or had and the load on them (free); come back
   * moved
   * @param acceleration of every primary by loads [m/s^2], or empty
   * @param of_loads the same of every load but the last
   * @throw ComputationError when something is not finite.
   */
  DynamicsReport step(double dt,
                      std::vector<Wall<2>> &walls,
                      const std::vector<std::array<double, 2>> &acceleration,
                      const std::vector<std::vector<std::array<double, 2>>> &of_loads = {});

  /// What else primaries meet; planned by the caller before a step, they go their way in it. May be null.
  void set_obstacles(std::vector<Obstacle<2>> *list);

  /**
   * @brief Shares the work with those who have all called this, by @p everyone, which has to stay. Before the
   * first detect(), when all have the same primaries.
   *
   * Each gets a part of the primaries if it can be done: not in a cell that repeats, with adhesion or
   * obstacles. Else they share the contact solve.
   */
  void share_by(const Exchange &everyone, const std::vector<Wall<2>> &walls);
  /// Who has which primaries; null: all are here.
  const StripShare *strips() const { return share.get(); }
  /// Notes places and velocities, or forgets what was noted.
  void keep_motion(bool keeps);
  /// Goes back to what was noted.
  void take_back_motion(const std::vector<Wall<2>> &walls);

  /// Makes the list of neighbours for the places that primaries have now, with what its pairs remember in a
  /// state; for restarts. Other places and velocities come afterwards.
  void build_list(const contact::ImageLattice &lattice, const StateReader &in, const std::string &name);

  const Primaries &disks() const { return primaries; }
  Primaries &disks() { return primaries; }

  /// Contacts of the present places.
  PresentContacts present() const { return PresentContacts(*this); }
  /// Sums over all primaries and contacts, whoever owns them.
  DynamicsSums sums() const;
  /// The deepest overlap with its bodies and its place, of all there are. With @p bodies_apart it is that
  /// between different bodies, and with walls and obstacles.
  Overlap deepest_overlap(bool bodies_apart = false) const;

  /// What contacts remember beside the impulses of pairs, for restarts.
  const ContactMemories &memories() const { return remembered; }
  ContactMemories &memories() { return remembered; }

private:
  friend class PresentContacts;

  /// A primary near a wall.
  struct AtWall
  {
    std::uint32_t wall, primary;
    double gap; ///< [m]
  };
  /// Calls @p work; if it fails for one of those that have parted, all fail.
  template <class Work>
  void alike(const Work &work) const
  {
    if (share)
      share->exchange.together(work);
    else
      work();
  }
  void weigh();
  void update_list();
  std::vector<ExactSum> sums_of_motion() const;
  /// Whether a row pushes, or pulls because it adheres.
  bool carries_force(const std::size_t row) const
  {
    return rows.impulse[row] > 0. || (!pull.empty() && pull[row] > 0. && rows.impulse[row] < 0.);
  }
  DynamicsSums sum_motion() const;
  std::size_t n_own() const { return share ? share->n_own() : primaries.size(); }
  /// Strength of the attraction of two primaries over that of their law.
  double strength_of(const std::uint32_t a, const std::uint32_t b) const
  {
    return primaries.strength.empty() ? 1. : 0.5 * (primaries.strength[a] + primaries.strength[b]);
  }
  void sum_up();
  std::vector<AtWall>
  find_at_walls(const std::vector<Wall<2>> &walls, std::size_t begin, std::size_t end) const;
  void add_wall_rows(const std::vector<Wall<2>> &walls, const std::vector<AtWall> &found);
  void bring_wall_rows(const std::vector<Wall<2>> &walls);
  std::vector<double> wall_list(const std::vector<AtWall> &at_walls,
                                const std::vector<std::uint32_t> &of_them) const;
  /// What the first owner gathers of primaries at walls.
  struct WallGuests
  {
    std::vector<AtWall> at_walls;
    /// What every other owner has, by places here: its own primaries at walls, and its copies of some.
    std::map<unsigned int, std::vector<std::uint32_t>> own, copies;
  };
  void take_guests(unsigned int owner, const std::vector<double> &list, WallGuests &guests);
  unsigned int numbers_of_guest() const;
  void add_guest(std::uint32_t name, const double *number);
  void drop_guests();
  void tell_forces(unsigned int colour);
  void tell_energies();
  void tell_of_walls(std::vector<double> &normal, std::vector<double> &tangential);

  /// Gap up to which a pair is looked at [mean diameters].
  double contact_reach() const;
  void attract_and_find(std::size_t tile, AttractionBatch<2> &batch);
  void collect(const std::vector<Wall<2>> &walls);
  void collect_obstacles(std::size_t n_walls);
  /// Impulses of the last step of a primary at piece @p surface of the line with pieces from @p first to
  /// @p end.
  contact::PairMemory::Impulses
  remembered_at(std::uint32_t surface, std::uint32_t primary, std::uint32_t first, std::uint32_t end) const;
  void drive_obstacles(std::size_t n_walls);
  /// Velocity in the step to come of the place of an obstacle that row @p row touches [m/s].
  dealii::Tensor<1, 2> obstacle_velocity(std::size_t row) const;
  void move_obstacles(double dt, DynamicsReport &report);
  bool closes(const std::array<double, 2> &relative, const std::array<double, 2> &normal, double gap) const;
  void see_cell(const std::vector<Wall<2>> &walls);
  contact::ImageLattice lattice() const;
  void find_centers();
  /// Branch in a cell: from the centre of the body of @p b, or its image, to that of @p a; 0 in a body [m].
  dealii::Tensor<1, 2> branch(std::uint32_t a, std::uint32_t b, const PeriodicCell<2>::Image &image) const;
  void prepare_cell(double dt, const std::vector<Wall<2>> &walls);
  /// Puts the forces through the sides of the cell on them, and lets those that are free go. @param impulse
  /// of sides on what is in the cell, along their normals [N s/m]
  void load_cell(double dt, std::vector<Wall<2>> &walls, std::vector<double> &impulse);
  void take_along(double dt, std::vector<Wall<2>> &walls, DynamicsReport &report);
  void resize_rows(std::size_t n);
  void set_row(std::size_t row,
               std::uint32_t a,
               std::uint32_t b,
               const std::array<double, 2> &normal,
               double opening,
               double friction,
               double rolling,
               const contact::PairMemory::Impulses &memory);
  void prepare_bodies(double dt,
                      const std::vector<Wall<2>> &walls,
                      const std::vector<std::array<double, 2>> &acceleration);
  void prepare_gap_velocities(double dt, const std::vector<Wall<2>> &walls);
  void find_pulls();
  void shift_cones(double dt, bool back);
  double adhesion_work(double dt, const std::vector<Wall<2>> &walls) const;
  void note_contacts(double dt);
  std::uint64_t key_of(const std::size_t row) const
  {
    return (static_cast<std::uint64_t>(rows.a[row]) << 32) | rows.b[row];
  }
  void remember();
  void move_walls(double dt, std::vector<Wall<2>> &walls, DynamicsReport &report);
  void move_primaries(double dt);
  /// Deepest overlap, of primaries with each other and with obstacles, between the ends of the step that they
  /// have just made; found from their ways alone, not from rows.
  Overlap deepest_on_the_way(double dt) const;
  Overlap deepest_of_disks(double dt, double limit) const;
  Overlap deepest_of_ranks(double dt, double limit) const;
  Overlap deepest_in_obstacles(double dt) const;
  Overlap deepest_of_all_ranks(const Overlap &here) const;
  /// Lets wall @p w go that way, in which it is free: books what its load and its damping do. @param push of
  /// the primaries [N s/m]
  void let_go(
      double dt, std::size_t w, Freedom direction, double push, Wall<2> &wall, DynamicsReport &report) const;
  /// Sums of what primaries do in a step.
  struct Work;
  /// Adds what a primary that is free to move does.
  void add_work(std::size_t i,
                double dt,
                const std::vector<std::array<double, 2>> &acceleration,
                const std::vector<std::vector<std::array<double, 2>>> &of_loads,
                Work &work) const;
  void account(double dt,
               const std::vector<std::array<double, 2>> &acceleration,
               const std::vector<std::vector<std::array<double, 2>>> &of_loads,
               DynamicsReport &report) const;
  void account_driven(double dt, DynamicsReport &report) const;

  Primaries primaries;
  std::vector<std::shared_ptr<const Attraction>> laws;
  DynamicsSettings settings;
  bool rotations;
  double diameter = 0; ///< mean
  double smallest = 0; ///< diameter
  std::vector<double> inverse_mass;

  contact::NeighbourList list;
  contact::DiskBodies bodies;
  contact::DiskContacts rows;
  std::vector<double> gap;
  std::vector<double> pull; ///< cohesive force of every row [N/m]; empty: nothing adheres
  std::vector<std::uint32_t> pair_of_row;
  std::vector<std::array<double, 2>> force;
  ContactMemories remembered;
  std::optional<CellMotion<2>> cell;            ///< as the walls move now; nothing where nothing repeats
  std::vector<dealii::Point<2>> center_of_body; ///< in a cell [m]
  std::vector<double> mass_of_body;             ///< in a cell [kg/m]

  /// A row with an obstacle; they are the last ones.
  struct ObstacleRow
  {
    std::uint32_t obstacle, surface; ///< index; its piece, counted on after the walls
    dealii::Point<2> drawn;          ///< where it is touched, as it is drawn [m]
    double slip = 0;                 ///< its velocity along t in the step [m/s]
  };
  std::vector<ObstacleRow> obstacle_rows;
  std::vector<Obstacle<2>> *obstacles = nullptr;
  std::optional<ObstacleFeet> feet; ///< where they are touched
  double stored_energy = 0, deepest = 0;
  std::size_t n_lists = 0;

  struct Found
  {
    std::uint32_t pair;
    double gap;
    std::array<double, 2> normal;
  };
  std::vector<std::vector<Found>> found; ///< contacts of every tile
  std::vector<double> tile_energy;
  dealii::TimerOutput *timer;
  const Exchange *exchange = nullptr;
  std::vector<bool> fixed; ///< bodies; empty: none
  Motion kept;
  std::unique_ptr<StripShare> share; ///< null: all primaries are here
  DynamicsSums totals;               ///< where not all are here
  contact::DiskExchanges exchanges;
};

/// Number of all primaries, whoever owns them.
inline std::size_t n_all(const Dynamics &dynamics)
{
  return dynamics.strips() != nullptr ? dynamics.strips()->n_all() : dynamics.disks().size();
}

/// Number of the owned primaries, which are no copies of those of others; they come first.
inline std::size_t n_own(const Dynamics &dynamics)
{
  return dynamics.strips() != nullptr ? dynamics.strips()->n_own() : dynamics.disks().size();
}

/// Calls @p work for all primaries here whose number, among all there are, is from @p begin to @p end,
/// without it: index, number.
template <class Work>
void for_numbers(const Dynamics &dynamics, const std::size_t begin, const std::size_t end, const Work &work)
{
  const std::vector<std::uint32_t> &number = dynamics.disks().number;
  if (number.empty())
  {
    for (std::size_t i = begin; i < std::min(end, dynamics.disks().size()); ++i)
      work(i, i);
    return;
  }
  // Own ones stand by number; copies and guests are few.
  const auto own_end = number.begin() + n_own(dynamics);
  for (auto i = std::lower_bound(number.begin(), own_end, begin); i != own_end && *i < end; ++i)
    work(i - number.begin(), *i);
  for (auto i = own_end; i != number.end(); ++i)
    if (*i >= begin && *i < end)
      work(i - number.begin(), *i);
}

/// Writes the impulses that pairs remember, in the order of the list of all.
void save_memory(const Dynamics &dynamics, StateWriter &out, const std::string &name);
} // namespace softgrain::bpm

#endif
