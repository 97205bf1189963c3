// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_block_factor_h
#define softgrain_linear_block_factor_h

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace softgrain
{
/**
 * @brief Factors of a matrix that is sparse in dense blocks with a symmetric pattern, without pivoting: L D
 * Lᵀ of one that is symmetric, else L U.
 *
 * The matrix may be indefinite: the signs of D tell its inertia. Blocks are eliminated in the order of their
 * numbers. A sparse factor by single entries spends most of its time on indices where blocks are as large as
 * the contact of two grains in space; this one spends it in products of dense matrices.
 */
class BlockFactor
{
public:
  /// Lays out a matrix of zeros, with all blocks that its factors fill.
  /// @param sizes of the diagonal blocks; 0 is allowed
  /// @param neighbours pairs of blocks, in either order, that are not zero beside the diagonal ones
  void reinit(const std::vector<int> &sizes,
              const std::vector<std::pair<int, int>> &neighbours,
              bool symmetric = true);

  /// A block of the lower triangle, which reinit() has laid out: row block @p i, column block @p j <= i. Of a
  /// diagonal one of a symmetric matrix only the lower triangle counts.
  Eigen::Block<Eigen::MatrixXd> block(int i, int j);
  /// The block of a matrix that is not symmetric in row block @p j and column block @p i > j, transposed.
  Eigen::Block<Eigen::MatrixXd> transposed_block(int i, int j);

  /// Where the unknowns of a block begin; the last one is their number.
  const std::vector<int> &first() const { return begin; }

  /// Factorises in place. @return false when a pivot is 0 or no number
  bool factorize();
  /// Negative entries of D, of a symmetric matrix.
  unsigned int n_negative() const;
  /// Solves in place.
  void solve(Eigen::VectorXd &x) const;

private:
  /// A column of blocks, its diagonal block and those below it, one upon the other; and a row of blocks to
  /// the right of the diagonal one, transposed, if the matrix is not symmetric.
  struct Panel
  {
    std::vector<int> rows;   ///< row blocks, ascending, the diagonal one first
    std::vector<int> offset; ///< where they begin, and where the last one ends
    Eigen::MatrixXd entries;
    Eigen::MatrixXd right; ///< begins at offset[1]
  };
  bool factorize_panel(Panel &panel, int begin_of_d);
  void subtract(const Panel &panel, int begin_of_d);
  unsigned int place(const Panel &panel, int i) const;

  bool symmetric = true;
  std::vector<int> begin;
  std::vector<Panel> panels;
  Eigen::VectorXd D; ///< pivots
};
} // namespace softgrain

#endif
