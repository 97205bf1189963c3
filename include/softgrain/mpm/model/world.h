// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_world_h
#define softgrain_mpm_model_world_h

#include <softgrain/base/parallel.h>
#include <softgrain/driving/adhesion.h>
#include <softgrain/driving/balance.h>
#include <softgrain/driving/cell_motion.h>
#include <softgrain/driving/obstacle.h>
#include <softgrain/driving/wall.h>
#include <softgrain/linear/linear_solver.h>
#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/contact/contact_geometry.h>
#include <softgrain/mpm/contact/contact_system.h>
#include <softgrain/mpm/field/lattice.h>
#include <softgrain/mpm/field/shape_function.h>
#include <softgrain/mpm/model/settings.h>
#include <softgrain/scene/contact_pairs.h>
#include <softgrain/scene/scene.h>

#include <deal.II/base/tensor.h>
#include <deal.II/base/timer.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace softgrain::mpm
{
template <int dim>
class PointStore;
struct StepOutcome;
struct StressOutcome;

/// What a step is to do.
struct StepPlan
{
  double dt = 0;             ///< [s]
  bool held = false;         ///< walls and loads stand still and no time passes: the bodies come to balance
  double regularisation = 0; ///< of quasi_static: stiffness against motion per body, over Young's modulus
  /// First guess for the displacements over the step of a scheme without inertia [m]; null: none.
  const std::vector<Eigen::VectorXd> *guess = nullptr;
};

/// What the balances of MPM are made of beside those of every model, since the start; per metre of thickness.
struct Balance : softgrain::Balance
{
  double law_loss = 0;            ///< [J/m]
  double scheme_damping = 0;      ///< taken by theta > 1/2 [J/m]
  double subgrid_energy = 0;      ///< in the dents that the grid misses, now [J/m]
  double regularisation_work = 0; ///< taken by the regularising forces of `quasi_static` [J/m]
  double released_energy = 0;     ///< lost in held steps, where bodies rearrange, beside what is booked [J/m]
  dealii::Tensor<1, 2>
      carried_load; ///< `newmark`: body forces at the end of the last step, part of the acceleration [N/m]

  /// All that is lost [J/m].
  double dissipated() const
  {
    return contact_loss + law_loss + scheme_damping + regularisation_work + released_energy +
           wall_damping_loss;
  }
};

/**
 * @brief Everything an MPM computation holds: what a step reads and, once accepted, changes.
 */
struct World
{
  World();
  ~World();

  Scene<2> scene;
  Settings settings;
  std::unique_ptr<Lattice<2>> lattice;
  std::unique_ptr<ShapeFunction> shape;
  std::unique_ptr<PointStore<2>> points; ///< of all bodies
  std::vector<Body<2>> bodies;
  std::vector<Wall> walls;
  std::vector<Obstacle> obstacles;
  std::vector<SystemMatrix> matrices;                  ///< one per body, implicit schemes
  std::vector<std::unique_ptr<RankOneSolver>> solvers; ///< one per body, implicit schemes
  std::unique_ptr<ContactGeometry<2>> geometry;
  ContactSystem<2> contact;
  ContactPairs pairs; ///< what bodies and walls do to each other
  Adhesion adhesion;
  Balance balance;
  double time = 0; ///< [s]
  dealii::TimerOutput *timer = nullptr;

  /// Finds the cells of all points after their places have changed, and the order of the bodies' points.
  void sort_points();

  /// What the grid misses of light contacts.
  SubgridCompliance subgrid() const;

  /// Whether places that look for contact stand in space, so that round bodies touch where their outlines do:
  /// without friction, and without inertia, where a step holds what is at a place now to what was opposite.
  bool places_are_free() const { return slippery() || (!settings.scheme.inertia && !adhesion.remembers()); }

  /// Whether nothing holds material to material where bodies meet: no friction, no contact with a memory.
  bool slippery() const { return pairs.frictionless() && !adhesion.remembers() && !rough(scene.obstacles); }

  /// How walls move in a step, slabs among them; obstacles plan their way.
  std::vector<WallMotion<2>> wall_motion(const StepPlan &plan);

  /// Whether it is a cell that repeats.
  bool repeats() const;

  /// How the cell deforms in a step; nothing when it does not repeat.
  std::optional<CellMotion> cell_motion(const std::vector<WallMotion<2>> &motion) const;

  /// After a step of @p dt in which the cell deformed: velocities are those beside that of the cell as it is
  /// now, so that its copies stay alike (CellMotion); books what that does.
  void measure_against_cell(const CellMotion &cell, double dt);

  /// A body that has come to another copy of the cell that repeats is the same there.
  void bring_into_cell(Body<2> &body) const;

  /// Finds the contact rows of a step.
  /// @param increment displacement of the nodes over the step as far as it is known, null: by their
  /// velocities
  /// @param share     where in the step places and normals are taken
  /// @param again     whether rows of this step are replaced; they hand their impulses on
  /// @param start_gaps true_gaps() at the start, null: gaps are drawn back from where rows are taken
  void find_rows(const std::vector<WallMotion<2>> &motion,
                 double dt,
                 const std::vector<Eigen::VectorXd> *increment,
                 double share,
                 bool again,
                 const GapsByRow *start_gaps = nullptr);

  /// Gaps of all rows at the start of a step with displacements @p increment (@p share = 0), or at its end
  /// (1).
  GapsByRow true_gaps(const std::vector<WallMotion<2>> &motion,
                      double dt,
                      const std::vector<Eigen::VectorXd> &increment,
                      double share) const;

  /// Notes what has become of the contacts in an accepted step, for laws that remember.
  /// @param increment displacement of the nodes over the step [m]
  void note_contacts(const std::vector<Eigen::VectorXd> &increment,
                     const std::vector<WallMotion<2>> &motion,
                     double dt);

  /// Calls @p work for every body that is not driven, on all threads; it may write only to what is its
  /// body's.
  template <class Work>
  void for_moving_bodies(const Work &work)
  {
    parallel_for(bodies.size(), 1,
                 [&](const std::size_t begin, const std::size_t end)
                 {
                   for (std::size_t b = begin; b < end; ++b)
                     if (!bodies[b].driven)
                       work(bodies[b]);
                 });
  }

  /// Takes back an accepted @p outcome when the law of a body asks for a shorter step.
  void heed_laws(const std::vector<StressOutcome> &stress, StepOutcome &outcome) const;

  /// Time that passes for laws in a step; none while bodies come to balance [s].
  static double law_dt(const StepPlan &plan) { return plan.held ? 0. : plan.dt; }

  /// Why a step is no good in which the points of body @p body came out as @p outcome tells.
  std::string why_not(unsigned int body, const StressOutcome &outcome) const;
};

/// What a step tried and found; only an accepted one is written into the world.
struct StepOutcome
{
  bool accepted = false;
  std::string reason;    ///< why not: names body, place and what happened
  double share = 0.5;    ///< of the step with which it is to be tried again when it is not accepted
  bool law_asks = false; ///< it is not accepted only because a law asks for a shorter one
  unsigned int newton_iterations = 0, contact_sweeps = 0;
  double newton_residual = 0, contact_residual = 0, max_penetration = 0;
  bool rows_settled = true;    ///< the contact rows are those of the step as it came out
  double largest_move = 0;     ///< of a node over the step [m]
  unsigned int held_steps = 0; ///< of quasi_static, after the step itself
  double unbalanced = 0;       ///< unbalanced_force() at the end, of quasi_static
};

/// One implicit step (moreau_jean, newmark, quasi_static); the world changes only if it is accepted.
StepOutcome implicit_step(World &world, const StepPlan &plan);

/// One step of symplectic Euler.
StepOutcome explicit_step(World &world, double dt);

/**
 * @brief Writes an accepted step into the world: nodes, points, boundary, walls and balances.
 * @param end_velocity of the nodes of every body [m/s]
 * @param increment    their displacement over the step [m]
 * @param rate         mean velocity over the step, with which impulses do their work [m/s]
 */
void accept_step(World &world,
                 const StepPlan &plan,
                 std::vector<Eigen::VectorXd> &end_velocity,
                 const std::vector<Eigen::VectorXd> &increment,
                 const std::vector<Eigen::VectorXd> &rate,
                 const std::vector<WallMotion<2>> &motion,
                 const std::vector<Eigen::VectorXd> &external);

/// Gap of every row at the end of the step, to first order in the increments [m].
std::vector<double> end_gaps(const World &world,
                             const std::vector<Eigen::VectorXd> &increment,
                             const std::vector<WallMotion<2>> &motion,
                             double dt);
} // namespace softgrain::mpm

#endif
