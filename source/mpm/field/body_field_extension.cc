// SPDX-License-Identifier: LGPL-2.1-or-later
// What BodyField takes from how full its cells are: independent nodes, the extension T, and what follows for
// assembly.
#include <softgrain/linear/dense_kernels.h>
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
} // namespace

template <int dim>
void BodyField<dim>::build_extension(const std::vector<double> &volumes, const double fill_limit)
{
  double cell_volume = 1.;
  for (unsigned int d = 0; d < dim; ++d)
    cell_volume *= lattice->cell_size();
  std::vector<double> fill(own_cells.n(), 0.);
  for (unsigned int p = 0; p < volumes.size(); ++p)
  {
    const unsigned int c = point_cell[p];
    fill[c] += volumes[p] / (cell_volume * std::pow(edge(cell_index[c]), dim));
  }
  // A body too small to fill a cell stands on the fullest it has.
  double limit = fill_limit;
  if (!fill.empty())
    limit = std::min(limit, (1. - 1e-9) * *std::max_element(fill.begin(), fill.end()));

  Index upper = cell_box.lower;
  for (unsigned int d = 0; d < dim; ++d)
    upper[d] += cell_box.size[d] - 1;
  Box strong_cells;
  strong_cells.resize(cell_box.lower, upper, none);
  spreading.number.assign(own_nodes.n(), none);
  for (unsigned int c = 0; c < own_cells.n(); ++c)
    if (fill[c] >= limit)
    {
      strong_cells(cell_index[c]) = c;
      for (const unsigned int k : functions->core())
      {
        // A well-filled cell holds what its hanging nodes hang on as well.
        const unsigned int node = own_cells.node[c * own_cells.per_cell + k];
        if (hanging[node].empty())
          spreading.number[node] = 0;
        for (const auto &[other, weight] : hanging[node])
          spreading.number[other] = 0;
      }
    }
  spreading.independent.clear();
  for (unsigned int i = 0; i < own_nodes.n(); ++i)
    if (spreading.number[i] != none)
    {
      spreading.number[i] = spreading.independent.size();
      spreading.independent.push_back(i);
    }

  spreading.dependent.clear();
  for (unsigned int i = 0; i < own_nodes.n(); ++i)
    if (spreading.number[i] == none)
    {
      spreading.dependent.add_line(i);
      spreading.dependent.add_entries(i, hanging[i].empty() ? extend_node(i, strong_cells) : hanging[i]);
    }
  spreading.dependent.close();
}

template <int dim>
std::vector<typename BodyField<dim>::Index> BodyField<dim>::nearest_cells(const unsigned int node,
                                                                          const Box &of_cells) const
{
  // Distances from the node to the centre of a cell are integers in halves of the distance of two nodes.
  const int per_edge = shape->nodes_per_edge();
  const int shift = static_cast<int>(std::lround(2. * per_edge * shape->node_shift()));
  Index home;
  for (unsigned int d = 0; d < dim; ++d)
    home[d] = static_cast<int>(std::floor(static_cast<double>(node_lattice_index[node][d]) / per_edge));
  const auto distance = [&](const Index &c)
  {
    long sum = 0;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const long x = 2 * (node_lattice_index[node][d] - per_edge * c[d]) + shift - per_edge;
      sum += x * x;
    }
    return sum;
  };
  std::vector<Index> nearest;
  long best = std::numeric_limits<long>::max();
  const int reach = *std::max_element(of_cells.size.begin(), of_cells.size.end()) + 4;
  for (int r = 0; r <= reach; ++r)
  {
    // No cell of this ring can be nearer than 2r - 1 half cells.
    const long least = static_cast<long>(per_edge) * std::max(0, 2 * r - 1);
    if (least * least > best)
      break;
    Index lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
    {
      lower[d] = home[d] - r;
      upper[d] = home[d] + r;
    }
    for_box<dim>(lower, upper,
                 [&](const Index &c)
                 {
                   int ring = 0;
                   for (unsigned int d = 0; d < dim; ++d)
                     ring = std::max(ring, std::abs(c[d] - home[d]));
                   if (ring != r || !of_cells.contains(c) || of_cells(c) == none)
                     return;
                   const long found = distance(c);
                   if (found < best)
                     nearest.clear();
                   if (found <= best)
                     nearest.push_back(c);
                   best = std::min(best, found);
                 });
  }
  return nearest;
}

