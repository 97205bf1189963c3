// SPDX-License-Identifier: LGPL-2.1-or-later
// What BodyField takes from how full its cells are: independent nodes, the extension T, and what follows for
// assembly.
#include <softgrain/mpm/field/body_field.h>
#include <softgrain/mpm/field/lattice_box.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int none = static_cast<unsigned int>(-1);

/// Value at @p x of the Lagrange polynomial over the nodes 0..n-1 that is one at node @p k.
double lagrange(const unsigned int n, const unsigned int k, const int x)
{
  double value = 1.;
  for (int j = 0; j < static_cast<int>(n); ++j)
    if (j != static_cast<int>(k))
      value *= static_cast<double>(x - j) / (static_cast<int>(k) - j);
  return value;
}

/// Nodes of a cell that its points always reach and that carry its polynomial; GIMP's outer ring is reached
/// by points near a face alone, and may have no mass however full the cell is.
std::vector<unsigned int> core_nodes(const ShapeFunction &shape, const int dim)
{
  const unsigned int n = shape.n_nodes(), core = shape.degree() + 1, skipped = (n - core) / 2;
  std::vector<unsigned int> list;
  for (unsigned int k = 0; k < power(n, dim); ++k)
  {
    unsigned int rest = k;
    bool inside = true;
    for (int d = 0; d < dim; ++d, rest /= n)
      inside = inside && rest % n >= skipped && rest % n < skipped + core;
    if (inside)
      list.push_back(k);
  }
  return list;
}

} // namespace

template <int dim>
void BodyField<dim>::build_extension(const std::vector<double> &volumes, const double fill_limit)
{
  double cell_volume = 1.;
  for (unsigned int d = 0; d < dim; ++d)
    cell_volume *= lattice->cell_size();
  std::vector<double> fill(n_cells(), 0.);
  for (unsigned int p = 0; p < volumes.size(); ++p)
    fill[point_cell[p]] += volumes[p] / cell_volume;
  // A body too small to fill a cell stands on the fullest it has.
  double limit = fill_limit;
  if (!fill.empty())
    limit = std::min(limit, (1. - 1e-9) * *std::max_element(fill.begin(), fill.end()));

  Index upper = cell_box.lower;
  for (unsigned int d = 0; d < dim; ++d)
    upper[d] += cell_box.size[d] - 1;
  Box strong_cells;
  strong_cells.resize(cell_box.lower, upper, none);
  std::vector<unsigned int> number(n_nodes(), none);
  for (unsigned int c = 0; c < n_cells(); ++c)
    if (fill[c] >= limit)
    {
      strong_cells(cell_index[c]) = c;
      for (const unsigned int k : core_nodes(*shape, dim))
        number[cell_nodes[c * n_cell_nodes + k]] = 0;
    }
  independent_node.clear();
  for (unsigned int i = 0; i < n_nodes(); ++i)
    if (number[i] != none)
    {
      number[i] = independent_node.size();
      independent_node.push_back(i);
    }

  extension_start.assign(1, 0);
  extension_node.clear();
  extension_weight.clear();
  std::vector<std::pair<unsigned int, double>> row;
  for (unsigned int i = 0; i < n_nodes(); ++i)
  {
    row.clear();
    if (number[i] != none)
      row.emplace_back(i, 1.);
    else
      extend_node(i, strong_cells, row);
    for (const auto &[node, weight] : row)
    {
      extension_node.push_back(number[node]);
      extension_weight.push_back(weight);
    }
    extension_start.push_back(extension_node.size());
  }
}

