// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/even_exponent.h>
#include <softgrain/contact/active_system.h>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::contact
{
ActiveSystem::ActiveSystem(const unsigned int size, const std::size_t n_entries, const bool symmetric)
    // below some hundred unknowns, or with many entries, the dense factorisation is faster than the ordering
    // of a sparse one
    : dense(size <= 200 || n_entries > 0.3 * size * size), symmetric(symmetric), size(size)
{
  if (dense)
    matrix = Eigen::MatrixXd::Zero(size, size);
  else if (symmetric)
  {
    lower.resize(size, size);
    lower.reserve(n_entries / 2 + size);
  }
  else
    entries.reserve(n_entries);
}

bool ActiveSystem::solve_symmetric(const Eigen::VectorXd &right_hand_side, Eigen::VectorXd &solution)
{
  double scale = 1.;
  if (dense)
  {
    scale = size > 0 ? for_even_exponent(matrix(0, 0)) : 1.;
    matrix *= scale;
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(matrix); // in place
    if (factor.info() != Eigen::Success)
      return false;
    solution = factor.solve(right_hand_side);
  }
  else
  {
    for (; begun < size; ++begun)
      lower.startVec(begun);
    lower.finalize();
    scale = for_even_exponent(lower.coeff(0, 0));
    lower *= scale;
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor(lower);
    if (factor.info() != Eigen::Success)
      return false;
    solution = factor.solve(right_hand_side);
  }
  solution *= scale;
  return solution.allFinite();
}

bool ActiveSystem::solve_general(const Eigen::VectorXd &right_hand_side, Eigen::VectorXd &solution)
{
  if (!factorise_general())
    return false;
  solution = solve_with_factors(right_hand_side);
  return solution.allFinite();
}

bool ActiveSystem::factorise_general()
{
  if (dense)
  {
    dense_factors = std::make_unique<DenseFactors>(matrix);
    // PartialPivLU does not look for zero pivots itself
    return dense_factors->matrixLU().diagonal().cwiseAbs().minCoeff() > 0.;
  }
  Eigen::SparseMatrix<double> A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  A.makeCompressed();
  sparse_factors = std::make_unique<SparseFactors>();
  sparse_factors->umfpackControl()[UMFPACK_IRSTEP] = 0; // Newton refines
  sparse_factors->compute(A);
  return sparse_factors->info() == Eigen::Success;
}

Eigen::VectorXd ActiveSystem::solve_with_factors(const Eigen::VectorXd &right_hand_side) const
{
  return dense ? Eigen::VectorXd(dense_factors->solve(right_hand_side))
               : Eigen::VectorXd(sparse_factors->solve(right_hand_side));
}

std::vector<double>
velocities(const ActiveSystem::Matrix &W, const Problem &problem, const std::vector<double> &impulses)
{
  using Values = Eigen::Map<const Eigen::VectorXd>;
  const Eigen::VectorXd w = W * Values(impulses.data(), impulses.size()) +
                            Values(problem.free_velocity.data(), problem.free_velocity.size());
  return std::vector<double>(w.data(), w.data() + w.size());
}

double rounding_floor(const ActiveSystem::Matrix &W, const std::vector<double> &impulses, const double speed)
{
  double largest = 0.;
  for (int i = 0; i < W.rows(); ++i)
  {
    double sum = 0.;
    for (ActiveSystem::Matrix::InnerIterator entry(W, i); entry; ++entry)
      sum += std::abs(entry.value() * impulses[entry.col()]);
    largest = std::max(largest, sum);
  }
  return std::numeric_limits<double>::epsilon() * largest / speed;
}
} // namespace softgrain::contact
