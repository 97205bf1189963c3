// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/cell_slopes.h>
#include <softgrain/mpm/stiffness.h>
#include <softgrain/mpm/system_matrix.h>

#include <array>

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
                          const unsigned int cell,
                          const std::vector<dealii::Tensor<1, dim>> &mean,
                          const double total,
                          Eigen::MatrixXd &local)
{
  const unsigned int n = mean.size();
  std::vector<dealii::Tensor<1, dim>> slopes;
  double pressure_sum = 0.;
  for (unsigned int p = body.field.first_point(cell); p < body.field.first_point(cell + 1); ++p)
    pressure_sum += body.step.volume[p] * trace(body.step.stress[p]) / dim;
  const auto add = [&](const unsigned int i, const unsigned int d, const unsigned int j, const unsigned int e,
                       const double value) { local(dim * i + d, dim * j + e) += value; };
  for (unsigned int p = body.field.first_point(cell); p < body.field.first_point(cell + 1); ++p)
  {
    current_slopes(body, p, slopes);
    const auto &tau = body.step.stress[p];
    const double v = body.step.volume[p], mean_tau = trace(tau) / dim;
    const auto point = body.points[p];
    const double weight =
        point.rest_volume() * determinant(body.step.grid_gradient[p]) * determinant(point.gradient()) / total;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = 0; e < dim; ++e)
          {
            const double si = (mean[i][d] - slopes[i][d]) / dim, sj = (mean[j][e] - slopes[j][e]) / dim;
            const double ti = dealii::Tensor<1, dim>(tau * slopes[i])[d],
                         tj = dealii::Tensor<1, dim>(tau * slopes[j])[e];
            const double cross = slopes[i][e] * slopes[j][d];
            add(i, d, j, e,
                v * (2. * (ti * sj + si * tj) + 2. * dim * si * sj * mean_tau + mean_tau * cross));
            add(i, d, j, e, pressure_sum * weight * (slopes[i][d] * slopes[j][e] - cross));
          }
  }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          add(i, d, j, e, -pressure_sum * mean[i][d] * mean[j][e]);
}

/// Makes up for the negative stiffness that compression gives to rotation: -tr(tau)/2 W:W, W the skew part of
/// grad u.
template <int dim>
void add_rotation_guard(const std::vector<dealii::Tensor<1, dim>> &slopes,
                        const double weight,
                        Eigen::MatrixXd &local)
{
  // For u = e_d N: W = (e_d (x) g - g (x) e_d) / 2, so W_i:W_j = (g_i.g_j delta_de - g_i[e] g_j[d]) / 2.
  for (unsigned int i = 0; i < slopes.size(); ++i)
    for (unsigned int j = 0; j < slopes.size(); ++j)
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          local(dim * i + d, dim * j + e) +=
              0.25 * weight * ((d == e ? slopes[i] * slopes[j] : 0.) - slopes[i][e] * slopes[j][d]);
}

/// Calls make_work() once on every thread that takes a piece, and what it returns for the cells of the piece;
/// cells at the same time share no node.
template <int dim, class MakeWork>
void for_cells(const Body<dim> &body, const MakeWork &make_work)
{
  for (const std::vector<unsigned int> &color : body.field.colors())
    parallel_for(color.size(), 8,
                 [&](const std::size_t begin, const std::size_t end)
                 {
                   auto work = make_work();
                   for (std::size_t i = begin; i < end; ++i)
                     work(color[i]);
                 });
}

/// Stiffness by pair of directions: rows and columns x x, y x, x y, y y.
template <int n>
using PlaneBlocks = std::array<Eigen::Matrix<double, n, n>, 4>;

