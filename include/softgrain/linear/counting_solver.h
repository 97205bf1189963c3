// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_counting_solver_h
#define softgrain_linear_counting_solver_h

#include <softgrain/linear/cholesky_solver.h>

#include <utility>

namespace softgrain
{
/**
 * @brief Solves as another solver does, and always tells how many negative eigenvalues the matrix has.
 *
 * A step without inertia ends in a minimum of the energy only, and the signs of the factors say whether it
 * does. Where the other solver cannot tell, Cholesky factors beside it do. Taken to have none, a body that
 * has some would be held back without end.
 */
class CountingSolver final : public LinearSolver
{
public:
  explicit CountingSolver(std::unique_ptr<LinearSolver> solver) : inner(std::move(solver)) {}

  bool factorize(SystemMatrix &matrix) override;
  std::optional<unsigned int> n_negative() const override { return negative; }
  void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override { inner->solve(b, x); }
  void condense(const Rows &rows, Eigen::MatrixXd &W) override { inner->condense(rows, W); }

private:
  const std::unique_ptr<LinearSolver> inner;
  std::unique_ptr<CholeskySolver> counter; ///< null as long as the other solver counts itself
  std::optional<unsigned int> negative;
};
} // namespace softgrain

#endif
