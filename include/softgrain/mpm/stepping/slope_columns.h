// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_slope_columns_h
#define softgrain_mpm_stepping_slope_columns_h

#include <softgrain/linear/dense_kernels.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/step_state.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace softgrain::mpm
{
/// Memory of a matrix whose size changes from cell to cell.
class CellMemory
{
public:
  DenseKernels::Out sized(const int n_rows, const int n_columns)
  {
    const std::size_t size = static_cast<std::size_t>(n_rows) * n_columns;
    if (values.size() < size)
      values.resize(size);
    return {values.data(), n_rows};
  }

private:
  std::vector<double, Eigen::aligned_allocator<double>> values;
};

/// Slopes of the functions of the independent nodes of a cell, as columns of a matrix.
template <int dim>
class SlopeColumns
{
public:
  /// dim columns per point of the cell, @p n_rows each: those beyond the nodes are 0. They stay until the
  /// next call.
  DenseKernels::Out
  find(const Body<dim> &body, const StepState<dim> &s, const unsigned int cell, const int n_rows)
  {
    const bool extended = body.field.cells().extended(cell);
    const unsigned int first = body.field.cells().first_point(cell), n = body.field.cells().nodes_per_cell();
    const int n_columns = dim * (body.field.cells().first_point(cell + 1) - first),
              n_filled = extended ? DenseKernels::filled(n_columns) : n_columns;
    const DenseKernels::Out slopes = of_slopes.sized(n_rows, n_filled);
    // A column for every node where they are still to be extended, else one for every derivative.
    const DenseKernels::Out nodal = extended ? of_nodes.sized(n_filled, n) : slopes;
    const std::ptrdiff_t to_node = extended ? nodal.stride : 1, to_derivative = extended ? 1 : nodal.stride;
    for (int q = 0; dim * q < n_columns; ++q)
    {
      const dealii::Tensor<1, dim> *const slope = body.field.at_point(first + q).slopes;
      const dealii::Tensor<2, dim> inverse = body.material.small_strain()
                                                 ? dealii::unit_symmetric_tensor<dim>()
                                                 : invert(s.grid_gradient[first + q]);
      double *const of_point = nodal.data + dim * q * to_derivative;
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int e = 0; e < dim; ++e)
        {
          double now = slope[k][0] * inverse[0][e];
          for (unsigned int d = 1; d < dim; ++d)
            now += slope[k][d] * inverse[d][e];
          of_point[k * to_node + e * to_derivative] = now;
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
    DenseKernels::set_product(n_rows, n_filled, n, body.field.spread(cell, of_spread), nodal, slopes);
    return slopes;
  }

private:
  CellMemory of_nodes, of_slopes;
  std::vector<double> of_spread;
};
} // namespace softgrain::mpm

#endif
