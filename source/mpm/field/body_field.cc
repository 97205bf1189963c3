// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/field/body_field.h>
#include <softgrain/mpm/field/lattice_box.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int none = static_cast<unsigned int>(-1);

} // namespace

template <int dim>
void BodyField<dim>::Box::resize(const Index &lower_corner,
                                 const Index &upper_corner,
                                 const unsigned int fill)
{
  lower = lower_corner;
  std::size_t total = 1;
  for (unsigned int d = 0; d < dim; ++d)
  {
    size[d] = upper_corner[d] - lower_corner[d] + 1;
    total *= size[d];
  }
  id.assign(total, fill);
}

template <int dim>
bool BodyField<dim>::Box::contains(const Index &i) const
{
  for (unsigned int d = 0; d < dim; ++d)
    if (i[d] < lower[d] || i[d] >= lower[d] + size[d])
      return false;
  return true;
}

template <int dim>
unsigned int &BodyField<dim>::Box::operator()(const Index &i)
{
  std::size_t offset = 0;
  for (int d = dim - 1; d >= 0; --d)
    offset = offset * size[d] + (i[d] - lower[d]);
  return id[offset];
}

template <int dim>
unsigned int BodyField<dim>::Box::operator()(const Index &i) const
{
  return const_cast<Box &>(*this)(i);
}

template <int dim>
typename BodyField<dim>::Index BodyField<dim>::first_node(const Index &cell) const
{
  Index i;
  for (unsigned int d = 0; d < dim; ++d)
    i[d] = cell[d] * static_cast<int>(shape->nodes_per_edge()) + shape->first_node();
  return i;
}

template <int dim>
typename BodyField<dim>::Index BodyField<dim>::node_index(const Index &cell, const unsigned int k) const
{
  Index i = first_node(cell);
  for (unsigned int d = 0; d < dim; ++d)
    i[d] += edge(cell) * functions->offset(k)[d];
  return i;
}

template <int dim>
void BodyField<dim>::stand_on(const Lattice<dim> &the_lattice,
                              const ShapeFunction &the_shape,
                              const CellLevels<dim> *the_levels)
{
  lattice = &the_lattice;
  if (shape != &the_shape)
    functions = std::make_shared<const CellFunctions<dim>>(the_shape);
  shape = &the_shape;
  n_cell_nodes = functions->n();
  levels = the_levels;
}

template <int dim>
void BodyField<dim>::build(const Lattice<dim> &the_lattice,
                           const ShapeFunction &the_shape,
                           const Places &places,
                           const double fill_limit)
{
  stand_on(the_lattice, the_shape, places.levels);
  collect_cells(places);
  number_nodes();
  hang_nodes();
  evaluate_points(places);
  build_extension(places.volumes, fill_limit);
  build_cell_dependence();
  transpose_cells();
  color_cells();
  marker_rows.clear();
  for (const dealii::Point<dim> &marker : places.markers)
  {
    const NodeWeights weights = weights_at(marker);
    marker_rows.add(weights.node.data(), weights.weight.data(), weights.node.size());
  }
  marker_rows.finish();
}

template <int dim>
void BodyField<dim>::collect_cells(const Places &places)
{
  std::vector<Index> of_point, of_marker;
  Index lower, upper;
  lower.fill(std::numeric_limits<int>::max());
  upper.fill(std::numeric_limits<int>::min());
  const auto find =
      [&](const std::vector<dealii::Point<dim>> &places_of_kind, std::vector<Index> &cells, const char *kind)
  {
    cells.reserve(places_of_kind.size());
    for (const dealii::Point<dim> &x : places_of_kind)
    {
      lattice->check_inside(x, kind);
      const Index c = home(lattice->cell_of(x));
      for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = std::min(lower[d], c[d]);
        upper[d] = std::max(upper[d], c[d]);
      }
      cells.push_back(c);
    }
  };
  find(places.points, of_point, "material point");
  find(places.markers, of_marker, "boundary marker");

  // Cells in the order of the lattice, whatever the order of the points: neighbours stay near in memory.
  cell_box.resize(lower, upper, none);
  for (const auto *list : {&of_point, &of_marker})
    for (const Index &c : *list)
      cell_box(c) = 0;
  cell_index.clear();
  for_box<dim>(lower, upper,
               [&](const Index &c)
               {
                 if (cell_box(c) != none)
                 {
                   cell_box(c) = cell_index.size();
                   cell_index.push_back(c);
                 }
               });

  point_cell.resize(of_point.size());
  cell_point_start.assign(cell_index.size() + 1, 0);
  for (unsigned int p = 0; p < of_point.size(); ++p)
  {
    point_cell[p] = cell_box(of_point[p]);
    ++cell_point_start[point_cell[p] + 1];
  }
  for (unsigned int c = 0; c < cell_index.size(); ++c)
    cell_point_start[c + 1] += cell_point_start[c];
}

