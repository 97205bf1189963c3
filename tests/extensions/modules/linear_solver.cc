// SPDX-License-Identifier: LGPL-2.1-or-later
// Dense factors: what they give must be what the band's give, but for rounding.
#include <softgrain/linear/linear_solver_kind.h>
#include <softgrain/linear/system_matrix.h>

#include <Eigen/Cholesky>

using namespace softgrain;

class DenseSolver final : public LinearSolver
{
public:
  bool factorize(SystemMatrix &matrix) override
  {
    matrix.clear_pattern_flag();
    factor.compute(Eigen::MatrixXd(matrix.lower()));
    return factor.info() == Eigen::Success;
  }
  void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override { x = factor.solve(b); }
  void condense(const Rows &rows, Eigen::MatrixXd &W) override
  {
    const Eigen::MatrixXd H = rows;
    W = H.transpose() * factor.solve(H);
    W = 0.5 * (W + W.transpose().eval());
  }

private:
  Eigen::LLT<Eigen::MatrixXd> factor; // of the lower triangle
};

class Dense final : public LinearSolverKind
{
public:
  std::unique_ptr<LinearSolver> create(const LinearSolverSettings &, unsigned int) const override
  {
    return std::make_unique<DenseSolver>();
  }
};

[[maybe_unused]] const bool registered = Registry<LinearSolverKind>::instance().add(
    "dense", "dense factors (Eigen)", [] { return std::make_unique<Dense>(); });
