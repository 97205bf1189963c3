// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/cholesky_solver.h>

#include <Eigen/CholmodSupport>

namespace softgrain::mpm
{
struct CholeskySolver::Factor
{
  Eigen::CholmodSupernodalLLT<SystemMatrix::Sparse, Eigen::Lower> llt;
};

CholeskySolver::CholeskySolver()
  : factor(std::make_unique<Factor>())
{
  factor->llt.cholmod().print = 0; // that a matrix is indefinite is the caller's to handle, not news for the terminal
}

CholeskySolver::~CholeskySolver() = default;

bool CholeskySolver::factorize(SystemMatrix &matrix)
{
  if (matrix.pattern_is_new())
  {
    factor->llt.analyzePattern(matrix.lower());
    matrix.clear_pattern_flag();
  }
  factor->llt.factorize(matrix.lower());
  return factor->llt.info() == Eigen::Success;
}

void CholeskySolver::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
{
  x = factor->llt.solve(b);
}

void CholeskySolver::condense(const Rows &rows, Eigen::MatrixXd &W)
{
  const Eigen::MatrixXd dense = Eigen::MatrixXd(rows);
  const Eigen::MatrixXd X     = factor->llt.solve(dense);
  W.noalias()                 = rows.transpose() * X;
  W                           = 0.5 * (W + W.transpose()).eval();
}
} // namespace softgrain::mpm
