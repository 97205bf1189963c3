// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_contact_system_h
#define softgrain_mpm_contact_contact_system_h

#include <softgrain/contact/gauss_seidel.h>
#include <softgrain/linear/rank_one_solver.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/contact/body_rows.h>
#include <softgrain/mpm/contact/contact_memory.h>
#include <softgrain/mpm/contact/contact_rows.h>
#include <softgrain/mpm/contact/free_walls.h>

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The contact problem of one step: rows of all bodies, the Delassus operator, the impulses.
 *
 * Component c of row r has index r * n_components + c: the normal first, then the tangent when any row has
 * friction. The impulses of the stops of free walls follow.
 */
template <int dim>
class ContactSystem
{
public:
  /// Takes the rows of a step of length @p dt. First guess are the forces of rows with the same key in the
  /// step @p before. What rows do to the nodes of a body is known to its owner, or @p everywhere.
  void reinit(std::vector<ContactRow<dim>> rows,
              const BodyShare &share,
              bool everywhere,
              const std::vector<Body<dim>> &bodies,
              double dt,
              const ContactMemory<dim> &before);

  /// Walls that are unknowns of the step; to be set before reinit().
  FreeWalls<dim> free_walls;

  bool empty() const { return rows.empty() && free_walls.n_stops() == 0; }
  const std::vector<ContactRow<dim>> &contact_rows() const { return rows; }
  unsigned int n_components() const { return problem.n_components; }
  /// Impulses of the last solve [N s].
  const std::vector<double> &impulses() const { return impulse; }
  /// Relative velocities w of the last solve, gap terms included [m/s].
  const std::vector<double> &velocities() const { return velocity; }

  /// Nodal velocities of body b [m/s].
  using Velocities = std::function<const Eigen::VectorXd &(unsigned int b)>;

  /// H v for the given nodal velocities, one value per component; driven bodies move as @p drive says, one
  /// per body [m/s]. Every owner is asked for velocities of its own bodies, and learns the values of all.
  std::vector<double> relative_velocity(const BodyShare &share,
                                        const std::vector<Body<dim>> &bodies,
                                        const std::vector<dealii::Tensor<1, dim>> &drive,
                                        const Velocities &nodal) const;

  /// Adds H^T P of body @p b, whose rows are known here, to @p nodal, with the present impulses.
  void add_impulses(unsigned int b, Eigen::VectorXd &nodal) const;

  /**
   * @brief W from the bodies' factorised matrices.
   * @param share whose body is whose: its matrix is there
   */
  void condense(const BodyShare &share,
                const std::vector<Body<dim>> &bodies,
                std::vector<std::unique_ptr<RankOneSolver>> &solvers);

  /// W from nodal masses, H M^-1 H^T, plus the softness of rows in a step of length @p dt [s].
  void lump(const std::vector<Body<dim>> &bodies, double dt);

  /**
   * @brief Solves Signorini and Coulomb for the given free relative velocity, starting from the present
   * impulses.
   * @param relative whether @p free_velocity already holds the effect of the present impulses (the result is
   * then the change from them, as the lumped coupling needs it)
   */
  contact::SolverReport
  solve(std::vector<double> free_velocity, const contact::SolverSettings &settings, bool relative = false);

  /// Calls of solve() so far in which momentum was given up for plain sweeps.
  std::uint64_t plain_solves = 0;

  /// What the next step is to begin with after one of length @p dt [s].
  ContactMemory<dim> memory(double dt) const;

  /// Saves the problem last given to solve(), for replay.
  void save_problem(const std::string &file,
                    const std::string &description,
                    const contact::SolverSettings &settings) const;

private:
  struct Operator;

  void list_components(const std::vector<Body<dim>> &bodies);
  void keep_pushes();
  bool knows_rows_of(unsigned int b) const { return rows_here[b] && !body_components[b].empty(); }
  void color_pairs(const std::vector<Body<dim>> &bodies);
  void color(const std::vector<unsigned int> &taking,
             contact::Problem::Range range,
             std::vector<std::vector<char>> &taken);

  std::vector<ContactRow<dim>> rows;
  contact::Problem problem; ///< as last given to solve(); its colours are of pairs that share no body
  std::vector<std::vector<unsigned int>> body_components; ///< components that body b takes part in
  std::vector<unsigned int> component_start;              ///< of body b among all bodies', and the end
  std::vector<BodyRows<dim>> body_rows;                   ///< its H^T on them, where rows_here
  std::vector<char> rows_here;
  std::vector<unsigned int> rows_at_driven; ///< whose partner is a driven body
  std::vector<Eigen::VectorXd>
      pushes; ///< H^T P of the same bodies after a solve(), asked for several times; else none
  std::vector<double> impulse, velocity, last_start;
  std::shared_ptr<Operator> delassus;
};

/// Whether row @p r of a system pushes, or pulls because it adheres.
template <int dim>
bool carries_force(const ContactSystem<dim> &system, const unsigned int r)
{
  const double P = system.impulses()[r * system.n_components()];
  return P > 0. || (P < 0. && system.contact_rows()[r].law.pull > 0.);
}

/// Rows yield to the change of their force only: subtracts from @p free_velocity [m/s] what softness makes of
/// the impulses with which the next solve() starts, those of the step before. @param dt length of the step
/// [s]
template <int dim>
void take_back_softness(const ContactSystem<dim> &system, double dt, std::vector<double> &free_velocity);
} // namespace softgrain::mpm

#endif
