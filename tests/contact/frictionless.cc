// SPDX-License-Identifier: LGPL-2.1-or-later
// Frictionless problems against Lemke's pivoting, and degenerate W: zero rows, duplicate rows, a rigid mode c
// 1 1^T.
#include "reference.h"

#include <softgrain/contact/active_set.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <iostream>

using namespace softgrain::contact;

namespace
{
std::vector<double> random_velocities(const unsigned int n, const unsigned int seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(-0.3, 1.);
  std::vector<double> q(n);
  for (double &value : q)
    value = normal(generator);
  q[0] = -1.; // something approaches
  return q;
}

BlockDelassus one_block(const Eigen::MatrixXd &matrix)
{
  BlockDelassus W(matrix.rows(), 1);
  std::vector<unsigned int> rows(matrix.rows());
  std::iota(rows.begin(), rows.end(), 0);
  W.add_block(rows, matrix);
  return W;
}

/// Solves and compares the velocities (unique also where impulses are not) with Lemke's, relative to the
/// approach speed.
void compare(const std::string &title,
             BlockDelassus &W,
             const std::vector<double> &q,
             const Algorithm algorithm)
{
  Problem problem{1, q, {}};
  SolverSettings settings;
  std::vector<double> P, w;
  settings.tolerance = 1e-12;
  settings.algorithm = algorithm;
  const SolverReport report = solve(W, problem, settings, P, w);

  const Eigen::MatrixXd matrix = W.assemble();
  const Eigen::VectorXd q_vector = Eigen::Map<const Eigen::VectorXd>(q.data(), q.size());
  const Eigen::VectorXd reference = matrix * lemke(matrix, q_vector) + q_vector;
  const double error =
      (reference - Eigen::Map<const Eigen::VectorXd>(w.data(), w.size())).cwiseAbs().maxCoeff() /
      -q_vector.minCoeff();
  std::cout << title << ": converged " << verdict(report.converged) << ", velocities as Lemke's to 1e-10 "
            << verdict(error < 1e-10) << ", conditions to 1e-11 "
            << verdict(worst_violation(problem, matrix, P) < 1e-11 * -q_vector.minCoeff()) << '\n';
  std::cerr << title << ": sweeps " << report.sweeps << " newton " << report.newton_iterations << " residual "
            << report.residual << " error " << error << '\n';
}

Eigen::MatrixXd random_dense(const unsigned int n, const unsigned int rank, const unsigned int seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd H(n, rank);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < rank; ++j)
      H(i, j) = normal(generator);
  return H * H.transpose() / rank;
}
} // namespace

