// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_banded_solver_h
#define softgrain_linear_banded_solver_h

#include <softgrain/linear/linear_solver.h>

#include <vector>

namespace softgrain
{
/**
 * @brief Cholesky factors of a band matrix in dense panels.
 *
 * The field of a compact body on a lattice has a band of about twice its width in nodes, and dense kernels on
 * that band do ten times the arithmetic per second of a sparse factorisation: for bodies up to some ten
 * thousand unknowns this is several times faster than general sparse Cholesky, and condensation to contact
 * rows gains as much. Unknowns are ordered as they come or by reverse Cuthill-McKee, whichever gives the
 * narrower band.
 */
class BandedSolver final : public LinearSolver
{
public:
  bool factorize(SystemMatrix &matrix) override;
  std::optional<unsigned int> n_negative() const override { return negative.size(); }
  void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override;
  void condense(const Rows &rows, Eigen::MatrixXd &W) override;

  /// Half band width in unknowns that the better ordering of this pattern gives.
  static unsigned int bandwidth(const SystemMatrix &matrix);

private:
  void analyze(const SystemMatrix::Sparse &matrix);
  void fill(const SystemMatrix::Sparse &matrix);
  bool factorize_diagonal(int panel);
  /// Substitutions in place; a vector, or the columns of a matrix.
  template <class Derived>
  void forward(Eigen::MatrixBase<Derived> &x) const;
  template <class Derived>
  void backward(Eigen::MatrixBase<Derived> &x) const;

  static constexpr int block = 32; ///< columns of a panel; the fastest of 16 to 64 with AVX2
  int band = 0;                    ///< rows of a panel below its diagonal block, a multiple of block
  int n_panels = 0;
  std::vector<int> negative;  ///< unknowns, in their new order, whose pivot is negative; at most one
  std::vector<int> order;     ///< new place of every unknown
  std::vector<int> target;    ///< place in panels of every entry of the matrix
  std::vector<double> panels; ///< n_panels matrices of (block + band) x block, by columns
};
} // namespace softgrain

#endif
