// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_field_cells_h
#define softgrain_mpm_field_field_cells_h

#include <Eigen/Core>

#include <vector>

namespace softgrain::mpm
{
template <int>
class BodyField;

/**
 * @brief The cells of a body: their nodes, their points, and what assembly needs of them.
 *
 * Points are sorted by cell: those of cell c are first_point(c) ... first_point(c + 1) - 1.
 */
template <int dim>
class FieldCells
{
public:
  unsigned int n() const { return point_start.size() - 1; }
  unsigned int nodes_per_cell() const { return per_cell; }
  const unsigned int *nodes(const unsigned int c) const { return &node[c * per_cell]; }
  unsigned int first_point(const unsigned int c) const { return point_start[c]; }

  /// Independent nodes that the nodes of cell @p c depend on.
  const std::vector<unsigned int> &independent(const unsigned int c) const { return dependence[c]; }
  /// Whether nodes of cell @p c depend on others; else its independent nodes are its nodes, in their order.
  bool extended(const unsigned int c) const { return is_extended[c] != 0; }

  /// Groups of cells of which no two touch the same independent node (for assembly) or the same node (for
  /// scattering): cells of a group can be worked on at once, and the order of additions never depends on the
  /// number of threads.
  const std::vector<std::vector<unsigned int>> &colors() const { return groups; }

  /**
   * @brief Sums what cells give to their nodes, in an order that does not depend on the number of threads.
   * @param[in]  of_cells dim values per node of every cell
   * @param[out] all      dim values per node
   */
  void gather(const std::vector<double> &of_cells, Eigen::VectorXd &all) const;

private:
  friend class BodyField<dim>;
  unsigned int per_cell = 0;
  std::vector<unsigned int> node;        ///< those of all cells, cell by cell
  std::vector<unsigned int> point_start; ///< first point of every cell, and the end
  /// Where a node stands in `node`, for all nodes one after the other, and where each of them begins.
  std::vector<unsigned int> place_of_node, place_start;
  std::vector<std::vector<unsigned int>> dependence;
  std::vector<char> is_extended;
  std::vector<Eigen::MatrixXd> matrix; ///< of BodyField::spread(), in the plane
  std::vector<std::vector<unsigned int>> groups;
};
} // namespace softgrain::mpm

#endif