/// Stiffness of one cell over its own nodes.
template <int dim>
void cell_stiffness(const Body<dim> &body,
                    const unsigned int cell,
                    const bool guard_rotation,
                    Eigen::MatrixXd &local)
{
  constexpr unsigned int n_strain = dealii::SymmetricTensor<2, dim>::n_independent_components;
  const unsigned int n = body.field.nodes_per_cell();
  std::vector<dealii::Tensor<1, dim>> slopes, mean;
  Eigen::Matrix<double, n_strain, Eigen::Dynamic> B(n_strain, dim * n), CB(n_strain, dim * n);
  Eigen::Matrix<double, n_strain, n_strain> C;
  local.setZero(dim * n, dim * n);
  double total = 0.;
  if (body.f_bar)
    total = mean_slopes(body, cell, mean);
  for (unsigned int p = body.field.first_point(cell); p < body.field.first_point(cell + 1); ++p)
  {
    const double v = body.step.volume[p];
    current_slopes(body, p, slopes);
    for (unsigned int a = 0; a < n_strain; ++a)
      for (unsigned int b = 0; b < n_strain; ++b)
        C(a, b) = v * body.step.tangent[p].access_raw_entry(a * n_strain + b);
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int d = 0; d < dim; ++d)
      {
        auto strain = strain_of(slopes[k], d);
        if (body.f_bar)
          for (unsigned int e = 0; e < dim; ++e)
            strain[e][e] += (mean[k][d] - slopes[k][d]) / dim;
        for (unsigned int a = 0; a < n_strain; ++a)
          // Shear counts twice in the double contraction.
          B(a, dim * k + d) = (a < dim ? 1. : 2.) * strain.access_raw_entry(a);
      }
    CB.noalias() = C * B;
    local.noalias() += B.transpose() * CB;
    const auto &tau = body.step.stress[p];
    if (!body.small_strain())
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
    // A little more than rigid rotation needs.
    if (guard_rotation && trace(tau) < 0.)
      add_rotation_guard(slopes, -1.25 * v * trace(tau), local);
  }
  if (body.f_bar && !body.small_strain())
    add_dilatation_terms(body, cell, mean, total, local);
}

/// The same in the plane without F-bar and guard, for a number of nodes known to the compiler: by direction,
/// so that all is products of small matrices.
template <int n>
void plane_stiffness(const Body<2> &body, const unsigned int cell, PlaneBlocks<n> &blocks)
{
  using Column = Eigen::Matrix<double, n, 1>;
  for (auto &block : blocks)
    block.setZero();
  for (unsigned int p = body.field.first_point(cell); p < body.field.first_point(cell + 1); ++p)
  {
    const double v = body.step.volume[p];
    const dealii::Tensor<1, 2> *slope = body.field.slopes(p);
    Column gx, gy;
    if (body.small_strain())
      for (int k = 0; k < n; ++k)
      {
        gx[k] = slope[k][0];
        gy[k] = slope[k][1];
      }
    else
    {
      const dealii::Tensor<2, 2> inverse = invert(body.step.grid_gradient[p]);
      for (int k = 0; k < n; ++k)
      {
        gx[k] = slope[k][0] * inverse[0][0] + slope[k][1] * inverse[1][0];
        gy[k] = slope[k][0] * inverse[0][1] + slope[k][1] * inverse[1][1];
      }
    }
    // Components xx, yy, xy: B of a node is [gx 0; 0 gy; gy gx] with the shear counted twice.
    const auto C = [&](const unsigned int a, const unsigned int b)
    { return v * body.step.tangent[p].access_raw_entry(3 * a + b); };
    const Column xx = C(0, 0) * gx + C(0, 2) * gy, yx = C(1, 0) * gx + C(1, 2) * gy,
                 sx = C(2, 0) * gx + C(2, 2) * gy, xy = C(0, 1) * gy + C(0, 2) * gx,
                 yy = C(1, 1) * gy + C(1, 2) * gx, sy = C(2, 1) * gy + C(2, 2) * gx;
    blocks[0].noalias() += gx * xx.transpose() + gy * sx.transpose();
    blocks[1].noalias() += gy * yx.transpose() + gx * sx.transpose();
    blocks[2].noalias() += gx * xy.transpose() + gy * sy.transpose();
    blocks[3].noalias() += gy * yy.transpose() + gx * sy.transpose();
    if (body.small_strain())
      continue;
    const auto &tau = body.step.stress[p];
    const Column tx = v * (tau[0][0] * gx + tau[0][1] * gy), ty = v * (tau[1][0] * gx + tau[1][1] * gy);
    const Eigen::Matrix<double, n, n> geometric = gx * tx.transpose() + gy * ty.transpose();
    blocks[0] += geometric;
    blocks[3] += geometric;
  }
}

