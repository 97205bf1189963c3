// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_system_matrix_h
#define softgrain_linear_system_matrix_h

#include <deal.II/base/symmetric_tensor.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace softgrain
{
/**
 * @brief Symmetric matrix of one body, lower triangle by columns, with its places looked up once per grid.
 */
class SystemMatrix
{
public:
  using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

  /**
   * @brief Lays out the pattern and where every cell adds to it.
   * @param dim unknowns per node
   * @param n_nodes number of nodes
   * @param nodes_of_cell sorted nodes of every cell; none where nothing is added
   * @throw std::length_error when more than 65535 nodes meet one in cells
   */
  void
  reinit(unsigned int dim, unsigned int n_nodes, const std::vector<std::vector<unsigned int>> &nodes_of_cell);

  /// Tells where the nodes are: @p coordinates holds dim numbers per node [m].
  void set_places(std::vector<double> coordinates) { node_places = std::move(coordinates); }

  /// Translations and, where places are known, rotations: one column each, which the matrix of a free body
  /// without inertia takes to zero. Multigrid needs to know them.
  Eigen::MatrixXd rigid_motions() const;

  void set_zero();

  /**
   * @brief Adds @p factor times the lower triangle of a cell's matrix over the independent nodes of that
   * cell.
   * @param value of (node a, direction e) in the row and (node b, direction d) in the column, nodes counted
   * within the cell: value(a, e, b, d)
   * @throw std::logic_error for a cell that was not laid out: a matrix that lacks a part would pass unnoticed
   */
  template <int dim, class Value>
  void add_cell(const unsigned int cell, const Value &value, const double factor)
  {
    const Places here = places_of(cell);
    const std::uint16_t *row = here.row;
    double *values = matrix.valuePtr();
    for (unsigned int b = 0; b < here.n_nodes; ++b)
    {
      const int *const column = matrix.outerIndexPtr() + dim * here.node[b];
      for (unsigned int a = b; a < here.n_nodes; ++a, ++row)
        for (unsigned int d = 0; d < dim; ++d)
        {
          // In the column of direction d the diagonal block has dim - d entries, every other block dim.
          double *const of_block = values + column[d] + (a == b ? 0 : *row * dim - d);
          for (unsigned int e = (a == b ? d : 0), k = 0; e < dim; ++e, ++k)
            of_block[k] += factor * value(a, e, b, d);
        }
    }
  }

  /// Adds a cell in the plane from a matrix in blocks, of directions x x, x y and y y side by side: rows for
  /// the first direction, columns for the second. @param stride between columns
  void add_plane_cell(unsigned int cell, const double *blocks, std::ptrdiff_t stride);

  /// Adds @p factor * @p mass to the diagonal, one mass per node.
  template <int dim>
  void add_mass(const Eigen::VectorXd &mass, double factor);

  /// Adds a symmetric @p block to that of a node with itself.
  template <int dim>
  void add_node(const unsigned int node, const dealii::SymmetricTensor<2, dim> &block)
  {
    double *values = matrix.valuePtr();
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = d; e < dim; ++e)
        values[matrix.outerIndexPtr()[dim * node + d] + (e - d)] += block[e][d];
  }

  /// The matrix; only its lower triangle is stored.
  const Sparse &lower() const { return matrix; }
  /// Whether the pattern changed since the flag was last cleared, so that an analysis has to be made anew.
  bool pattern_is_new() const { return new_pattern; }
  void clear_pattern_flag() { new_pattern = false; }

private:
  /// Where the values of a cell go: its nodes, and for every pair of these, column by column from the
  /// diagonal down, the number of their block among those of its column.
  struct Places
  {
    unsigned int n_nodes;
    const unsigned int *node;
    const std::uint16_t *row;
  };
  Places places_of(const unsigned int cell) const
  {
    const unsigned int first = first_node[cell], n = first_node[cell + 1] - first;
    if (n == 0)
      refuse(cell);
    return {n, &node_of_cell[first], &row_of_pair[first_pair[cell]]};
  }

  [[noreturn]] static void refuse(unsigned int cell);
  /// @param rows of the lower blocks of each block column
  void find_places(const std::vector<std::vector<unsigned int>> &nodes_of_cell,
                   const std::vector<std::vector<unsigned int>> &rows);

  Sparse matrix;
  unsigned int n_components = 0;   ///< unknowns per node
  std::vector<double> node_places; ///< none, or n_components per node
  // Of all cells, one after the other: a number for each pair of nodes, not a place for each of its entries.
  std::vector<unsigned int> first_node, node_of_cell;
  std::vector<std::size_t> first_pair;
  std::vector<std::uint16_t> row_of_pair;
  bool new_pattern = true;
};
} // namespace softgrain

#endif
