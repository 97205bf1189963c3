// SPDX-License-Identifier: LGPL-2.1-or-later
// B + k R Rᵀ with three columns, where a band has the factors of B: solutions and condensed rows are those of
// a dense solver, and so are the numbers of negative eigenvalues, for a positive definite B and for some that
// are not, and with a small and with a large k. Without columns it is the solver of B.
#include <softgrain/linear/banded_solver.h>
#include <softgrain/linear/low_rank_solver.h>

#include <Eigen/Dense>

#include <iostream>
#include <memory>
#include <random>

using namespace softgrain;

namespace
{
constexpr unsigned int n_nodes = 20, dim = 3, n = dim * n_nodes;

void check(const double shift, const double k, const unsigned int n_columns)
{
  std::mt19937 random(5);
  std::normal_distribution<double> number;
  const auto next = [&]() { return number(random); };
  std::vector<std::vector<unsigned int>> cells;
  for (unsigned int c = 0; c + 2 < n_nodes; ++c)
    cells.push_back({c, c + 1, c + 2});
  SystemMatrix matrix;
  matrix.reinit(dim, n_nodes, cells);
  matrix.set_zero();
  for (unsigned int c = 0; c < cells.size(); ++c)
  {
    const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(3 * dim, 3 * dim, next), local = A * A.transpose();
    matrix.add_cell<dim>(
        c,
        [&](const unsigned int a, const unsigned int e, const unsigned int b, const unsigned int d)
        { return local(dim * a + e, dim * b + d); },
        1.);
  }
  matrix.add_mass<dim>(Eigen::VectorXd::Ones(n_nodes), shift);
  const Eigen::MatrixXd R = Eigen::MatrixXd::NullaryExpr(n, n_columns, next);
  Eigen::MatrixXd dense = matrix.lower().selfadjointView<Eigen::Lower>() * Eigen::MatrixXd::Identity(n, n);
  dense += k * R * R.transpose();
  LowRankSolver solver(std::make_unique<BandedSolver>());
  solver.set_update(R, k);
  const bool good = solver.factorize(matrix);
  const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(n, next);
  Eigen::VectorXd x;
  solver.solve(b, x);
  LinearSolver::Rows rows(n, 4);
  for (unsigned int j = 0; j < 4; ++j)
    for (unsigned int i = 0; i < 5; ++i)
      rows.insert(11 * j + 2 * i, j) = next();
  rows.makeCompressed();
  Eigen::MatrixXd W;
  solver.condense(rows, W);
  const Eigen::MatrixXd exact = rows.transpose() * dense.fullPivLu().solve(Eigen::MatrixXd(rows));
  const Eigen::VectorXd values = dense.selfadjointView<Eigen::Lower>().eigenvalues();
  std::cout << "shift " << shift << ", k " << k << ", " << n_columns << " columns: " << good << ", solution "
            << ((dense * x - b).norm() < 1e-12 * dense.norm() * x.norm()) << ", rows "
            << ((W - exact).norm() < 1e-8 * exact.norm()) << ", negative " << *solver.n_negative() << " of "
            << (values.array() < 0.).count() << '\n';
}
} // namespace

int main()
{
  check(1., 10., 3);
  check(-2., 10., 3);
  check(-2., 1e6, 3);
  check(-6., 1e-3, 3);
  check(-6., 1e3, 3);
  check(-6., 1., 0);
}