int main()
{
  for (const unsigned int n : {2, 5, 20, 80, 200})
  {
    BlockDelassus W = one_block(random_dense(n, n + 10, n));
    compare("dense " + std::to_string(n) + " sweeps", W, random_velocities(n, 3 * n),
            Algorithm::gauss_seidel);
    compare("dense " + std::to_string(n) + " active set", W, random_velocities(n, 3 * n),
            Algorithm::active_set);
  }
  for (const unsigned int n_bodies : {2, 5, 40})
  {
    BlockDelassus W = random_bodies(n_bodies, 4, 1, 0., n_bodies);
    compare("bodies " + std::to_string(n_bodies) + " sweeps", W, random_velocities(W.n_contacts(), n_bodies),
            Algorithm::gauss_seidel);
    compare("bodies " + std::to_string(n_bodies) + " active set", W,
            random_velocities(W.n_contacts(), n_bodies), Algorithm::active_set);
  }
  unsigned int failed = 0;
  for (unsigned int seed = 0; seed < 300; ++seed)
  {
    // small and rank-deficient, q in the range of H so that it is feasible
    const unsigned int n = 12, rank = 5;
    const Eigen::MatrixXd matrix = random_dense(n, rank, seed);
    const std::vector<double> v = random_velocities(n, seed + 1000);
    const Eigen::VectorXd q = matrix * Eigen::Map<const Eigen::VectorXd>(v.data(), n);
    BlockDelassus W = one_block(matrix);
    const Problem problem{1, std::vector<double>(q.data(), q.data() + n), {}};
    SolverSettings settings;
    std::vector<double> P, w;
    settings.algorithm = Algorithm::active_set;
    settings.tolerance = 1e-11;
    const auto report = solve(W, problem, settings, P, w);
    failed += !report.converged || worst_violation(problem, matrix, P) > 1e-10 * q.cwiseAbs().maxCoeff();
  }
  std::cout << "rank-deficient, 300 problems, failed: " << failed << '\n';

  // Duplicate rows: two markers at one place. The velocities are unique, the impulses share.
  {
    const Eigen::MatrixXd half = random_dense(30, 40, 77);
    Eigen::MatrixXd twice(60, 60);
    twice << half, half, half, half;
    std::vector<double> q = random_velocities(30, 78);
    q.insert(q.end(), q.begin(), q.end());
    BlockDelassus W = one_block(twice);
    compare("duplicate rows, sweeps", W, q, Algorithm::gauss_seidel);
    compare("duplicate rows, active set", W, q, Algorithm::active_set);
  }
  // Zero rows: both sides prescribed. They keep impulse 0, the others do not notice, the report names the
  // approach.
  {
    Eigen::MatrixXd matrix = random_dense(10, 12, 5);
    matrix.row(3) = Eigen::VectorXd::Zero(10);
    matrix.col(3) = Eigen::VectorXd::Zero(10);
    BlockDelassus W = one_block(matrix);
    std::vector<double> q = random_velocities(10, 6), P, w;
    q[3] = -7.;
    const SolverReport report = solve(W, {1, q, {}}, {}, P, w);
    std::cout << "zero row: converged " << verdict(report.converged) << ", impulse " << P[3]
              << ", prescribed contacts " << report.prescribed_contacts << ", approach left "
              << report.prescribed_approach << '\n';
  }
  // A body squeezed between contacts: W = W_elastic + c g g^T, g = +-1 by side, c / W_elastic = 1e6. With
  // W_elastic = I and all contacts closed, P = -q - c g s with s = g.P = -g.q / (1 + n c). Sweeps balance the
  // sides once per thousands.
  {
    const unsigned int n = 50;
    const double c = 1e6;
    Eigen::VectorXd g(n), q(n);
    std::vector<double> P, w;
    for (unsigned int i = 0; i < n; ++i)
    {
      g[i] = i % 2 == 0 ? 1. : -1.;
      q[i] = -1. - 0.5 * std::sin(1. + i * i);
    }
    BlockDelassus W = one_block(Eigen::MatrixXd::Identity(n, n) + c * g * g.transpose());
    const Eigen::VectorXd exact = -q + c * g * g.dot(q) / (1. + n * c);
    SolverSettings settings;
    settings.max_sweeps = 2000;
    for (const Algorithm algorithm : {Algorithm::gauss_seidel, Algorithm::automatic})
    {
      P.clear();
      settings.algorithm = algorithm;
      const SolverReport report =
          solve(W, {1, std::vector<double>(q.data(), q.data() + n), {}}, settings, P, w);
      const double error = (Eigen::Map<const Eigen::VectorXd>(P.data(), n) - exact).cwiseAbs().maxCoeff();
      std::cout << "rigid mode, " << (algorithm == Algorithm::automatic ? "automatic" : "2000 sweeps")
                << ": converged " << verdict(report.converged) << ", impulses exact to 1e-7 "
                << verdict(error < 1e-7) << '\n';
      std::cerr << "rigid mode: error of P " << error << ", sweeps " << report.sweeps << " newton "
                << report.newton_iterations << " residual " << report.residual << " min " << exact.minCoeff()
                << '\n';
    }
  }
  // Twenty bodies whose rigid modes are c times as soft as their elastic ones.
  for (const double c : {1e2, 1e4, 1e6})
  {
    BlockDelassus W = random_bodies(20, 5, 1, c, 9);
    const std::vector<double> q = random_velocities(W.n_contacts(), 10);
    std::vector<double> P, w;
    const SolverReport report = solve(W, {1, q, {}}, {}, P, w);
    std::cout << "rigid modes " << c << ": converged " << verdict(report.converged)
              << ", Newton iterations below 20 " << verdict(report.newton_iterations < 20)
              << ", sweeps at most 100 " << verdict(report.sweeps <= 100) << ", conditions to 1e-6 "
              << verdict(worst_violation({1, q, {}}, W.assemble(), P) <
                         1e-6 * -*std::min_element(q.begin(), q.end()))
              << '\n';
    SolverSettings exacting;
    exacting.tolerance = 1e-15;
    const SolverReport at_limit = solve(W, {1, q, {}}, exacting, P, w);
    std::cout << "  to 1e-15: ends at rounding "
              << verdict(at_limit.limited_by_rounding || at_limit.converged) << ", before 1000 sweeps "
              << verdict(at_limit.sweeps < 1000) << '\n';
    std::cerr << c << ' ' << report.newton_iterations << ' ' << report.residual << ' ' << at_limit.sweeps
              << ' ' << at_limit.residual << '\n';
  }
}
