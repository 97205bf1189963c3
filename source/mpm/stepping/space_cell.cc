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

void SpaceCell::add(const Body<3> &body,
                    const StepState<3> &s,
                    const unsigned int cell,
                    const double factor,
                    SystemMatrix &matrix)
{
  const unsigned int first = body.field.cells().first_point(cell);
  const unsigned int n_points = body.field.cells().first_point(cell + 1) - first;
  if (n_points == 0)
    return;
  const int m = body.field.cells().independent(cell).size(), n_rows = DenseKernels::filled(m),
            n_columns = DenseKernels::filled(6 * m);
  const DenseKernels::Out slopes = slope_columns.find(body, s, cell, n_rows);
  const DenseKernels::Out response = of_response.sized(n_columns, 3 * n_points);
  const DenseKernels::Out blocks = of_blocks.sized(n_rows, n_columns);
  const bool geometric = !body.material.small_strain();
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