template <int dim>
typename BodyField<dim>::Entries BodyField<dim>::extend_node(const unsigned int node,
                                                             const Box &strong_cells) const
{
  const std::vector<Index> nearest =
      levels ? nearest_cells_of_levels(node, strong_cells) : nearest_cells(node, strong_cells);
  std::map<unsigned int, double> sum;
  for (const Index &c : nearest)
  {
    dealii::Point<dim> place;
    for (unsigned int d = 0; d < dim; ++d)
      place[d] = static_cast<double>(node_lattice_index[node][d] - first_node(c)[d]) / edge(c);
    for (const unsigned int k : functions->core())
    {
      const double weight = functions->extrapolate(k, place) / nearest.size();
      if (weight != 0.)
        sum[node_box(node_index(c, k))] += weight;
    }
  }
  return Entries(sum.begin(), sum.end());
}

template <int dim>
void BodyField<dim>::build_cell_dependence()
{
  own_cells.dependence.assign(own_cells.n(), {});
  own_cells.is_extended.assign(own_cells.n(), 0);
  own_cells.matrix.assign(dim == 2 ? own_cells.n() : 0, {});
  for (unsigned int c = 0; c < own_cells.n(); ++c)
  {
    const unsigned int *nodes = &own_cells.node[c * own_cells.per_cell];
    std::vector<unsigned int> list;
    bool direct = true;
    for (unsigned int k = 0; k < own_cells.per_cell; ++k)
    {
      direct = direct && !spreading.dependent.is_constrained(nodes[k]);
      spreading.for_entries(nodes[k], [&](const unsigned int j, double) { list.push_back(j); });
    }
    if (!direct)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    own_cells.is_extended[c] = !direct;
    own_cells.dependence[c] = std::move(list);
    own_cells.dependence[c].shrink_to_fit();
    if (dim == 2 && !direct)
    {
      Eigen::MatrixXd &matrix = own_cells.matrix[c];
      matrix.setZero(DenseKernels::filled(own_cells.dependence[c].size()), own_cells.per_cell);
      fill_spread(c, {matrix.data(), matrix.outerStride()});
    }
  }
}

template <int dim>
const std::vector<unsigned int> &BodyField<dim>::places_in_cell(const unsigned int cell) const
{
  // A buffer alone: nothing is read that has not been written for this cell.
  static thread_local std::vector<unsigned int> place;
  if (place.size() < n_independent())
    place.resize(n_independent());
  const std::vector<unsigned int> &list = own_cells.dependence[cell];
  for (unsigned int at = 0; at < list.size(); ++at)
    place[list[at]] = at;
  return place;
}

template <int dim>
void BodyField<dim>::fill_spread(const unsigned int cell, const DenseKernels::Out &matrix) const
{
  const unsigned int *nodes = own_cells.nodes(cell);
  const std::vector<unsigned int> &place = places_in_cell(cell);
  for (unsigned int k = 0; k < own_cells.per_cell; ++k)
    spreading.for_entries(nodes[k], [&](const unsigned int j, const double weight)
                          { *matrix.at(place[j], k) = weight; });
}

template <int dim>
DenseKernels::In BodyField<dim>::spread(const unsigned int cell, std::vector<double> &room) const
{
  if constexpr (dim == 2)
    return {own_cells.matrix[cell].data(), own_cells.matrix[cell].outerStride()};
  const int n_rows = DenseKernels::filled(own_cells.dependence[cell].size());
  room.assign(static_cast<std::size_t>(n_rows) * own_cells.per_cell, 0.);
  fill_spread(cell, {room.data(), n_rows});
  return {room.data(), n_rows};
}

template <int dim>
void BodyField<dim>::color_cells()
{
  own_cells.groups.clear();
  std::vector<std::vector<bool>> used;
  for (unsigned int c = 0; c < own_cells.n(); ++c)
  {
    if (own_cells.point_start[c] == own_cells.point_start[c + 1])
      continue; // nothing to integrate there
    const std::vector<unsigned int> &list = own_cells.dependence[c];
    unsigned int color = 0;
    while (color < own_cells.groups.size() &&
           std::any_of(list.begin(), list.end(), [&](const unsigned int j) { return used[color][j]; }))
      ++color;
    if (color == own_cells.groups.size())
    {
      own_cells.groups.emplace_back();
      used.emplace_back(n_independent(), false);
    }
    own_cells.groups[color].push_back(c);
    for (const unsigned int j : list)
      used[color][j] = true;
  }
}

template void BodyField<2>::build_extension(const std::vector<double> &, double);
template void BodyField<2>::build_cell_dependence();
template const std::vector<unsigned int> &BodyField<2>::places_in_cell(unsigned int) const;
template DenseKernels::In BodyField<2>::spread(unsigned int, std::vector<double> &) const;
template void BodyField<2>::color_cells();
template void BodyField<3>::build_extension(const std::vector<double> &, double);
template void BodyField<3>::build_cell_dependence();
template const std::vector<unsigned int> &BodyField<3>::places_in_cell(unsigned int) const;
template DenseKernels::In BodyField<3>::spread(unsigned int, std::vector<double> &) const;
template void BodyField<3>::color_cells();
} // namespace softgrain::mpm
