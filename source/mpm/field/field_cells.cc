// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/field/field_cells.h>

#include <cstddef>

namespace softgrain::mpm
{
template <int dim>
void FieldCells<dim>::gather(const std::vector<double> &of_cells, Eigen::VectorXd &all) const
{
  const std::size_t n_nodes = place_start.size() - 1;
  all.resize(dim * n_nodes);
  parallel_for(n_nodes, 1024,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                 {
                   double sum[dim] = {};
                   for (unsigned int e = place_start[i]; e < place_start[i + 1]; ++e)
                     for (unsigned int d = 0; d < dim; ++d)
                       sum[d] += of_cells[dim * place_of_node[e] + d];
                   for (unsigned int d = 0; d < dim; ++d)
                     all[dim * i + d] = sum[d];
                 }
               });
}

template class FieldCells<2>;
template class FieldCells<3>;
} // namespace softgrain::mpm
