// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/linear/system_matrix.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace softgrain
{
void SystemMatrix::reinit(const unsigned int dim,
                          const unsigned int n_nodes,
                          const std::vector<std::vector<unsigned int>> &nodes_of_cell)
{
  const unsigned int n = n_nodes;
  n_components = dim;
  node_places.clear();
  std::vector<std::vector<unsigned int>> rows(n); // of the lower blocks of each block column
  for (const std::vector<unsigned int> &nodes : nodes_of_cell)
    for (const unsigned int i : nodes)
      for (const unsigned int j : nodes)
        if (i >= j)
          rows[j].push_back(i);
  for (unsigned int j = 0; j < n; ++j)
  {
    rows[j].push_back(j);
    std::sort(rows[j].begin(), rows[j].end());
    rows[j].erase(std::unique(rows[j].begin(), rows[j].end()), rows[j].end());
  }

  matrix.resize(dim * n, dim * n);
  Eigen::VectorXi sizes(dim * n);
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int d = 0; d < dim; ++d)
      sizes[dim * j + d] = dim * rows[j].size() - d;
  matrix.reserve(sizes);
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int d = 0; d < dim; ++d)
      for (const unsigned int i : rows[j])
        for (unsigned int e = (i == j ? d : 0); e < dim; ++e)
          matrix.insert(dim * i + e, dim * j + d) = 0.;
  matrix.makeCompressed();

  find_places(nodes_of_cell, rows);
  new_pattern = true;
}

void SystemMatrix::find_places(const std::vector<std::vector<unsigned int>> &nodes_of_cell,
                               const std::vector<std::vector<unsigned int>> &rows)
{
  first_node.assign(1, 0);
  first_pair.assign(1, 0);
  for (const std::vector<unsigned int> &nodes : nodes_of_cell)
  {
    first_node.push_back(first_node.back() + nodes.size());
    first_pair.push_back(first_pair.back() + nodes.size() * (nodes.size() + 1) / 2);
  }
  node_of_cell.clear();
  node_of_cell.reserve(first_node.back());
  row_of_pair.clear();
  row_of_pair.reserve(first_pair.back());
  for (const std::vector<unsigned int> &nodes : nodes_of_cell)
  {
    AssertThrow(std::is_sorted(nodes.begin(), nodes.end()), dealii::ExcInternalError());
    node_of_cell.insert(node_of_cell.end(), nodes.begin(), nodes.end());
    for (unsigned int b = 0; b < nodes.size(); ++b)
    {
      const std::vector<unsigned int> &column = rows[nodes[b]];
      if (column.size() > std::numeric_limits<std::uint16_t>::max())
        throw std::length_error(std::to_string(column.size()) + " nodes meet one in the matrix of a body");
      for (unsigned int a = b; a < nodes.size(); ++a)
        row_of_pair.push_back(std::lower_bound(column.begin(), column.end(), nodes[a]) - column.begin());
    }
  }
}

void SystemMatrix::refuse(const unsigned int cell)
{
  throw std::logic_error("cell " + std::to_string(cell) + " has no place in the matrix of its body");
}

Eigen::MatrixXd SystemMatrix::rigid_motions() const
{
  const unsigned int dim = n_components, n_nodes = matrix.rows() / dim;
  const unsigned int n_rotations = node_places.empty() ? 0 : dim * (dim - 1) / 2;
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(matrix.rows(), dim + n_rotations);
  for (unsigned int i = 0; i < n_nodes; ++i)
    for (unsigned int d = 0; d < dim; ++d)
      motions(dim * i + d, d) = 1.;
  if (n_rotations == 0)
    return motions;
  // About the middle and in units of the size, so that columns are of one magnitude.
  const Eigen::Map<const Eigen::MatrixXd> x(node_places.data(), dim, n_nodes);
  const Eigen::VectorXd middle = x.rowwise().mean();
  const double size = std::max((x.colwise() - middle).cwiseAbs().maxCoeff(), 1e-300);
  unsigned int column = dim;
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int e = d + 1; e < dim; ++e, ++column)
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        motions(dim * i + d, column) = -(x(e, i) - middle[e]) / size;
        motions(dim * i + e, column) = (x(d, i) - middle[d]) / size;
      }
  return motions;
}

void SystemMatrix::set_zero()
{
  std::fill(matrix.valuePtr(), matrix.valuePtr() + matrix.nonZeros(), 0.);
}

void SystemMatrix::add_plane_cell(const unsigned int cell,
                                  const double *const blocks,
                                  const std::ptrdiff_t stride)
{
  // Both directions of a node follow each other in a column.
  using Pair [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = double;
  const Places here = places_of(cell);
  const unsigned int n = here.n_nodes;
  const std::uint16_t *row = here.row;
  const double *const xx = blocks, *const xy = blocks + n * stride, *const yy = blocks + 2 * n * stride;
  for (unsigned int b = 0; b < n; ++b)
  {
    const double *const xx_b = xx + b * stride, *const xy_b = xy + b * stride, *const yy_b = yy + b * stride,
                        *const yx_b = xy + b;
    const int *const column = matrix.outerIndexPtr() + 2 * here.node[b];
    double *const along_x = matrix.valuePtr() + column[0], *const along_y = matrix.valuePtr() + column[1];
    along_x[0] += xx_b[b];
    along_x[1] += xy_b[b];
    along_y[0] += yy_b[b];
    ++row;
    for (unsigned int a = b + 1; a < n; ++a, ++row)
    {
      *reinterpret_cast<Pair *>(along_x + 2 * *row) += Pair{xx_b[a], yx_b[a * stride]};
      *reinterpret_cast<Pair *>(along_y + 2 * *row - 1) += Pair{xy_b[a], yy_b[a]};
    }
  }
}

template <int dim>
void SystemMatrix::add_mass(const Eigen::VectorXd &mass, const double factor)
{
  double *values = matrix.valuePtr();
  const int *start = matrix.outerIndexPtr();
  for (unsigned int i = 0; i < mass.size(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      values[start[dim * i + d]] += factor * mass[i];
}

template void SystemMatrix::add_mass<2>(const Eigen::VectorXd &, double);
template void SystemMatrix::add_mass<3>(const Eigen::VectorXd &, double);
} // namespace softgrain
