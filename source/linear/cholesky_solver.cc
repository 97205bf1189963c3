// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/even_exponent.h>
#include <softgrain/base/parallel.h>
#include <softgrain/linear/cholesky_solver.h>

#include <Eigen/SparseCholesky>

namespace softgrain
{
struct CholeskySolver::Factor
{
  Eigen::SimplicialLDLT<SystemMatrix::Sparse, Eigen::Lower, Eigen::AMDOrdering<int>> ldlt;
};

CholeskySolver::CholeskySolver() : factor(std::make_unique<Factor>()) {}

CholeskySolver::~CholeskySolver() = default;

bool CholeskySolver::factorize(SystemMatrix &matrix)
{
  if (!analyzed || matrix.pattern_is_new())
  {
    factor->ldlt.analyzePattern(matrix.lower());
    matrix.clear_pattern_flag();
    analyzed = true;
  }
  factor->ldlt.factorize(matrix.lower());
  return factor->ldlt.info() == Eigen::Success;
}

std::optional<unsigned int> CholeskySolver::n_negative() const
{
  return (factor->ldlt.vectorD().array() < 0.).count();
}

void CholeskySolver::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
{
  x = factor->ldlt.solve(b);
}

void CholeskySolver::condense(const Rows &rows, Eigen::MatrixXd &W)
{
  // W = Y^T D^-1 Y with L Y = P H^T: half of the work of full solves, and W is symmetric by construction.
  const double scale = for_even_exponent(factor->ldlt.vectorD()[0]); // roots of D are taken
  const Eigen::VectorXd D = scale * factor->ldlt.vectorD();
  Eigen::MatrixXd Y = Eigen::MatrixXd::Zero(rows.rows(), rows.cols());
  const auto &order = factor->ldlt.permutationP().indices();
  parallel_for(rows.cols(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t c = begin; c < end; ++c)
                   for (Rows::InnerIterator entry(rows, c); entry; ++entry)
                     Y(order.size() > 0 ? order[entry.row()] : entry.row(), c) = entry.value();
                 auto columns = Y.middleCols(begin, end - begin);
                 factor->ldlt.matrixL().solveInPlace(columns);
                 columns.array().colwise() /= D.array().abs().sqrt();
               });
  W.setZero(rows.cols(), rows.cols());
  W.selfadjointView<Eigen::Lower>().rankUpdate(Y.transpose());
  for (int i = 0; i < D.size(); ++i)
    if (D[i] < 0.)
      W.selfadjointView<Eigen::Lower>().rankUpdate(Eigen::VectorXd(Y.row(i).transpose()), -2.);
  W *= scale;
  W.triangularView<Eigen::StrictlyUpper>() = W.transpose();
}
} // namespace softgrain
