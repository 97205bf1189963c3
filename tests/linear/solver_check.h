// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_linear_solver_check_h
#define softgrain_tests_linear_solver_check_h

#include <softgrain/linear/linear_solver_kind.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace softgrain
{
/// Stiffness of a square bilinear element in plane strain, E = 1, nu = 0.3; nodes by rows.
inline Eigen::Matrix<double, 8, 8> element()
{
  Eigen::Matrix3d C;
  C << 0.7, 0.3, 0., 0.3, 0.7, 0., 0., 0., 0.2;
  C /= 1.3 * 0.4;
  Eigen::Matrix<double, 8, 8> K = Eigen::Matrix<double, 8, 8>::Zero();
  const double gauss = 0.5 / std::sqrt(3.);
  for (const double x : {0.5 - gauss, 0.5 + gauss})
    for (const double y : {0.5 - gauss, 0.5 + gauss})
    {
      const double slope_x[] = {y - 1., 1. - y, -y, y}, slope_y[] = {x - 1., -x, 1. - x, x};
      Eigen::Matrix<double, 3, 8> B = Eigen::Matrix<double, 3, 8>::Zero();
      for (unsigned int k = 0; k < 4; ++k)
      {
        B(0, 2 * k) = B(2, 2 * k + 1) = slope_x[k];
        B(1, 2 * k + 1) = B(2, 2 * k) = slope_y[k];
      }
      K += 0.25 * B.transpose() * C * B;
    }
  return K;
}

/// The square with @p n elements along an edge. @param stiffness factor of its matrix
inline SystemMatrix square(const unsigned int n, const double stiffness = 1.)
{
  std::vector<std::vector<unsigned int>> cells;
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
    {
      const unsigned int first = j * (n + 1) + i;
      cells.push_back({first, first + 1, first + n + 1, first + n + 2});
    }
  SystemMatrix matrix;
  matrix.reinit(2, (n + 1) * (n + 1), cells);
  std::vector<double> places;
  for (unsigned int j = 0; j <= n; ++j)
    for (unsigned int i = 0; i <= n; ++i)
    {
      places.push_back(i);
      places.push_back(j);
    }
  matrix.set_places(places);
  const auto K = element();
  for (unsigned int c = 0; c < cells.size(); ++c)
    matrix.add_cell<2>(
        c,
        [&](const unsigned int a, const unsigned int e, const unsigned int b, const unsigned int d)
        { return K(2 * a + e, 2 * b + d); },
        stiffness);
  Eigen::VectorXd springs = Eigen::VectorXd::Zero((n + 1) * (n + 1));
  springs.head(n + 1).setConstant(100.);
  matrix.add_mass<2>(springs, stiffness);
  return matrix;
}

inline LinearSolver::Rows some_rows(const unsigned int n_dofs)
{
  LinearSolver::Rows rows(n_dofs, 3);
  rows.insert(n_dofs / 3, 0) = 1.;
  rows.insert(n_dofs / 2, 1) = 0.5;
  rows.insert(n_dofs / 2 + 1, 1) = -0.5;
  rows.insert(n_dofs - 1, 2) = 1.;
  rows.makeCompressed();
  return rows;
}

inline const char *yes(const bool value)
{
  return value ? "yes" : "no";
}

/// Says whether the solver of that name gives what a dense factorisation gives.
inline void check(const std::string &name)
{
  LinearSolverSettings settings;
  settings.type = name;
  SystemMatrix matrix = square(12);
  const auto solver = create_linear_solver(settings, matrix, 2, true);
  const Eigen::MatrixXd dense = Eigen::MatrixXd(matrix.lower()).selfadjointView<Eigen::Lower>();
  const Eigen::LLT<Eigen::MatrixXd> exact(dense);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(dense.rows(), -1., 2.), x = exact.solve(b);
  const LinearSolver::Rows rows = some_rows(dense.rows());
  const Eigen::MatrixXd W = rows.transpose() * exact.solve(Eigen::MatrixXd(rows));
  std::cout << name << ": factorised " << yes(solver->factorize(matrix));
  Eigen::VectorXd found;
  Eigen::MatrixXd found_W;
  solver->solve(b, found);
  solver->condense(rows, found_W);
  std::cout << ", solution " << yes((found - x).norm() < 1e-7 * x.norm()) << ", compliance "
            << yes((found_W - W).norm() < 1e-7 * W.norm());
  // Again with other values and the same pattern.
  matrix.add_mass<2>(Eigen::VectorXd::Ones(dense.rows() / 2), 1.);
  const Eigen::MatrixXd heavier = dense + Eigen::MatrixXd::Identity(dense.rows(), dense.rows());
  const Eigen::VectorXd y = heavier.llt().solve(b);
  const bool again = solver->factorize(matrix);
  solver->solve(b, found);
  std::cout << ", with new values " << yes(again && (found - y).norm() < 1e-7 * y.norm());
  matrix.add_mass<2>(Eigen::VectorXd::Ones(dense.rows() / 2), -1000.);
  const bool taken = solver->factorize(matrix);
  std::cout << ", negative definite refused or counted "
            << yes(!taken || solver->n_negative() == static_cast<unsigned int>(dense.rows())) << '\n';
}
} // namespace softgrain

#endif
