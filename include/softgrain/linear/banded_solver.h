// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_banded_solver_h
#define softgrain_linear_banded_solver_h

#include <softgrain/linear/dense_kernels.h>
#include <softgrain/linear/linear_solver.h>

#include <cstddef>
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
  /// Columns `first` to `first + block` of the factor, and rows from there to `end`; in place of the diagonal
  /// block L stands its inverse, with zeros above the diagonal.
  struct Panel
  {
    int first = 0, end = 0;
    std::size_t start = 0; ///< in values
    int height() const { return end - first; }
  };

  void analyze(const SystemMatrix::Sparse &matrix);
  void fill(const SystemMatrix::Sparse &matrix);
  bool factorize_diagonal(int panel);
  /// Substitutions in place.
  void forward(double *x) const;
  void backward(double *x) const;

  DenseKernels::Out of_panel(const int k) { return {&values[panels[k].start], panels[k].height()}; }
  DenseKernels::In of_panel(const int k) const { return {&values[panels[k].start], panels[k].height()}; }

  int block = 0; ///< columns of a panel
  int n_panels = 0;
  std::vector<int> negative; ///< unknowns, in their new order, whose pivot is negative
  std::vector<int> order;    ///< new place of every unknown
  std::vector<Panel> panels;
  std::vector<std::ptrdiff_t> column_start; ///< place in values at which row 0 of a column would be
  std::vector<double> values;               ///< of the panels, each by columns
  double factor = 1.;                       ///< of the matrix that is factorised, see for_even_exponent()
};
} // namespace softgrain

#endif
