// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/stepping/space_cell.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
/// Where a pair of directions stands among the components of a symmetric tensor.
constexpr unsigned int component[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
/// The blocks that are computed, in the order in which they stand.
constexpr unsigned int block_of[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
} // namespace

DenseKernels::Out SpaceCell::Memory::sized(const int n_rows, const int n_columns)
{
  const std::size_t size = static_cast<std::size_t>(n_rows) * n_columns;
  if (values.size() < size)
    values.resize(size);
  return {values.data(), n_rows};
}

DenseKernels::Out
SpaceCell::find_slopes(const Body<3> &body, const StepState<3> &s, const unsigned int cell, const int n_rows)
{
  const Eigen::MatrixXd &spread = body.field.cell_spread(cell);
  const bool extended = spread.size() > 0;
  const unsigned int first = body.field.first_point(cell), n = body.field.nodes_per_cell();
  const int n_columns = 3 * (body.field.first_point(cell + 1) - first),
            n_filled = extended ? DenseKernels::filled(n_columns) : n_columns;
  const DenseKernels::Out slopes = of_slopes.sized(n_rows, n_filled);
  // A column for every node where they are still to be extended, else one for every derivative.
  const DenseKernels::Out nodal = extended ? of_nodes.sized(n_filled, n) : slopes;
  const std::ptrdiff_t to_node = extended ? nodal.stride : 1, to_derivative = extended ? 1 : nodal.stride;
  for (int q = 0; 3 * q < n_columns; ++q)
  {
    const dealii::Tensor<1, 3> *const slope = body.field.slopes(first + q);
    const dealii::Tensor<2, 3> inverse =
        body.small_strain() ? dealii::unit_symmetric_tensor<3>() : invert(s.grid_gradient[first + q]);
    double *const of_point = nodal.data + 3 * q * to_derivative;
    for (unsigned int k = 0; k < n; ++k)
    {
      const dealii::Tensor<1, 3> now = slope[k] * inverse;
      for (unsigned int d = 0; d < 3; ++d)
        of_point[k * to_node + d * to_derivative] = now[d];
    }
  }
  if (!extended)
  {
    for (int j = 0; j < n_columns; ++j)
      std::fill(slopes.at(n, j), slopes.at(n_rows, j), 0.);
    return slopes;
  }
  for (unsigned int k = 0; k < n; ++k)
    std::fill(nodal.at(n_columns, k), nodal.at(n_filled, k), 0.);
  DenseKernels::set_product(n_rows, n_filled, n, {spread.data(), spread.outerStride()}, nodal, slopes);
  return slopes;
}

void SpaceCell::add(const Body<3> &body,
                    const StepState<3> &s,
                    const unsigned int cell,
                    const double factor,
                    SystemMatrix &matrix)
{
  const unsigned int first = body.field.first_point(cell);
  const unsigned int n_points = body.field.first_point(cell + 1) - first;
  if (n_points == 0)
    return;
  const int m = body.field.cell_independent(cell).size(), n_rows = DenseKernels::filled(m),
            n_columns = DenseKernels::filled(6 * m);
  const DenseKernels::Out slopes = find_slopes(body, s, cell, n_rows);
  const DenseKernels::Out response = of_response.sized(n_columns, 3 * n_points);
  const DenseKernels::Out blocks = of_blocks.sized(n_rows, n_columns);
  const bool geometric = !body.small_strain();
  for (unsigned int q = 0; q < n_points; ++q)
  {
    const double v = factor * s.volume[first + q];
    const auto &tau = s.stress[first + q];
    const auto &C = s.tangent[first + q];
    const double *const g[3] = {slopes.at(0, 3 * q), slopes.at(0, 3 * q + 1), slopes.at(0, 3 * q + 2)};
    for (unsigned int a = 0; a < 3; ++a)
    {
      double *out = response.at(0, 3 * q + a);
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int e = d; e < 3; ++e, out += m)
        {
          double D[3];
          for (unsigned int b = 0; b < 3; ++b)
          {
            D[b] = C.access_raw_entry(6 * component[d][a] + component[e][b]);
            if (d == e && geometric)
              D[b] += tau[a][b];
            D[b] *= v;
          }
          for (int k = 0; k < m; ++k)
            out[k] = D[0] * g[0][k] + D[1] * g[1][k] + D[2] * g[2][k];
        }
      std::fill(out, response.at(n_columns, 3 * q + a), 0.);
    }
  }
  DenseKernels::set_product(n_rows, n_columns, 3 * n_points, slopes, response, blocks);
  matrix.add_cell<3>(
      cell,
      [&](const unsigned int a, const unsigned int e, const unsigned int b, const unsigned int d)
      {
        const unsigned int block = m * block_of[d][e];
        return e <= d ? *blocks.at(a, block + b) : *blocks.at(b, block + a);
      },
      1.);
}
} // namespace softgrain::mpm
