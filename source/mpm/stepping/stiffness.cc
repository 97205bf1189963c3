// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/linear/dense_kernels.h>
#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/field/cell_slopes.h>
#include <softgrain/mpm/stepping/slope_columns.h>
#include <softgrain/mpm/stepping/space_cell.h>
#include <softgrain/mpm/stepping/stiffness.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
/// sym(a (x) slope) for a displacement of one node along direction @p d.
template <int dim>
dealii::SymmetricTensor<2, dim> strain_of(const dealii::Tensor<1, dim> &slope, const unsigned int d)
{
  dealii::SymmetricTensor<2, dim> strain;
  for (unsigned int e = 0; e < dim; ++e)
    strain[d][e] += (d == e ? 1. : 0.5) * slope[e];
  return strain;
}

/// Terms of the tangent that come from averaging the dilatation; see doc/theory.md, "F-bar".
template <int dim>
void add_dilatation_terms(const Body<dim> &body,
                          const StepState<dim> &s,
                          const unsigned int cell,
                          const CellSlopes<dim> &mean,
                          const double total,
                          Eigen::MatrixXd &local)
{
  const unsigned int n = mean.size();
  CellSlopes<dim> slopes;
  double pressure_sum = 0.;
  for (unsigned int p = body.field.cells().first_point(cell); p < body.field.cells().first_point(cell + 1);
       ++p)
    pressure_sum += body.material.averaged * s.volume[p] * trace(s.stress[p]) / dim;
  const auto add = [&](const unsigned int i, const unsigned int d, const unsigned int j, const unsigned int e,
                       const double value) { local(dim * i + d, dim * j + e) += value; };
  for (unsigned int p = body.field.cells().first_point(cell); p < body.field.cells().first_point(cell + 1);
       ++p)
  {
    current_slopes(body, s, p, slopes);
    const auto &tau = s.stress[p];
    const double v = s.volume[p], mean_tau = trace(tau) / dim;
    const auto point = body.points[p];
    const double weight =
        point.rest_volume() * determinant(s.grid_gradient[p]) * determinant(point.gradient()) / total;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = 0; e < dim; ++e)
          {
            const double si = body.material.averaged * (mean[i][d] - slopes[i][d]) / dim,
                         sj = body.material.averaged * (mean[j][e] - slopes[j][e]) / dim;
            const double ti = dealii::Tensor<1, dim>(tau * slopes[i])[d],
                         tj = dealii::Tensor<1, dim>(tau * slopes[j])[e];
            const double cross = slopes[i][e] * slopes[j][d];
            add(i, d, j, e,
                v * (2. * (ti * sj + si * tj) + 2. * dim * si * sj * mean_tau +
                     body.material.averaged * mean_tau * cross));
            add(i, d, j, e, pressure_sum * weight * (slopes[i][d] * slopes[j][e] - cross));
          }
  }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          add(i, d, j, e, -pressure_sum * mean[i][d] * mean[j][e]);
}

/// Calls work(cell) for all cells; those at the same time share no node.
template <int dim, class Work>
void for_cells(const Body<dim> &body, const Work &work)
{
  for (const std::vector<unsigned int> &color : body.field.cells().colors())
    parallel_for(color.size(), 8,
                 [&](const std::size_t begin, const std::size_t end)
                 {
                   for (std::size_t i = begin; i < end; ++i)
                     work(color[i]);
                 });
}

/// Strain and stress over the displacements of a cell's nodes.
template <int dim>
using StrainMatrix = Eigen::Matrix<double,
                                   dealii::SymmetricTensor<2, dim>::n_independent_components,
                                   Eigen::Dynamic,
                                   0,
                                   dealii::SymmetricTensor<2, dim>::n_independent_components,
                                   dim * power(ShapeFunction::max_nodes, dim)>;

