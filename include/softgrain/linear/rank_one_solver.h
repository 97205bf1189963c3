// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_rank_one_solver_h
#define softgrain_linear_rank_one_solver_h

#include <softgrain/linear/linear_solver.h>

namespace softgrain
{
/**
 * @brief Solves with B + k r rᵀ, where another solver has the factors of B (Sherman and Morrison).
 *
 * A compressed free body has a negative stiffness against rotation, -2 p A with the mean pressure p and the
 * area A, which its contacts make up for. B then has one negative eigenvalue, and the term that makes the sum
 * positive definite is full: it may not go into the sparse matrix.
 */
class RankOneSolver final : public LinearSolver
{
public:
  explicit RankOneSolver(std::unique_ptr<LinearSolver> solver) : inner(std::move(solver)) {}

  /// The term of the next factorize(); @p k = 0 is none.
  void set_update(const Eigen::VectorXd &r, double k);

  /// Whether factorize() takes sums with negative eigenvalues, too: whoever solves with it counts them.
  bool takes_indefinite = false;

  std::optional<unsigned int> n_negative() const override { return negative; }

  /// @return whether B + k r rᵀ is positive definite, as far as the inner solver can tell.
  bool factorize(SystemMatrix &matrix) override;
  void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override;
  void condense(const Rows &rows, Eigen::MatrixXd &W) override;

private:
  std::unique_ptr<LinearSolver> inner;
  Eigen::VectorXd direction, effect; ///< r and B⁻¹ r
  std::optional<unsigned int> negative;
  double factor = 0., weight = 0.; ///< k and k / (1 + k rᵀ B⁻¹ r)
};
} // namespace softgrain

#endif
