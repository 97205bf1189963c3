// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_cholesky_solver_h
#define softgrain_linear_cholesky_solver_h

#include <softgrain/linear/linear_solver.h>

namespace softgrain
{
/// Sparse Cholesky factors of Eigen; the symbolic part is kept as long as the pattern stays.
class CholeskySolver final : public LinearSolver
{
public:
  CholeskySolver();
  ~CholeskySolver() override;

  bool factorize(SystemMatrix &matrix) override;
  std::optional<unsigned int> n_negative() const override;
  void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override;
  void condense(const Rows &rows, Eigen::MatrixXd &W) override;

private:
  struct Factor;
  std::unique_ptr<Factor> factor;
  bool analyzed = false;
};
} // namespace softgrain

#endif
