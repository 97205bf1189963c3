// SPDX-License-Identifier: LGPL-2.1-or-later
// The operators are the same W: against a matrix multiplied out, against each other, three bodies at one
// node, and a column of masses whose impulses are known. What is wrong in the input is named.
#include "reference.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/contact/active_set.h>
#include <softgrain/contact/diagonal_delassus.h>
#include <softgrain/contact/mass_delassus.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <limits>

using namespace softgrain;
using namespace softgrain::contact;

namespace
{
/// Largest difference of begin(), velocity(), apply() and diagonal_block() from the matrix @p W, relative to
/// its largest.
template <unsigned int n, class Operator>
double difference(Operator &op, const Eigen::MatrixXd &W)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Eigen::VectorXd P(W.rows());
  double worst = (Eigen::MatrixXd(op.assemble()) - W).cwiseAbs().maxCoeff();
  for (double &value : P)
    value = uniform(generator);
  op.begin(std::vector<double>(P.data(), P.data() + P.size()));
  for (unsigned int round = 0; round < 2; ++round)
    for (unsigned int i = 0; i < op.n_contacts(); ++i)
    {
      double w[n], change[n], block[n * n];
      op.template velocity<n>(i, w);
      op.diagonal_block(i, block);
      for (unsigned int c = 0; c < n; ++c)
      {
        worst = std::max(worst, std::abs(w[c] - W.row(i * n + c).dot(P)));
        for (unsigned int d = 0; d < n; ++d)
          worst = std::max(worst, std::abs(block[c * n + d] - W(i * n + c, i * n + d)));
        change[c] = uniform(generator);
      }
      for (unsigned int c = 0; c < n; ++c)
        P[i * n + c] += change[c];
      op.template apply<n>(i, change);
    }
  return worst / W.cwiseAbs().maxCoeff();
}

template <unsigned int n>
void random_rows()
{
  std::mt19937 generator(n);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  const unsigned int n_contacts = 25, n_dofs = 30;
  std::vector<unsigned int> start(1, 0), dofs;
  std::vector<double> weights, inverse_mass;
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n_contacts * n, n_dofs), W;
  Eigen::VectorXd inverse(n_dofs);
  for (unsigned int d = 0; d < n_dofs; ++d)
    inverse_mass.push_back(inverse[d] = d % 7 == 0 ? 0. : 0.1 + std::abs(uniform(generator)));
  for (unsigned int row = 0; row < n_contacts * n; ++row)
  {
    for (unsigned int e = 0; e < 6; ++e)
    {
      dofs.push_back(generator() % n_dofs);
      weights.push_back(uniform(generator));
      H(row, dofs.back()) += weights.back();
    }
    start.push_back(dofs.size());
  }
  W = H * inverse.asDiagonal() * H.transpose();
  MassDelassus mass(n, start, dofs, weights, inverse_mass);
  BlockDelassus blocks(n_contacts, n);
  std::vector<unsigned int> rows(n_contacts * n);
  std::iota(rows.begin(), rows.end(), 0);
  std::reverse(rows.begin(), rows.end()); // rows of a block may come in any order
  blocks.add_block(rows, Eigen::MatrixXd(0.25 * W.rowwise().reverse().colwise().reverse()));
  std::iota(rows.begin(), rows.end(), 0);
  blocks.add_room(rows); // the matrix may come later
  blocks.set_block(1, Eigen::MatrixXd(0.75 * W));
  std::cout << n << " components: mass operator is W " << verdict(difference<n>(mass, W) < 1e-13)
            << ", two blocks are W " << verdict(difference<n>(blocks, W) < 1e-13);
  std::vector<double> values;
  Eigen::MatrixXd diagonal = Eigen::MatrixXd::Zero(W.rows(), W.rows());
  for (unsigned int i = 0; i < n_contacts; ++i)
  {
    diagonal.block<n, n>(i * n, i * n) = W.block<n, n>(i * n, i * n);
    for (unsigned int c = 0; c < n; ++c)
      for (unsigned int d = 0; d < n; ++d)
        values.push_back(W(i * n + c, i * n + d));
  }
  DiagonalDelassus independent(n, values);
  std::cout << ", diagonal is its blocks " << verdict(difference<n>(independent, diagonal) < 1e-13) << '\n';

  Problem problem{n, {}, std::vector<double>(n_contacts, 0.3)};
  for (unsigned int row = 0; row < n_contacts * n; ++row)
    problem.free_velocity.push_back(H.row(row).sum()); // v = 1 everywhere
  std::vector<double> P, P_blocks, w, w_blocks;
  SolverSettings settings;
  settings.tolerance = 1e-11;
  const SolverReport report = solve(mass, problem, settings, P, w);
  const SolverReport report2 = solve(blocks, problem, settings, P_blocks, w_blocks);
  double error = 0.;
  for (unsigned int row = 0; row < w.size(); ++row)
    error = std::max(error, std::abs(w[row] - w_blocks[row]));
  std::cout << "  solved through both: converged " << verdict(report.converged && report2.converged)
            << ", same velocities to 1e-8 " << verdict(error < 1e-8) << '\n';
  const SolverReport again = solve(mass, problem, settings, P, w);
  std::cout << "  warm start from the solution: sweeps at most 5 " << verdict(again.sweeps <= 5) << '\n';
  // independent contacts are solved by one plain sweep
  settings.algorithm = Algorithm::gauss_seidel;
  const SolverReport once = gauss_seidel(independent, problem, settings, P = {}, w);
  std::cout << "  diagonal operator: sweeps at most 2 " << verdict(once.sweeps <= 2 && once.converged)
            << '\n';
  settings.algorithm = Algorithm::accelerated;
  const SolverReport ahead = gauss_seidel(independent, problem, settings, P = {}, w);
  std::cout << "  diagonal operator with momentum: sweeps at most 3 "
            << verdict(ahead.sweeps <= 3 && ahead.converged) << '\n';
}