template <int dim>
void BodyField<dim>::number_nodes()
{
  Index lower = node_index(cell_index[0], 0), upper = lower;
  for (const Index &c : cell_index)
    for (unsigned int d = 0; d < dim; ++d)
    {
      lower[d] = std::min(lower[d], node_index(c, 0)[d]);
      upper[d] = std::max(upper[d], node_index(c, n_cell_nodes - 1)[d]);
    }
  node_box.resize(lower, upper, none);
  for (const Index &c : cell_index)
    for (unsigned int k = 0; k < n_cell_nodes; ++k)
      node_box(node_index(c, k)) = 0;
  node_lattice_index.clear();
  node_position.clear();
  lattice_number.clear();
  const int per_edge = shape->nodes_per_edge();
  for_box<dim>(lower, upper,
               [&](const Index &i)
               {
                 if (node_box(i) == none)
                   return;
                 node_box(i) = node_position.size();
                 dealii::Point<dim> x;
                 std::int64_t number = 0;
                 for (int d = dim - 1; d >= 0; --d)
                 {
                   x[d] = lattice->lower()[d] +
                          lattice->cell_size() * (static_cast<double>(i[d]) / per_edge + shape->node_shift());
                   number = number * (lattice->n_cells()[d] * per_edge + 8) + (i[d] + 4);
                 }
                 node_position.push_back(x);
                 node_lattice_index.push_back(i);
                 lattice_number.push_back(number);
               });
  cell_nodes.resize(cell_index.size() * n_cell_nodes);
  for (unsigned int c = 0; c < cell_index.size(); ++c)
    for (unsigned int k = 0; k < n_cell_nodes; ++k)
      cell_nodes[c * n_cell_nodes + k] = node_box(node_index(cell_index[c], k));

  node_cell_start.assign(node_position.size() + 1, 0);
  for (const unsigned int i : cell_nodes)
    ++node_cell_start[i + 1];
  for (unsigned int i = 0; i < node_position.size(); ++i)
    node_cell_start[i + 1] += node_cell_start[i];
  std::vector<unsigned int> next(node_cell_start.begin(), node_cell_start.end() - 1);
  node_cell.resize(cell_nodes.size());
  for (unsigned int e = 0; e < cell_nodes.size(); ++e)
    node_cell[next[cell_nodes[e]]++] = e;
}

template <int dim>
void BodyField<dim>::evaluate_points(const Places &places)
{
  const std::size_t n = places.points.size();
  point_values.resize(n * n_cell_nodes);
  point_slopes.resize(n * n_cell_nodes);
  std::vector<double> values(n_cell_nodes);
  std::vector<dealii::Tensor<1, dim>> slopes(n_cell_nodes);
  for (unsigned int p = 0; p < n; ++p)
  {
    const Index &c = cell_index[point_cell[p]];
    const double h = lattice->cell_size() * edge(c);
    functions->evaluate(unit_position(places.points[p], c),
                        places.half_extent.empty() ? 0. : places.half_extent[p] / h, values, slopes);
    std::copy(values.begin(), values.end(), &point_values[p * n_cell_nodes]);
    for (unsigned int k = 0; k < n_cell_nodes; ++k)
      point_slopes[p * n_cell_nodes + k] = slopes[k] / h;
  }
}

