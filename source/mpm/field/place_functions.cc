// SPDX-License-Identifier: LGPL-2.1-or-later
// The field of a body at any place, with derivatives.
#include <softgrain/mpm/field/body_field.h>
#include <softgrain/mpm/field/field_near.h>
#include <softgrain/mpm/field/place_functions.h>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int none = static_cast<unsigned int>(-1);
} // namespace

template <int dim>
std::optional<typename BodyField<dim>::Index> BodyField<dim>::cell_near(const dealii::Point<dim> &x) const
{
  const double little = 0.01 * lattice->cell_size();
  // Straight beside it first, then across corners.
  for (unsigned int most = 0; most <= dim; ++most)
    for (unsigned int code = 0; code < (dim == 2 ? 9u : 27u); ++code)
    {
      dealii::Point<dim> y = x;
      unsigned int n_moved = 0;
      for (unsigned int d = 0, rest = code; d < dim; ++d, rest /= 3)
      {
        y[d] += (rest % 3 == 1 ? -1. : rest % 3 == 2 ? 1. : 0.) * little;
        n_moved += rest % 3 != 0;
      }
      if (n_moved != most)
        continue;
      const Index c = home(lattice->cell_of(y));
      if (cell_box.contains(c) && cell_box(c) != none)
        return c;
    }
  return std::nullopt;
}

template <int dim>
PlaceFunctions<dim> BodyField<dim>::functions_at(const dealii::Point<dim> &x) const
{
  PlaceFunctions<dim> result;
  const std::optional<Index> near = cell_near(x);
  if (!near)
    return result;
  const Index &c = *near;
  const unsigned int cell = cell_box(c);
  const double edge_length = edge(c) * lattice->cell_size();
  const auto factors = functions->factors(unit_position(x, c));
  const std::vector<unsigned int> &independent = own_cells.dependence[cell];
  result.cell = cell;
  result.node.assign(independent.begin(), independent.end());
  result.value.assign(result.node.size(), 0.);
  result.slope.assign(result.node.size(), dealii::Tensor<1, dim>());
  const bool extended = own_cells.extended(cell);
  const std::vector<unsigned int> *const place = extended ? &places_in_cell(cell) : nullptr;
  for (unsigned int k = 0; k < own_cells.per_cell; ++k)
  {
    const auto &offset = functions->offset(k);
    double value = 1.;
    dealii::Tensor<1, dim> slope;
    for (unsigned int d = 0; d < dim; ++d)
    {
      value *= factors[d][0][offset[d]];
      slope[d] = 1. / edge_length;
      for (unsigned int e = 0; e < dim; ++e)
        slope[d] *= factors[e][d == e ? 1 : 0][offset[e]];
    }
    if (!extended)
    {
      result.value[k] = value;
      result.slope[k] = slope;
      continue;
    }
    spreading.for_entries(own_cells.nodes(cell)[k],
                          [&](const unsigned int j, const double weight)
                          {
                            result.value[(*place)[j]] += weight * value;
                            result.slope[(*place)[j]] += weight * slope;
                          });
  }
  return result;
}

template <int dim>
bool FieldNear<dim>::look_at(const dealii::Point<dim> &x)
{
  const auto found = field.cell_near(x);
  if (!found)
    return false;
  const auto &c = *found;
  const auto &functions = *field.functions;
  if (const unsigned int there = field.cell_box(c); there != cell)
  {
    cell = there;
    const std::vector<unsigned int> &independent = field.own_cells.independent(cell);
    // A buffer alone: nothing is read that has not been written for this cell.
    static thread_local std::vector<double> room;
    const bool extended = field.own_cells.extended(cell);
    const DenseKernels::In spread = extended ? field.spread(cell, room) : DenseKernels::In();
    node.assign(field.own_cells.nodes_per_cell(), Vector());
    for (unsigned int k = 0; k < node.size(); ++k)
      if (!extended)
        node[k] = PlaceFunctions<dim>::of_node(nodal, independent[k]);
      else
        for (unsigned int at = 0; at < independent.size(); ++at)
          node[k] += *spread.at(at, k) * PlaceFunctions<dim>::of_node(nodal, independent[at]);
  }
  edge_length = field.edge(c) * field.lattice->cell_size();
  factors = functions.factors(field.unit_position(x, c));
  value = Vector();
  slope = {};
  for (unsigned int k = 0; k < node.size(); ++k)
  {
    const auto &offset = functions.offset(k);
    double here = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      here *= factors[d][0][offset[d]];
    value += here * node[k];
    for (unsigned int d = 0; d < dim; ++d)
    {
      double by_d = 1. / edge_length;
      for (unsigned int f = 0; f < dim; ++f)
        by_d *= factors[f][d == f ? 1 : 0][offset[f]];
      slope[d] += by_d * node[k];
    }
  }
  return true;
}

template <int dim>
void FieldNear<dim>::find_curvature()
{
  const auto &functions = *field.functions;
  curvature = {};
  for (unsigned int k = 0; k < node.size(); ++k)
  {
    const auto &offset = functions.offset(k);
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e <= d; ++e)
      {
        double by_both = 1. / (edge_length * edge_length);
        for (unsigned int f = 0; f < dim; ++f)
          by_both *= factors[f][(d == f ? 1 : 0) + (e == f ? 1 : 0)][offset[f]];
        curvature[d][e] += by_both * node[k];
      }
  }
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int e = d + 1; e < dim; ++e)
      curvature[d][e] = curvature[e][d];
}

template PlaceFunctions<2> BodyField<2>::functions_at(const dealii::Point<2> &) const;
template PlaceFunctions<3> BodyField<3>::functions_at(const dealii::Point<3> &) const;
template class FieldNear<2>;
template class FieldNear<3>;
} // namespace softgrain::mpm
