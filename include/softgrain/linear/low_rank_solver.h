// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_low_rank_solver_h
#define softgrain_linear_low_rank_solver_h

#include <softgrain/linear/linear_solver.h>

namespace softgrain
{
/**
 * @brief Solves with B + k R Rᵀ, where another solver has the factors of B and R has a few columns
 * (Woodbury).
 *
 * It holds what a body may do as a whole, such as its three rotations in space, by a term that is full and
 * may not go into the sparse matrix. B and the sum may have negative eigenvalues; they are counted.
 * RankOneSolver does the same for one column, and can refuse what is not positive definite.
 */
class LowRankSolver final : public LinearSolver
{
public:
  explicit LowRankSolver(std::unique_ptr<LinearSolver> solver) : inner(std::move(solver)) {}

  /// The term of the next factorize(); @p k > 0, or no columns for none.
  void set_update(const Eigen::MatrixXd &columns, double k);

  /// @return false when B or the sum is singular
  bool factorize(SystemMatrix &matrix) override;
  std::optional<unsigned int> n_negative() const override { return negative; }
  void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override;
  void condense(const Rows &rows, Eigen::MatrixXd &W) override;

private:
  std::unique_ptr<LinearSolver> inner;
  Eigen::MatrixXd R, effect; ///< and B⁻¹ R
  Eigen::MatrixXd small;     ///< (I/k + Rᵀ B⁻¹ R)⁻¹
  std::optional<unsigned int> negative;
  double factor = 0.;
};
} // namespace softgrain

#endif