template <int dim>
void BodyField<dim>::extend_node(const unsigned int node,
                                 const Box &strong_cells,
                                 std::vector<std::pair<unsigned int, double>> &row) const
{
  // Distances are taken twice over, in integers: from the node to the centre of a cell.
  const int twice_shift = static_cast<int>(std::lround(2. * shape->node_shift()));
  const auto distance = [&](const Index &c)
  {
    long sum = 0;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const long x = 2 * (node_lattice_index[node][d] - c[d]) + twice_shift - 1;
      sum += x * x;
    }
    return sum;
  };
  std::vector<Index> nearest;
  long best = std::numeric_limits<long>::max();
  const int reach = *std::max_element(strong_cells.size.begin(), strong_cells.size.end()) + 4;
  for (int r = 0; r <= reach; ++r)
  {
    // No cell of this ring can be nearer than 2r - 1 half cells.
    if (static_cast<long>(std::max(0, 2 * r - 1)) * std::max(0, 2 * r - 1) > best)
      break;
    Index lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
    {
      lower[d] = node_lattice_index[node][d] - r;
      upper[d] = node_lattice_index[node][d] + r;
    }
    for_box<dim>(lower, upper,
                 [&](const Index &c)
                 {
                   int ring = 0;
                   for (unsigned int d = 0; d < dim; ++d)
                     ring = std::max(ring, std::abs(c[d] - node_lattice_index[node][d]));
                   if (ring != r || !strong_cells.contains(c) || strong_cells(c) == none)
                     return;
                   const long found = distance(c);
                   if (found < best)
                     nearest.clear();
                   if (found <= best)
                     nearest.push_back(c);
                   best = std::min(best, found);
                 });
  }

  std::map<unsigned int, double> sum;
  const unsigned int n = shape->n_nodes(), core = shape->degree() + 1, skipped = (n - core) / 2;
  for (const Index &c : nearest)
    for (const unsigned int k : core_nodes(*shape, dim))
    {
      unsigned int rest = k;
      double weight = 1. / nearest.size();
      for (unsigned int d = 0; d < dim; ++d)
      {
        weight *=
            lagrange(core, rest % n - skipped,
                     node_lattice_index[node][d] - c[d] - shape->first_node() - static_cast<int>(skipped));
        rest /= n;
      }
      if (weight != 0.)
        sum[node_box(node_index(c, k))] += weight;
    }
  row.assign(sum.begin(), sum.end());
}

template <int dim>
void BodyField<dim>::build_cell_dependence()
{
  cell_dependence.assign(n_cells(), {});
  cell_matrix.assign(n_cells(), {});
  for (unsigned int c = 0; c < n_cells(); ++c)
  {
    const unsigned int *nodes = &cell_nodes[c * n_cell_nodes];
    std::vector<unsigned int> list;
    bool direct = true;
    for (unsigned int k = 0; k < n_cell_nodes; ++k)
    {
      const unsigned int begin = extension_start[nodes[k]], end = extension_start[nodes[k] + 1];
      direct = direct && end - begin == 1 && independent_node[extension_node[begin]] == nodes[k];
      list.insert(list.end(), extension_node.begin() + begin, extension_node.begin() + end);
    }
    if (!direct)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      cell_matrix[c].setZero(n_cell_nodes, list.size());
      for (unsigned int k = 0; k < n_cell_nodes; ++k)
        for (unsigned int e = extension_start[nodes[k]]; e < extension_start[nodes[k] + 1]; ++e)
          cell_matrix[c](k, std::lower_bound(list.begin(), list.end(), extension_node[e]) - list.begin()) =
              extension_weight[e];
    }
    cell_dependence[c] = std::move(list);
  }
}

template <int dim>
void BodyField<dim>::color_cells()
{
  cell_colors.clear();
  std::vector<std::vector<bool>> used;
  for (unsigned int c = 0; c < n_cells(); ++c)
  {
    if (cell_point_start[c] == cell_point_start[c + 1])
      continue; // nothing to integrate there
    const std::vector<unsigned int> &list = cell_dependence[c];
    unsigned int color = 0;
    while (color < cell_colors.size() &&
           std::any_of(list.begin(), list.end(), [&](const unsigned int j) { return used[color][j]; }))
      ++color;
    if (color == cell_colors.size())
    {
      cell_colors.emplace_back();
      used.emplace_back(n_independent(), false);
    }
    cell_colors[color].push_back(c);
    for (const unsigned int j : list)
      used[color][j] = true;
  }
}

template void BodyField<2>::build_extension(const std::vector<double> &, double);
template void BodyField<2>::build_cell_dependence();
template void BodyField<2>::color_cells();
template void BodyField<3>::build_extension(const std::vector<double> &, double);
template void BodyField<3>::build_cell_dependence();
template void BodyField<3>::color_cells();
} // namespace softgrain::mpm