void expect_error(const std::string &title, const std::function<void()> &work)
{
  std::cout << title << ": ";
  try
  {
    work();
    std::cout << "nothing thrown\n";
  }
  catch (const InputError &error)
  {
    std::cout << "InputError, " << error.what() << '\n';
  }
  catch (const ComputationError &error)
  {
    std::cout << "ComputationError, " << error.what() << '\n';
  }
}
} // namespace

int main()
{
  std::cout.precision(10);
  random_rows<1>();
  random_rows<2>();
  random_rows<3>();

  // Three bodies of masses 1, 2, 4 meet at one node with normal x: rows v2 - v1 and v3 - v2, speeds 7, 0, -2.
  // They stick together (plastic): v = (7 - 8) / 7, so the impulses are P_1 = 1 (7 - v) and P_2 = 4 (v + 2).
  {
    MassDelassus W(1, {0, 2, 4}, {1, 0, 2, 1}, {1., -1., 1., -1.}, {1., 0.5, 0.25});
    std::vector<double> P, w;
    SolverSettings settings;
    settings.tolerance = 1e-13;
    solve(W, {1, {-7., -2.}, {}}, settings, P, w);
    std::cout << "three bodies at a node: " << P[0] << ' ' << P[1] << ", expected " << 7. + 1. / 7. << ' '
              << 4. * (2. - 1. / 7.) << "; common velocity " << 7. + W.velocities()[0] << ' '
              << W.velocities()[1] << ' ' << -2. + W.velocities()[2] << '\n';
  }
  // A column of 10 masses m_i = i on the floor: impulse of contact i (from below) is g dt times the weight
  // above.
  {
    const unsigned int n = 10;
    const double speed = 9.81e-3;
    std::vector<unsigned int> start{0, 1}, dofs{0};
    std::vector<double> weights{1.}, inverse{1.}, q{-speed}, P, w;
    for (unsigned int i = 1; i < n; ++i)
    {
      dofs.insert(dofs.end(), {i, i - 1});
      weights.insert(weights.end(), {1., -1.});
      start.push_back(dofs.size());
      inverse.push_back(1. / (i + 1.));
      q.push_back(0.);
    }
    for (const Algorithm algorithm : {Algorithm::gauss_seidel, Algorithm::active_set})
    {
      MassDelassus W(1, start, dofs, weights, inverse);
      SolverSettings settings;
      settings.tolerance = 1e-12;
      settings.algorithm = algorithm;
      P = {};
      const SolverReport report = solve(W, {1, q, {}}, settings, P, w);
      double error = 0., above = 0.;
      for (unsigned int i = n; i-- > 0;)
      {
        above += (i + 1.) * speed;
        error = std::max(error, std::abs(P[i] - above) / above);
      }
      std::cout << "column of masses, " << (algorithm == Algorithm::active_set ? "active set" : "sweeps")
                << ": converged " << verdict(report.converged) << ", impulses to 1e-9 "
                << verdict(error < 1e-9) << '\n';
    }
  }
  // Independent of units: mass in tonnes and time in milliseconds change neither sweeps nor residual.
  {
    BlockDelassus W = random_bodies(6, 3, 2, 0., 3), scaled(W.n_contacts(), 2);
    Problem problem{2, {}, std::vector<double>(W.n_contacts(), 0.4)};
    std::vector<double> P, P_scaled, w;
    for (unsigned int i = 0; i < 2 * W.n_contacts(); ++i)
      problem.free_velocity.push_back(-std::sin(1. + i));
    Problem faster = problem;
    for (double &value : faster.free_velocity)
      value *= 1024.;
    for (unsigned int b = 0; b < W.n_blocks(); ++b)
      scaled.add_block(W.block_components(b), W.block(b) * 1048576.);
    const SolverReport report = gauss_seidel(W, problem, {}, P, w),
                       other = gauss_seidel(scaled, faster, {}, P_scaled, w);
    std::cout << "other units: same sweeps " << verdict(report.sweeps == other.sweeps) << ", same residual "
              << verdict(report.residual == other.residual) << ", impulses scale exactly "
              << verdict(std::equal(P.begin(), P.end(), P_scaled.begin(),
                                    [](const double a, const double b) { return a == 1024. * b; }))
              << '\n';
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BlockDelassus W(2, 1);
  Eigen::MatrixXd block = Eigen::MatrixXd::Identity(2, 2);
  W.add_block({0, 1}, block);
  std::vector<double> P, w;
  expect_error("velocity not finite", [&] { solve(W, {1, {-1., nan}, {}}, {}, P, w); });
  expect_error("velocity infinite", [&] { solve(W, {1, {-1., -1. / 0.}, {}}, {}, P, w); });
  expect_error("friction not finite", [&] { Problem{2, {-1., 0.}, {nan}}.check(); });
  expect_error("friction negative", [&] { Problem{2, {-1., 0.}, {-1.}}.check(); });
  expect_error("warm start not finite", [&] { solve(W, {1, {-1., -1.}, {}}, {}, P = {0., nan}, w); });
  expect_error("warm start too short", [&] { solve(W, {1, {-1., -1.}, {}}, {}, P = {0.}, w); });
  expect_error("block not finite", [&] { W.add_block({0, 1}, block * nan); });
  expect_error("block not symmetric",
               [&] {
                 W.add_block({0, 1}, (Eigen::Matrix2d() << 1., 0.5, -0.5, 1.).finished());
               });
  expect_error("block outside", [&] { W.add_block({0, 2}, block); });
  expect_error("component twice", [&] { W.add_block({1, 1}, block); });
  expect_error("mass negative", [&] { MassDelassus(1, {0, 1}, {0}, {1.}, {-1.}); });
  expect_error("weight not finite", [&] { MassDelassus(1, {0, 1}, {0}, {nan}, {1.}); });
  expect_error("other size", [&] { solve(W, {1, {-1., -1., -1.}, {}}, {}, P = {}, w); });
  expect_error("tolerance 0",
               [&]
               {
                 SolverSettings s;
                 s.tolerance = 0.;
                 solve(W, {1, {-1., -1.}, {}}, s, P = {}, w);
               });
}
