// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_active_system_h
#define softgrain_contact_active_system_h

#include <softgrain/contact/problem.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>

#include <memory>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief The linear system of the rows that are active in a Newton step, kept dense or sparse, whichever is
 * cheaper.
 *
 * Built entry by entry; entries at the same place add up. Unknowns are numbered 0 .. size - 1.
 */
class ActiveSystem
{
public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// Starts a system of @p size unknowns that will get about @p n_entries entries. One that is @p symmetric
  /// is for solve_symmetric(), others are for the rest: its entries come row by row, in every row from left
  /// to right, each place once.
  ActiveSystem(unsigned int size, std::size_t n_entries, bool symmetric);

  /// Adds @p value to row @p i, column @p j.
  void add(const unsigned int i, const unsigned int j, const double value)
  {
    if (dense)
      matrix(i, j) += value;
    else if (symmetric)
      add_to_lower(i, j, value);
    else
      entries.emplace_back(i, j, value);
  }

  /// Solves by Cholesky (symmetric positive definite). False when the matrix is not, or the result is not
  /// finite.
  bool solve_symmetric(const Eigen::VectorXd &right_hand_side, Eigen::VectorXd &solution);

  /// Solves by LU with pivoting. False when the matrix is singular, or the result is not finite.
  bool solve_general(const Eigen::VectorXd &right_hand_side, Eigen::VectorXd &solution);

  /// LU factors with pivoting, for any number of solve_with_factors(). False when the matrix is singular.
  bool factorise_general();
  Eigen::VectorXd solve_with_factors(const Eigen::VectorXd &right_hand_side) const;

private:
  using DenseFactors = Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>>;
  /// UMFPACK's ordering keeps the symmetric pattern of W, which leaves a third of the entries of SparseLU.
  using SparseFactors = Eigen::UmfPackLU<Eigen::SparseMatrix<double>>;

  /// Rows of a symmetric matrix are its columns; of those the lower half is enough.
  void add_to_lower(const unsigned int column, const unsigned int row, const double value)
  {
    for (; begun <= column; ++begun)
      lower.startVec(begun);
    if (row >= column)
      lower.insertBack(row, column) = value;
  }

  bool dense, symmetric;
  unsigned int size;
  unsigned int begun = 0; ///< columns of lower
  Eigen::SparseMatrix<double> lower;
  Eigen::MatrixXd matrix;
  std::vector<Eigen::Triplet<double>> entries;
  std::unique_ptr<DenseFactors> dense_factors;
  std::unique_ptr<SparseFactors> sparse_factors;
};

/// w = W P + q of all contacts (m/s).
std::vector<double>
velocities(const ActiveSystem::Matrix &W, const Problem &problem, const std::vector<double> &impulses);

/**
 * @brief Below this, natural_residual() of @p impulses is rounding: machine epsilon times the largest Σ_j
 * |W_ij P_j| over the approach speed @p speed. An upper estimate; large where W has a rigid mode far above
 * its elastic part.
 */
double rounding_floor(const ActiveSystem::Matrix &W, const std::vector<double> &impulses, double speed);
} // namespace softgrain::contact

#endif
