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
 * the contact of two grains in space; this one spends it in products of dense matrices. Columns of blocks
 * with nearly the same blocks below them are eliminated together. Products are cut in pieces that do not
 * depend on the number of threads, so results do not either.
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

  using Entries = Eigen::Map<Eigen::MatrixXd>;

  /// A block of the lower triangle, which reinit() has laid out: row block @p i, column block @p j <= i. Of a
  /// diagonal one of a symmetric matrix only the lower triangle counts.
  Eigen::Block<Entries> block(int i, int j);
  /// The block of a matrix that is not symmetric in row block @p j and column block @p i > j, transposed.
  Eigen::Block<Entries> transposed_block(int i, int j);

  /// Where the unknowns of a block begin; the last one is their number.
  const std::vector<int> &first() const { return begin; }

  /// Factorises in place. @return false when a pivot is 0 or no number
  bool factorize();
  /// Negative entries of D, of a symmetric matrix.
  unsigned int n_negative() const;
  /// Solves in place.
  void solve(Eigen::VectorXd &x) const;

private:
  /// Columns of blocks that have nearly the same blocks below them, as one matrix: the blocks of these
  /// columns first, then those below, one upon the other. What lies to the right of the square on top, if the
  /// matrix is not symmetric, is kept transposed.
  struct Panel
  {
    std::vector<int> rows;   ///< row blocks, ascending, those of the columns first
    std::vector<int> offset; ///< where they begin, and where the last one ends
    unsigned int n_own = 0;  ///< blocks that are columns
    int first = 0;           ///< the first unknown
    std::size_t place = 0;   ///< of its entries among those of all panels

    int width() const { return offset[n_own]; }
    int height() const { return offset.back(); }
    std::size_t size() const { return static_cast<std::size_t>(width()) * height(); }
  };
  Entries entries_of(const Panel &panel)
  {
    return Entries(storage.data() + panel.place, panel.height(), panel.width());
  }
  /// The top of it is what lies above the diagonal blocks, until factorize() has put it there.
  Entries right_of(const Panel &panel)
  {
    return Entries(storage.data() + panel.place + panel.size(), panel.height(), panel.width());
  }
  using ConstEntries = Eigen::Map<const Eigen::MatrixXd>;
  ConstEntries entries_of(const Panel &panel) const
  {
    return ConstEntries(storage.data() + panel.place, panel.height(), panel.width());
  }
  ConstEntries right_of(const Panel &panel) const
  {
    return ConstEntries(storage.data() + panel.place + panel.size(), panel.height(), panel.width());
  }
  /// Finds which blocks are below which in the matrix.
  void find_below(const std::vector<int> &sizes, const std::vector<std::pair<int, int>> &neighbours);
  /// Finds which blocks are below which in the factors, and which columns make a panel.
  void find_panels(const std::vector<int> &sizes, const std::vector<std::pair<int, int>> &neighbours);
  Eigen::Block<Entries> part(Entries of_panel, const Panel &panel, int i, int j) const;
  bool factorize_panel(Panel &panel);
  bool factorize_strip(Panel &panel, int first, int width);
  void subtract_strip(Panel &panel, int first, int width);
  void subtract(const Panel &panel);
  void subtract_from(const Panel &target, const Panel &panel, unsigned int first, unsigned int end);

  bool symmetric = true;
  std::vector<int> begin;
  std::vector<Panel> panels; ///< those before n_panels are there; the others keep their memory
  unsigned int n_panels = 0;
  std::vector<int> panel_of;              ///< of every block, -1 where it has no rows
  std::vector<std::vector<int>> below_of; ///< row blocks below every column of blocks, ascending
  std::vector<int> merged;
  std::vector<double> storage; ///< entries of all panels, one after the other
  Eigen::VectorXd D;           ///< pivots
};
} // namespace softgrain

#endif
