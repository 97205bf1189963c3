// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_system_matrix_h
#define softgrain_mpm_system_matrix_h

#include <softgrain/mpm/body_field.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Symmetric matrix of one body, lower triangle by columns, with its places looked up once per grid.
 */
class SystemMatrix
{
public:
  using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

  /// Lays out the pattern of @p field and where every cell adds to it.
  template <int dim>
  void reinit(const BodyField<dim> &field);

  void set_zero();

  /// Adds @p factor times the lower triangle of a cell's matrix over the independent nodes of that cell.
  template <int dim>
  void add_cell(const BodyField<dim> &field, unsigned int cell, const Eigen::MatrixXd &local, double factor);

  /// Adds @p factor * @p mass to the diagonal, one mass per node.
  template <int dim>
  void add_mass(const Eigen::VectorXd &mass, double factor);

  /// The matrix; only its lower triangle is stored.
  const Sparse &lower() const { return matrix; }
  /// Whether the pattern changed since the flag was last cleared, so that an analysis has to be made anew.
  bool pattern_is_new() const { return new_pattern; }
  void clear_pattern_flag() { new_pattern = false; }

private:
  Sparse matrix;
  std::vector<std::vector<int>> cell_rank; ///< rank of block (row, column) in its column, lower pairs by cell
  bool new_pattern = true;
};
} // namespace softgrain::mpm

#endif