/// Adds the cells of the plane, all of n nodes.
template <int n>
void add_plane_stiffness(const Body<2> &body, const double factor, SystemMatrix &matrix)
{
  const auto make_work = [&]
  {
    return [&, blocks = PlaneBlocks<n>(), half = Eigen::Matrix<double, n, Eigen::Dynamic>(),
            local = Eigen::MatrixXd(), part = Eigen::MatrixXd()](const unsigned int c) mutable
    {
      plane_stiffness<n>(body, c, blocks);
      const Eigen::MatrixXd &extension = body.field.cell_extension(c);
      const bool whole = extension.size() == 0;
      const int m = whole ? n : extension.cols();
      local.resize(2 * m, 2 * m);
      for (int d = 0; d < 2; ++d)
        for (int e = 0; e < 2; ++e)
        {
          auto to = local(Eigen::seqN(d, m, 2), Eigen::seqN(e, m, 2));
          const Eigen::Matrix<double, n, n> &block = blocks[2 * e + d];
          if (whole)
          {
            to = block;
            continue;
          }
          const Eigen::Map<const Eigen::Matrix<double, n, Eigen::Dynamic>> E(extension.data(), n, m);
          half.noalias() = block.lazyProduct(E);
          part.noalias() = E.transpose().lazyProduct(half);
          to = part;
        }
      matrix.add_cell<2>(body.field, c, local, factor);
    };
  };
  for_cells(body, make_work);
}

/// Adds the cells by cell_stiffness().
template <int dim>
void add_general_stiffness(const Body<dim> &body,
                           const double factor,
                           const bool guard_rotation,
                           SystemMatrix &matrix)
{
  const auto make_work = [&]
  {
    return [&, local = Eigen::MatrixXd(), reduced = Eigen::MatrixXd()](const unsigned int c) mutable
    {
      cell_stiffness(body, c, guard_rotation, local);
      const Eigen::MatrixXd &extension = body.field.cell_extension(c);
      if (extension.size() == 0)
      {
        matrix.add_cell<dim>(body.field, c, local, factor);
        return;
      }
      // (E (x) I)^T local (E (x) I), direction by direction: both sides hold dim components per node.
      const unsigned int m = extension.cols(), n = extension.rows();
      Eigen::MatrixXd wide = Eigen::MatrixXd::Zero(dim * n, dim * m);
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < m; ++b)
          for (unsigned int d = 0; d < dim; ++d)
            wide(dim * a + d, dim * b + d) = extension(a, b);
      reduced.noalias() = wide.transpose() * (local * wide);
      matrix.add_cell<dim>(body.field, c, reduced, factor);
    };
  };
  for_cells(body, make_work);
}
} // namespace

template <int dim>
void add_stiffness(const Body<dim> &body,
                   const double factor,
                   const bool guard_rotation,
                   SystemMatrix &matrix)
{
  if constexpr (dim == 2)
    if (!body.f_bar && !guard_rotation)
    {
      if (body.field.nodes_per_cell() == 4)
        return add_plane_stiffness<4>(body, factor, matrix);
      if (body.field.nodes_per_cell() == 9)
        return add_plane_stiffness<9>(body, factor, matrix);
    }
  add_general_stiffness(body, factor, guard_rotation, matrix);
}

template void add_stiffness<2>(const Body<2> &, double, bool, SystemMatrix &);
template void add_stiffness<3>(const Body<3> &, double, bool, SystemMatrix &);
} // namespace softgrain::mpm
