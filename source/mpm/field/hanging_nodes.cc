// SPDX-License-Identifier: LGPL-2.1-or-later
// What BodyField does where its cells have different sizes.
#include <softgrain/mpm/field/body_field.h>
#include <softgrain/mpm/field/lattice_box.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int none = static_cast<unsigned int>(-1);
}

template <int dim>
void BodyField<dim>::hang_nodes()
{
  hanging.assign(own_nodes.n(), {});
  if (levels == nullptr)
    return;
  const int per_edge = shape->nodes_per_edge();
  std::vector<double> values(own_cells.per_cell);
  std::vector<dealii::Tensor<1, dim>> no_slopes;
  for (unsigned int c = 0; c < own_cells.n(); ++c)
  {
    const int size = edge(cell_index[c]);
    if (size == 1)
      continue; // nothing is smaller
    const Index first = node_index(cell_index[c], 0),
                last = node_index(cell_index[c], own_cells.per_cell - 1);
    for_box<dim>(
        first, last,
        [&](const Index &i)
        {
          if (node_box(i) == none || !hanging[node_box(i)].empty())
            return;
          dealii::Point<dim> place;
          bool own = true;
          for (unsigned int d = 0; d < dim; ++d)
          {
            own = own && (i[d] - first[d]) % size == 0;
            place[d] = static_cast<double>(i[d] - first[d]) / (per_edge * size);
          }
          if (own)
            return;
          functions->evaluate(place, 0., values, no_slopes);
          for (unsigned int k = 0; k < own_cells.per_cell; ++k)
            if (std::abs(values[k]) > 1e-12) // functions of nodes off this face vanish but for rounding
              hanging[node_box(i)].emplace_back(own_cells.node[c * own_cells.per_cell + k], values[k]);
        });
  }
}

template <int dim>
std::vector<typename BodyField<dim>::Index> BodyField<dim>::nearest_cells_of_levels(const unsigned int node,
                                                                                    const Box &of_cells) const
{
  // By the distance in edges of the cell, which is what spoils an extrapolation.
  std::vector<Index> nearest;
  double best = std::numeric_limits<double>::max();
  for (const Index &c : cell_index)
  {
    if (of_cells(c) == none)
      continue;
    double distance = 0.;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double nodes = node_lattice_index[node][d] - first_node(c)[d];
      distance += std::pow(nodes / (shape->nodes_per_edge() * edge(c)) - 0.5, 2);
    }
    if (distance < best - 1e-9)
      nearest.clear();
    if (distance < best + 1e-9)
      nearest.push_back(c);
    best = std::min(best, distance);
  }
  return nearest;
}

template void BodyField<2>::hang_nodes();
template std::vector<BodyField<2>::Index> BodyField<2>::nearest_cells_of_levels(unsigned int,
                                                                                const Box &) const;
template void BodyField<3>::hang_nodes();
template std::vector<BodyField<3>::Index> BodyField<3>::nearest_cells_of_levels(unsigned int,
                                                                                const Box &) const;
} // namespace softgrain::mpm
