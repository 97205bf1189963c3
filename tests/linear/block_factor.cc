// SPDX-License-Identifier: LGPL-2.1-or-later
// Factors of a matrix of dense blocks, which fill, with one block of no rows and one that is wider than a
// strip, symmetric and indefinite or not symmetric: solutions and the number of negative eigenvalues are
// those of a dense solver. A matrix with a pivot of 0 is refused. Two threads, which share the products of
// one that is large, find the bits of one thread.
#include <softgrain/base/parallel.h>
#include <softgrain/linear/block_factor.h>

#include <Eigen/Dense>

#include <iostream>
#include <random>
#include <set>

using namespace softgrain;

namespace
{
const std::vector<int> sizes{3, 70, 0, 5, 1, 40};
const std::vector<std::pair<int, int>> neighbours{{0, 1}, {3, 0}, {4, 1}, {5, 3}, {2, 5}, {0, 0}};

void check(const bool symmetric)
{
  std::mt19937 random(7);
  std::normal_distribution<double> number;
  BlockFactor factor;
  factor.reinit(sizes, neighbours, symmetric);
  const std::vector<int> &first = factor.first();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(first.back(), first.back());
  const auto fill = [&](const int i, const int j)
  {
    const auto part = [&](const int rows, const int columns) -> Eigen::MatrixXd
    { return Eigen::MatrixXd::NullaryExpr(rows, columns, [&]() { return number(random); }); };
    Eigen::MatrixXd low = part(sizes[i], sizes[j]);
    if (i == j && symmetric)
      low = (low + low.transpose()).eval();
    const Eigen::MatrixXd high = symmetric ? Eigen::MatrixXd(low.transpose()) : part(sizes[j], sizes[i]);
    A.block(first[i], first[j], sizes[i], sizes[j]) = low;
    factor.block(i, j) += low;
    if (i == j)
      return;
    A.block(first[j], first[i], sizes[j], sizes[i]) = high;
    if (!symmetric)
      factor.transposed_block(i, j) += high.transpose();
  };
  for (unsigned int i = 0; i < sizes.size(); ++i)
    fill(i, i);
  for (const auto &[i, j] : neighbours)
    if (i != j && sizes[i] > 0 && sizes[j] > 0)
      fill(std::max(i, j), std::min(i, j));
  const bool done = factor.factorize();
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(first.back());
  Eigen::VectorXd x = b;
  factor.solve(x);
  std::cout << (symmetric ? "symmetric: " : "not symmetric: ") << first.back() << " unknowns, factorised "
            << done << ", as dense " << ((A * x - b).norm() < 1e-8 * A.norm() * x.norm());
  if (symmetric)
    std::cout << ", negative as dense "
              << (factor.n_negative() ==
                  (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvalues().array() < 0.).count());
  std::cout << '\n';
}

/// Blocks of one width in a chain, each of which meets the last two, which are as large as all products that
/// are shared.
Eigen::VectorXd solution_of_large(const unsigned int n_threads, const bool symmetric)
{
  set_n_threads(n_threads);
  std::mt19937 random(11);
  std::normal_distribution<double> number;
  std::vector<int> widths(10, 40);
  widths.insert(widths.end(), {150, 200});
  std::vector<std::pair<int, int>> pairs{{10, 11}};
  for (int i = 0; i < 10; ++i)
    for (const int j : {i + 1, 10, 11})
      if (i % 3 != 0 || j != i + 1)
        pairs.emplace_back(i, j);
  BlockFactor factor;
  factor.reinit(widths, pairs, symmetric);
  const auto part = [&](const int rows, const int columns) -> Eigen::MatrixXd
  { return Eigen::MatrixXd::NullaryExpr(rows, columns, [&]() { return number(random); }); };
  for (int i = 0; i < 12; ++i)
    factor.block(i, i) += 40. * (i % 2 == 0 ? 1. : -1.) * Eigen::MatrixXd::Identity(widths[i], widths[i]);
  for (const auto &[j, i] : std::set<std::pair<int, int>>(pairs.begin(), pairs.end()))
  {
    factor.block(i, j) += part(widths[i], widths[j]);
    if (!symmetric)
      factor.transposed_block(i, j) += part(widths[i], widths[j]);
  }
  factor.factorize();
  Eigen::VectorXd x = Eigen::VectorXd::Ones(factor.first().back());
  factor.solve(x);
  return x;
}
} // namespace

int main()
{
  check(true);
  check(false);
  BlockFactor factor;
  factor.reinit({1, 1}, {{0, 1}});
  factor.block(1, 0).setOnes();
  std::cout << "a pivot of 0: factorised " << factor.factorize() << '\n';
  for (const bool symmetric : {true, false})
  {
    const Eigen::VectorXd one = solution_of_large(1, symmetric), two = solution_of_large(2, symmetric);
    std::cout << one.size() << " unknowns, finite " << one.allFinite() << ", on two threads the bits of one "
              << (one == two) << '\n';
  }
}
