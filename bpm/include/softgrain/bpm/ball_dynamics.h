// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_ball_dynamics_h
#define softgrain_bpm_ball_dynamics_h

#include <softgrain/bpm/attraction.h>
#include <softgrain/bpm/attraction_batch.h>
#include <softgrain/bpm/dynamics_settings.h>
#include <softgrain/bpm/present_balls.h>
#include <softgrain/bpm/primaries.h>
#include <softgrain/contact/ball_list.h>
#include <softgrain/contact/disk_system.h>
#include <softgrain/driving/wall.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <vector>

namespace dealii
{
class TimerOutput;
}

namespace softgrain::bpm
{
/// What one step of BallDynamics did.
struct BallReport
{
  contact::DiskSolverReport solver;
  dealii::Tensor<1, 3> impulse;  ///< of walls and loads on the balls [N s]
  double contact_loss = 0;       ///< kinetic energy that contacts took [J]
  std::vector<double> load_work; ///< done by every load [J]
  double max_penetration = 0;    ///< after the step [m]
  double farthest = 0;           ///< way of the fastest ball over its radius
};

/// Sums over all balls and contacts.
struct BallSums
{
  double kinetic = 0.;           ///< energy [J]
  double moving = 0.;            ///< mass times speed [N s]
  dealii::Tensor<1, 3> momentum; ///< [N s]
  double attraction = 0.;        ///< energy of the attractions, zero when all pairs are out of range [J]
  std::size_t n_pushing = 0;     ///< contacts with an impulse
};

/**
 * @brief Moreau–Jean steps (θ = 1) of rigid balls in space: attraction, contacts (Signorini, Coulomb), flat
 * walls that are told how to move. What Dynamics is in the plane, without cells that repeat, obstacles,
 * driven bodies, adhesion, rolling resistance and owners.
 *
 * A step: forces and contacts are known for the present places; free velocities; contacts; places move with
 * the velocities after contact; forces and contacts for the new places.
 */
class BallDynamics
{
public:
  using Vector = std::array<double, 3>;
  using Walls = std::vector<Wall<3>>;

  /**
   * @param balls those of a body follow each other; without angular velocities unless needed
   * @param attraction law of every body, null: none
   * @param settings how to step
   */
  BallDynamics(Balls balls,
               std::vector<std::shared_ptr<const Attraction>> attraction,
               const DynamicsSettings &settings);

  /// Forces and contacts of the present places; called once before the first step and after a change of
  /// state.
  void detect(const Walls &walls);

  /**
   * @brief One step of @p dt [s].
   * @param dt length [s]
   * @param walls with the speeds that they are to have; come back moved
   * @param of_loads accelerations of every ball by every load [m/s^2]
   * @throw ComputationError when something is not finite.
   */
  BallReport step(double dt, Walls &walls, const std::vector<std::vector<Vector>> &of_loads);

  /// Notes places and velocities, and goes back to them.
  void keep_motion();
  void take_back_motion(const Walls &walls);

  /// Sections of its work go there; may be null.
  void set_timer(dealii::TimerOutput *timer_output) { timer = timer_output; }

  const Balls &balls() const { return primaries; }
  Balls &balls() { return primaries; }
  const contact::BallList &neighbours() const { return list; }
  contact::BallList &neighbours() { return list; }
  /// Contacts of the present places.
  PresentBalls present() const { return PresentBalls(*this); }
  BallSums sums() const;
  double mean_diameter() const { return diameter; }

  /// Impulses remembered of a contact with a wall, for restarts; by walls, then balls.
  struct WallMemory
  {
    std::uint32_t wall = 0, ball = 0;
    std::array<double, 4> impulse{};
  };
  std::vector<WallMemory> &wall_memory() { return remembered_at_walls; }
  const std::vector<WallMemory> &wall_memory() const { return remembered_at_walls; }

private:
  friend class PresentBalls;

  struct Found
  {
    std::uint32_t pair;
    double gap;
    Vector normal;
  };
  double contact_reach() const;
  bool closes(const Vector &relative, const Vector &normal, double gap) const;
  void attract_and_find(std::size_t tile, AttractionBatch<3> &batch);
  void collect(const Walls &walls);
  void add_wall_rows(const Walls &walls);
  void resize_rows(std::size_t n);
  void set_row(std::size_t row,
               std::uint32_t a,
               std::uint32_t b,
               const Vector &normal,
               double opening,
               double friction,
               const double *memory);
  void prepare_bodies(double dt, const Walls &walls, const std::vector<std::vector<Vector>> &of_loads);
  void prepare_gap_velocities(double dt, const Walls &walls);
  void move_walls(double dt, Walls &walls, BallReport &report);
  void account(double dt, const std::vector<std::vector<Vector>> &of_loads, BallReport &report) const;
  void move_balls(double dt, BallReport &report);
  void remember();

  Balls primaries;
  std::vector<std::shared_ptr<const Attraction>> laws;
  DynamicsSettings settings;
  bool rotations;
  double diameter = 0; ///< mean
  std::vector<double> inverse_mass, inverse_inertia;

  contact::BallList list;
  contact::BallBodies bodies;
  contact::BallContacts rows;
  std::vector<double> gap;
  std::vector<std::uint32_t> pair_of_row;
  std::vector<Vector> force; ///< sum of the attractions on every ball [N]
  std::vector<WallMemory> remembered_at_walls;
  double stored_energy = 0, deepest = 0;
  std::size_t n_lists = 0;
  std::vector<std::vector<Found>> found; ///< contacts of every tile
  std::vector<double> tile_energy;
  RoundMotion<3> kept;
  dealii::TimerOutput *timer = nullptr;
};
} // namespace softgrain::bpm

#endif