template <int dim>
void BodyField<dim>::gather(const std::vector<double> &of_cells, Eigen::VectorXd &all) const
{
  all.resize(dim * n_nodes());
  parallel_for(n_nodes(), 1024,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                 {
                   double sum[dim] = {};
                   for (unsigned int e = node_cell_start[i]; e < node_cell_start[i + 1]; ++e)
                     for (unsigned int d = 0; d < dim; ++d)
                       sum[d] += of_cells[dim * node_cell[e] + d];
                   for (unsigned int d = 0; d < dim; ++d)
                     all[dim * i + d] = sum[d];
                 }
               });
}

template <int dim>
void BodyField<dim>::prolongate(const Eigen::VectorXd &independent, Eigen::VectorXd &all) const
{
  all.resize(dim * n_nodes());
  for (unsigned int j = 0; j < n_independent(); ++j)
    all.template segment<dim>(dim * independent_node[j]) = independent.template segment<dim>(dim * j);
  for (const auto &line : dependent.get_lines())
  {
    Eigen::Matrix<double, dim, 1> value = Eigen::Matrix<double, dim, 1>::Zero();
    for (const auto &[node, weight] : line.entries)
      value += weight * all.template segment<dim>(dim * node);
    all.template segment<dim>(dim * line.index) = value;
  }
}

template <int dim>
void BodyField<dim>::restrict(const Eigen::VectorXd &all, Eigen::VectorXd &independent) const
{
  independent.resize(n_dofs());
  for (unsigned int j = 0; j < n_independent(); ++j)
    independent.template segment<dim>(dim * j) = all.template segment<dim>(dim * independent_node[j]);
  for (const auto &line : dependent.get_lines())
    for (const auto &[node, weight] : line.entries)
      independent.template segment<dim>(dim * independent_number[node]) +=
          weight * all.template segment<dim>(dim * line.index);
}

template <int dim>
Eigen::VectorXd BodyField<dim>::restrict_scalar(const std::vector<double> &all) const
{
  Eigen::VectorXd result(n_independent());
  for (unsigned int j = 0; j < n_independent(); ++j)
    result[j] = all[independent_node[j]];
  for (const auto &line : dependent.get_lines())
    for (const auto &[node, weight] : line.entries)
      result[independent_number[node]] += weight * all[line.index];
  return result;
}

template <int dim>
NodeWeights
BodyField<dim>::combine(const unsigned int *nodes, const double *weights, const unsigned int n) const
{
  NodeWeights result;
  const auto add = [&](const unsigned int node, const double weight)
  {
    const auto place = std::lower_bound(result.node.begin(), result.node.end(), node);
    const auto weight_place = result.weight.begin() + (place - result.node.begin());
    if (place != result.node.end() && *place == node)
      *weight_place += weight;
    else
    {
      result.node.insert(place, node);
      result.weight.insert(weight_place, weight);
    }
  };
  for (unsigned int k = 0; k < n; ++k)
    if (weights[k] != 0.)
      for_entries(nodes[k], [&](const unsigned int j, const double weight) { add(j, weights[k] * weight); });
  return result;
}

template <int dim>
NodeWeights BodyField<dim>::extension(const unsigned int node) const
{
  const double one = 1.;
  return combine(&node, &one, 1);
}

template <int dim>
NodeWeights BodyField<dim>::weights_at(const dealii::Point<dim> &x) const
{
  const Index c = home(lattice->cell_of(x));
  if (!cell_box.contains(c) || cell_box(c) == none)
    return {};
  std::vector<double> weights(n_cell_nodes);
  std::vector<dealii::Tensor<1, dim>> no_slopes;
  functions->evaluate(unit_position(x, c), 0., weights, no_slopes);
  return combine(&cell_nodes[cell_box(c) * n_cell_nodes], weights.data(), n_cell_nodes);
}

template class BodyField<2>;
template class BodyField<3>;
} // namespace softgrain::mpm
