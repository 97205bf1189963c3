// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_system_h
#define softgrain_mpm_contact_system_h

#include <softgrain/contact/gauss_seidel.h>
#include <softgrain/mpm/body.h>
#include <softgrain/mpm/contact_rows.h>
#include <softgrain/mpm/linear_solver.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The contact problem of one step: rows of all bodies, the Delassus operator, the impulses.
 *
 * Component c of row r has index r * n_components + c: the normal first, then the tangent when any row has
 * friction.
 */
template <int dim>
class ContactSystem
{
public:
  /// Takes the rows of a step and the impulses of rows with the same key in the step before as first guess.
  void reinit(std::vector<ContactRow<dim>> rows, const std::vector<Body<dim>> &bodies);

  bool empty() const { return rows.empty(); }
  const std::vector<ContactRow<dim>> &contact_rows() const { return rows; }
  unsigned int n_components() const { return problem.n_components; }
  /// Impulses of the last solve [N s].
  const std::vector<double> &impulses() const { return impulse; }
  /// Relative velocities w of the last solve, gap terms included [m/s].
  const std::vector<double> &velocities() const { return velocity; }

  /// H v for the given nodal velocities, one value per component; driven bodies move as they are driven
  /// [m/s].
  std::vector<double> relative_velocity(const std::vector<Body<dim>> &bodies,
                                        const std::vector<Eigen::VectorXd> &nodal) const;

  /// Adds H^T P of body @p b to @p nodal.
  void add_impulses(unsigned int b, const std::vector<double> &P, Eigen::VectorXd &nodal) const;

  /// W from the bodies' factorised matrices.
  void condense(const std::vector<Body<dim>> &bodies, std::vector<std::unique_ptr<LinearSolver>> &solvers);
  /// W from nodal masses: H M^-1 H^T.
  void lump(const std::vector<Body<dim>> &bodies);

  /**
   * @brief Solves Signorini and Coulomb for the given free relative velocity, starting from the present
   * impulses.
   * @param relative whether @p free_velocity already holds the effect of the present impulses (the result is
   * then the change from them, as the lumped coupling needs it)
   */
  contact::SolverReport
  solve(std::vector<double> free_velocity, const contact::SolverSettings &settings, bool relative = false);

  /// Smallest displacement-like correction tau with 0 <= tau _|_ gap + W tau >= 0 on the normals,
  /// frictionless.
  std::vector<double> repair(const std::vector<double> &gap, const contact::SolverSettings &settings);

  /// Calls of solve() and repair() so far in which momentum was given up for plain sweeps.
  std::uint64_t plain_solves = 0;

  /// Keeps the impulses for the next step.
  void remember();

  /// Saves the problem last given to solve(), for replay.
  void save_problem(const std::string &file,
                    const std::string &description,
                    const contact::SolverSettings &settings) const;

  /// Impulses kept for the next step, by key of the row.
  std::unordered_map<std::uint64_t, std::array<double, dim>> &memory() { return remembered; }
  const std::unordered_map<std::uint64_t, std::array<double, dim>> &memory() const { return remembered; }

private:
  struct Operator;

  void color_pairs(const std::vector<Body<dim>> &bodies);

  std::vector<ContactRow<dim>> rows;
  contact::Problem problem; ///< as last given to solve(); its colours are of pairs that share no body
  std::vector<std::vector<unsigned int>> body_components; ///< components that body b takes part in
  std::vector<LinearSolver::Rows> body_rows;              ///< its H^T on them
  std::vector<double> impulse, velocity, last_start;
  std::shared_ptr<Operator> delassus;
  std::unordered_map<std::uint64_t, std::array<double, dim>> remembered;
};
} // namespace softgrain::mpm

#endif
