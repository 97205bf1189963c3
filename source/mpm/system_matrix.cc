// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/system_matrix.h>

#include <algorithm>

namespace softgrain::mpm
{
template <int dim>
void SystemMatrix::reinit(const BodyField<dim> &field)
{
  const unsigned int n = field.n_independent();
  std::vector<std::vector<unsigned int>> rows(n); // of the lower blocks of each block column
  std::vector<char> used(field.n_cells(), 0);
  for (const auto &color : field.colors())
    for (const unsigned int c : color)
    {
      used[c] = 1;
      for (const unsigned int i : field.cell_independent(c))
        for (const unsigned int j : field.cell_independent(c))
          if (i >= j)
            rows[j].push_back(i);
    }
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

  cell_rank.assign(field.n_cells(), {});
  for (unsigned int c = 0; c < field.n_cells(); ++c)
    if (used[c])
      for (const unsigned int j : field.cell_independent(c))
        for (const unsigned int i : field.cell_independent(c))
          cell_rank[c].push_back(
              i < j
                  ? -1
                  : static_cast<int>(std::lower_bound(rows[j].begin(), rows[j].end(), i) - rows[j].begin()));
  new_pattern = true;
}

void SystemMatrix::set_zero()
{
  std::fill(matrix.valuePtr(), matrix.valuePtr() + matrix.nonZeros(), 0.);
}

template <int dim>
void SystemMatrix::add_cell(const BodyField<dim> &field,
                            const unsigned int cell,
                            const Eigen::MatrixXd &local,
                            const double factor)
{
  const std::vector<unsigned int> &nodes = field.cell_independent(cell);
  const int *rank = cell_rank[cell].data();
  double *values = matrix.valuePtr();
  const int *start = matrix.outerIndexPtr();
  const unsigned int n = nodes.size();
  for (unsigned int b = 0; b < n; ++b)
    for (unsigned int a = 0; a < n; ++a, ++rank)
    {
      if (*rank < 0)
        continue;
      for (unsigned int d = 0; d < dim; ++d)
      {
        // In the column of direction d the diagonal block holds dim - d entries, every other block dim.
        double *entry =
            values + start[dim * nodes[b] + d] + (*rank == 0 ? 0 : *rank * dim - static_cast<int>(d));
        for (unsigned int e = (*rank == 0 ? d : 0); e < dim; ++e)
          *entry++ += factor * local(dim * a + e, dim * b + d);
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

template void SystemMatrix::reinit<2>(const BodyField<2> &);
template void SystemMatrix::reinit<3>(const BodyField<3> &);
template void SystemMatrix::add_cell<2>(const BodyField<2> &, unsigned int, const Eigen::MatrixXd &, double);
template void SystemMatrix::add_cell<3>(const BodyField<3> &, unsigned int, const Eigen::MatrixXd &, double);
template void SystemMatrix::add_mass<2>(const Eigen::VectorXd &, double);
template void SystemMatrix::add_mass<3>(const Eigen::VectorXd &, double);
} // namespace softgrain::mpm