/// Stiffness of one cell over its own nodes.
template <int dim>
void cell_stiffness(const Body<dim> &body,
                    const StepState<dim> &s,
                    const unsigned int cell,
                    Eigen::MatrixXd &local)
{
  constexpr unsigned int n_strain = dealii::SymmetricTensor<2, dim>::n_independent_components;
  const unsigned int n = body.field.cells().nodes_per_cell();
  CellSlopes<dim> slopes, mean;
  StrainMatrix<dim> B(n_strain, dim * n), CB(n_strain, dim * n);
  Eigen::Matrix<double, n_strain, n_strain> C;
  local.setZero(dim * n, dim * n);
  double total = 0.;
  if (body.material.averaged > 0.)
    total = mean_slopes(body, s, cell, mean);
  for (unsigned int p = body.field.cells().first_point(cell); p < body.field.cells().first_point(cell + 1);
       ++p)
  {
    const double v = s.volume[p];
    current_slopes(body, s, p, slopes);
    for (unsigned int a = 0; a < n_strain; ++a)
      for (unsigned int b = 0; b < n_strain; ++b)
        C(a, b) = v * s.tangent[p].access_raw_entry(a * n_strain + b);
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int d = 0; d < dim; ++d)
      {
        auto strain = strain_of(slopes[k], d);
        if (body.material.averaged > 0.)
          for (unsigned int e = 0; e < dim; ++e)
            strain[e][e] += body.material.averaged * (mean[k][d] - slopes[k][d]) / dim;
        for (unsigned int a = 0; a < n_strain; ++a)
          // Shear counts twice in the double contraction.
          B(a, dim * k + d) = (a < dim ? 1. : 2.) * strain.access_raw_entry(a);
      }
    CB.noalias() = C * B;
    local.noalias() += B.transpose() * CB;
    const auto &tau = s.stress[p];
    if (!body.material.small_strain())
      for (unsigned int j = 0; j < n; ++j)
      {
        const dealii::Tensor<1, dim> t = v * (tau * slopes[j]);
        for (unsigned int i = 0; i < n; ++i)
        {
          const double g = slopes[i] * t;
          for (unsigned int d = 0; d < dim; ++d)
            local(dim * i + d, dim * j + d) += g;
        }
      }
  }
  if (body.material.averaged > 0. && !body.material.small_strain())
    add_dilatation_terms(body, s, cell, mean, total, local);
}

/// Memory of a matrix whose size changes from cell to cell: one of Eigen would ask for it anew.
class Buffer
{
public:
  using Matrix = Eigen::Map<Eigen::MatrixXd, Eigen::AlignedMax>;

  Matrix sized(const Eigen::Index n_rows, const Eigen::Index n_columns)
  {
    const std::size_t size = n_rows * n_columns;
    if (memory.size() < size)
      memory.resize(size);
    return {memory.data(), n_rows, n_columns};
  }

private:
  std::vector<double, Eigen::aligned_allocator<double>> memory;
};

/// Stiffness of one cell of the plane over its independent nodes, without F-bar. What is on the rim
/// is extended point by point, before the products: a cell there has few points.
class PlaneCell
{
public:
  /// Adds the stiffness of a cell times @p factor to @p matrix.
  void add(const Body<2> &body,
           const StepState<2> &s,
           const unsigned int cell,
           const double factor,
           SystemMatrix &matrix)
  {
    const unsigned int first = body.field.cells().first_point(cell);
    const unsigned int n_points = body.field.cells().first_point(cell + 1) - first;
    const int m = body.field.cells().independent(cell).size(), n_rows = DenseKernels::filled(m),
              n_columns = DenseKernels::filled(3 * m);
    const DenseKernels::Out slopes = slope_columns.find(body, s, cell, n_rows);
    const DenseKernels::Out response = of_response.sized(n_columns, 2 * n_points);
    const DenseKernels::Out blocks = of_blocks.sized(n_rows, n_columns);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const double *const gx = slopes.at(0, 2 * q), *const gy = slopes.at(0, 2 * q + 1);
      const double v = factor * s.volume[first + q];
      const auto &tau = s.stress[first + q];
      const bool geometric = !body.material.small_strain();
      const double txx = geometric ? v * tau[0][0] : 0., txy = geometric ? v * tau[0][1] : 0.,
                   tyy = geometric ? v * tau[1][1] : 0.;
      // Components xx, yy, xy: B of a node is [gx 0; 0 gy; gy gx] with the shear counted twice.
      const auto C = [&](const unsigned int a, const unsigned int b)
      { return v * s.tangent[first + q].access_raw_entry(3 * a + b); };
      double *const with_gx = response.at(0, 2 * q), *const with_gy = response.at(0, 2 * q + 1);
      combine(m, gx, C(0, 0) + txx, gy, C(0, 2) + txy, with_gx);
      combine(m, gx, C(2, 0) + txy, gy, C(2, 2) + tyy, with_gy);
      combine(m, gx, C(0, 2), gy, C(0, 1), with_gx + m);
      combine(m, gx, C(2, 2), gy, C(2, 1), with_gy + m);
      combine(m, gx, C(2, 2) + txx, gy, C(2, 1) + txy, with_gx + 2 * m);
      combine(m, gx, C(1, 2) + txy, gy, C(1, 1) + tyy, with_gy + 2 * m);
      std::fill(with_gx + 3 * m, with_gx + n_columns, 0.);
      std::fill(with_gy + 3 * m, with_gy + n_columns, 0.);
    }
    DenseKernels::set_product(n_rows, n_columns, 2 * n_points, slopes, response, blocks);
    matrix.add_plane_cell(cell, blocks.data, blocks.stride);
  }

