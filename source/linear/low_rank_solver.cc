// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/linear/low_rank_solver.h>

#include <Eigen/Eigenvalues>

namespace softgrain
{
void LowRankSolver::set_update(const Eigen::MatrixXd &columns, const double k)
{
  R = columns;
  factor = k;
}

bool LowRankSolver::factorize(SystemMatrix &matrix)
{
  if (!inner->factorize(matrix))
    return false;
  negative = inner->n_negative();
  effect.resize(R.rows(), R.cols());
  Eigen::VectorXd column;
  for (int j = 0; j < R.cols(); ++j)
  {
    inner->solve(R.col(j), column);
    effect.col(j) = column;
  }
  if (R.cols() == 0)
    return true;
  Eigen::MatrixXd S = R.transpose() * effect;
  S = (0.5 * (S + S.transpose())).eval();
  S.diagonal().array() += 1. / factor;
  // The inertia of [B R; Rᵀ -I/k] is that of B and of -S, and that of the sum and of -I/k: the sum has as
  // many negative eigenvalues less than B as S has.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(S);
  const Eigen::VectorXd &values = eigen.eigenvalues();
  if (!(values.cwiseAbs().minCoeff() > 1e-12 * values.cwiseAbs().maxCoeff()))
    return false;
  if (negative)
    *negative -= (values.array() < 0.).count();
  small = eigen.eigenvectors() * values.cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose();
  return true;
}

void LowRankSolver::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
{
  inner->solve(b, x);
  if (R.cols() > 0)
    x -= effect * (small * (R.transpose() * x));
}

void LowRankSolver::condense(const Rows &rows, Eigen::MatrixXd &W)
{
  inner->condense(rows, W);
  if (R.cols() == 0)
    return;
  const Eigen::MatrixXd of_rows = rows.transpose() * effect;
  W.noalias() -= of_rows * small * of_rows.transpose();
}
} // namespace softgrain
