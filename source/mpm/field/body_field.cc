// SPDX-License-Identifier: LGPL-2.1-or-later
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
  own_cells.per_cell = functions->n();
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
  own_cells.point_start.assign(cell_index.size() + 1, 0);
  for (unsigned int p = 0; p < of_point.size(); ++p)
  {
    point_cell[p] = cell_box(of_point[p]);
    ++own_cells.point_start[point_cell[p] + 1];
  }
  for (unsigned int c = 0; c < cell_index.size(); ++c)
    own_cells.point_start[c + 1] += own_cells.point_start[c];
}

template <int dim>
void BodyField<dim>::number_nodes()
{
  Index lower = node_index(cell_index[0], 0), upper = lower;
  for (const Index &c : cell_index)
    for (unsigned int d = 0; d < dim; ++d)
    {
      lower[d] = std::min(lower[d], node_index(c, 0)[d]);
      upper[d] = std::max(upper[d], node_index(c, own_cells.per_cell - 1)[d]);
    }
  node_box.resize(lower, upper, none);
  for (const Index &c : cell_index)
    for (unsigned int k = 0; k < own_cells.per_cell; ++k)
      node_box(node_index(c, k)) = 0;
  node_lattice_index.clear();
  own_nodes.place.clear();
  own_nodes.number.clear();
  const int per_edge = shape->nodes_per_edge();
  for_box<dim>(lower, upper,
               [&](const Index &i)
               {
                 if (node_box(i) == none)
                   return;
                 node_box(i) = own_nodes.place.size();
                 dealii::Point<dim> x;
                 std::int64_t number = 0;
                 for (int d = dim - 1; d >= 0; --d)
                 {
                   x[d] = lattice->lower()[d] +
                          lattice->cell_size() * (static_cast<double>(i[d]) / per_edge + shape->node_shift());
                   number = number * (lattice->n_cells()[d] * per_edge + 8) + (i[d] + 4);
                 }
                 own_nodes.place.push_back(x);
                 node_lattice_index.push_back(i);
                 own_nodes.number.push_back(number);
               });
  own_cells.node.resize(cell_index.size() * own_cells.per_cell);
  for (unsigned int c = 0; c < cell_index.size(); ++c)
    for (unsigned int k = 0; k < own_cells.per_cell; ++k)
      own_cells.node[c * own_cells.per_cell + k] = node_box(node_index(cell_index[c], k));

  own_cells.place_start.assign(own_nodes.place.size() + 1, 0);
  for (const unsigned int i : own_cells.node)
    ++own_cells.place_start[i + 1];
  for (unsigned int i = 0; i < own_nodes.place.size(); ++i)
    own_cells.place_start[i + 1] += own_cells.place_start[i];
  std::vector<unsigned int> next(own_cells.place_start.begin(), own_cells.place_start.end() - 1);
  own_cells.place_of_node.resize(own_cells.node.size());
  for (unsigned int e = 0; e < own_cells.node.size(); ++e)
    own_cells.place_of_node[next[own_cells.node[e]]++] = e;
}

template <int dim>
void BodyField<dim>::evaluate_points(const Places &places)
{
  const std::size_t n = places.points.size();
  point_values.resize(n * own_cells.per_cell);
  point_slopes.resize(n * own_cells.per_cell);
  std::vector<double> values(own_cells.per_cell);
  std::vector<dealii::Tensor<1, dim>> slopes(own_cells.per_cell);
  for (unsigned int p = 0; p < n; ++p)
  {
    const Index &c = cell_index[point_cell[p]];
    const double h = lattice->cell_size() * edge(c);
    functions->evaluate(unit_position(places.points[p], c),
                        places.half_extent.empty() ? 0. : places.half_extent[p] / h, values, slopes);
    std::copy(values.begin(), values.end(), &point_values[p * own_cells.per_cell]);
    for (unsigned int k = 0; k < own_cells.per_cell; ++k)
      point_slopes[p * own_cells.per_cell + k] = slopes[k] / h;
  }
}

template <int dim>
NodeWeights BodyField<dim>::weights_at(const dealii::Point<dim> &x) const
{
  const Index c = home(lattice->cell_of(x));
  if (!cell_box.contains(c) || cell_box(c) == none)
    return {};
  std::vector<double> weights(own_cells.per_cell);
  std::vector<dealii::Tensor<1, dim>> no_slopes;
  functions->evaluate(unit_position(x, c), 0., weights, no_slopes);
  return spreading.combine(&own_cells.node[cell_box(c) * own_cells.per_cell], weights.data(),
                           own_cells.per_cell);
}

template class BodyField<2>;
template class BodyField<3>;
} // namespace softgrain::mpm
