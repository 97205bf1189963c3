// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/cholesky_solver.h>

#include <Eigen/SparseCholesky>

namespace softgrain::mpm
{
struct CholeskySolver::Factor
{
  Eigen::SimplicialLLT<SystemMatrix::Sparse, Eigen::Lower, Eigen::AMDOrdering<int>> llt;
};

CholeskySolver::CholeskySolver() : factor(std::make_unique<Factor>()) {}

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
  // W = Y^T Y with L Y = P H^T: half of the work of full solves, and W is symmetric by construction.
  Eigen::MatrixXd Y = Eigen::MatrixXd::Zero(rows.rows(), rows.cols());
  const auto &order = factor->llt.permutationP().indices();
  parallel_for(rows.cols(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t c = begin; c < end; ++c)
                   for (Rows::InnerIterator entry(rows, c); entry; ++entry)
                     Y(order.size() > 0 ? order[entry.row()] : entry.row(), c) = entry.value();
                 auto columns = Y.middleCols(begin, end - begin);
                 factor->llt.matrixL().solveInPlace(columns);
               });
  W.setZero(rows.cols(), rows.cols());
  W.selfadjointView<Eigen::Lower>().rankUpdate(Y.transpose());
  W.triangularView<Eigen::StrictlyUpper>() = W.transpose();
}
} // namespace softgrain::mpm
