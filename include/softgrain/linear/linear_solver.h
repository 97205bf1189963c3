// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_linear_solver_h
#define softgrain_linear_linear_solver_h

#include <softgrain/linear/system_matrix.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <optional>
#include <string>

namespace softgrain
{
/**
 * @brief Solves with the matrix of one body, and condenses it to contact rows.
 */
class LinearSolver
{
public:
  using Rows = Eigen::SparseMatrix<double, Eigen::ColMajor>; ///< H^T: one column per contact component

  virtual ~LinearSolver() = default;

  /// @return false when the matrix is singular. It may have negative eigenvalues, which n_negative() counts;
  /// solvers that cannot tell, or that need a positive definite matrix, may refuse these.
  virtual bool factorize(SystemMatrix &matrix) = 0;
  /// Negative eigenvalues of the matrix last factorised; nothing when the solver cannot tell.
  virtual std::optional<unsigned int> n_negative() const { return 0; }
  /// x = A^-1 b. @throw ComputationError when an iterative solver does not converge.
  virtual void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) = 0;
  /// W = H A^-1 H^T, the Delassus operator of this body on its own rows.
  virtual void condense(const Rows &rows, Eigen::MatrixXd &W) = 0;
};

/// What the `Linear solver` section may say.
struct LinearSolverSettings
{
  std::string type = "automatic";      ///< automatic, or a registered LinearSolverKind
  double tolerance = 1e-10;            ///< relative residual of the iterative solvers
  unsigned int max_iterations = 2000;  ///< of the iterative solvers
  unsigned int automatic_dofs = 40000; ///< above this size `automatic` is `cg_amg` for a body that meets
                                       ///< nothing, else a Cholesky solver
  unsigned int automatic_band = 1200;  ///< half band width up to which `automatic` is `banded_cholesky`
};

/**
 * @brief The solver for a body with the pattern of @p matrix.
 * @param dim number of rigid translations, for the near null space of AMG
 * @param condensed whether contact rows may have to be condensed. That takes a solve for each row, for which
 * iterative solvers are too slow (doc/results/linear-solvers.md)
 * @throw InputError when the type is unknown
 */
std::unique_ptr<LinearSolver> create_linear_solver(const LinearSolverSettings &settings,
                                                   const SystemMatrix &matrix,
                                                   unsigned int dim,
                                                   bool condensed);
} // namespace softgrain

#endif