private:
  static void combine(
      const int m, const double *const x, const double a, const double *const y, const double b, double *out)
  {
    for (int k = 0; k < m; ++k)
      out[k] = a * x[k] + b * y[k];
  }

  SlopeColumns<2> slope_columns;
  CellMemory of_response, of_blocks;
};

/// Adds the cells by PlaneCell.
void add_plane_stiffness(const Body<2> &body,
                         const StepState<2> &s,
                         const double factor,
                         SystemMatrix &matrix)
{
  const auto work = [&](const unsigned int c)
  {
    // Buffers alone: nothing is read that this cell has not written.
    static thread_local PlaneCell plane;
    plane.add(body, s, c, factor, matrix);
  };
  for_cells(body, work);
}

/// Adds the cells by SpaceCell.
void add_space_stiffness(const Body<3> &body,
                         const StepState<3> &s,
                         const double factor,
                         SystemMatrix &matrix)
{
  const auto work = [&](const unsigned int c)
  {
    // Buffers alone: nothing is read that this cell has not written.
    static thread_local SpaceCell space;
    space.add(body, s, c, factor, matrix);
  };
  for_cells(body, work);
}

/// Adds the cells by cell_stiffness().
template <int dim>
void add_general_stiffness(const Body<dim> &body,
                           const StepState<dim> &s,
                           const double factor,
                           SystemMatrix &matrix)
{
  const auto add = [&](const unsigned int cell, const auto &of_cell)
  {
    matrix.add_cell<dim>(
        cell,
        [&](const unsigned int a, const unsigned int e, const unsigned int b, const unsigned int d)
        { return of_cell(dim * a + e, dim * b + d); },
        factor);
  };
  const auto work = [&](const unsigned int c)
  {
    // Buffers alone: nothing is read that this cell has not written.
    static thread_local Eigen::MatrixXd local;
    static thread_local Buffer of_wide, of_product, of_reduced;
    static thread_local std::vector<double> of_spread;
    cell_stiffness(body, s, c, local);
    if (!body.field.cells().extended(c))
    {
      add(c, local);
      return;
    }
    // (E (x) I)^T local (E (x) I) with the transpose of E in spread, direction by direction: both sides hold
    // dim components per node.
    const DenseKernels::In spread = body.field.spread(c, of_spread);
    const unsigned int m = body.field.cells().independent(c).size(), n = body.field.cells().nodes_per_cell();
    Buffer::Matrix wide = of_wide.sized(dim * n, dim * m), product = of_product.sized(dim * n, dim * m),
                   reduced = of_reduced.sized(dim * m, dim * m);
    wide.setZero();
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = 0; b < m; ++b)
        for (unsigned int d = 0; d < dim; ++d)
          wide(dim * a + d, dim * b + d) = *spread.at(b, a);
    product.noalias() = local * wide;
    reduced.noalias() = wide.transpose() * product;
    add(c, reduced);
  };
  for_cells(body, work);
}
} // namespace

template <int dim>
void lay_out_stiffness(const BodyField<dim> &field, SystemMatrix &matrix, const bool all_cells)
{
  std::vector<std::vector<unsigned int>> nodes(field.cells().n());
  for (const auto &color : field.cells().colors())
    for (const unsigned int cell : color)
      nodes[cell] = field.cells().independent(cell);
  for (unsigned int cell = 0; all_cells && cell < nodes.size(); ++cell)
    nodes[cell] = field.cells().independent(cell);
  matrix.reinit(dim, field.n_independent(), nodes);
  std::vector<double> places;
  places.reserve(field.n_dofs());
  for (unsigned int j = 0; j < field.n_independent(); ++j)
    for (unsigned int d = 0; d < dim; ++d)
      places.push_back(field.place(j)[d]);
  matrix.set_places(std::move(places));
}

template <int dim>
void add_stiffness(const Body<dim> &body, const StepState<dim> &s, const double factor, SystemMatrix &matrix)
{
  if (body.material.averaged > 0.)
    add_general_stiffness(body, s, factor, matrix);
  else if constexpr (dim == 2)
    add_plane_stiffness(body, s, factor, matrix);
  else
    add_space_stiffness(body, s, factor, matrix);
}

template void lay_out_stiffness<2>(const BodyField<2> &, SystemMatrix &, bool);
template void lay_out_stiffness<3>(const BodyField<3> &, SystemMatrix &, bool);
template void add_stiffness<2>(const Body<2> &, const StepState<2> &, double, SystemMatrix &);
template void add_stiffness<3>(const Body<3> &, const StepState<3> &, double, SystemMatrix &);
} // namespace softgrain::mpm
