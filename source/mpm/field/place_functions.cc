// SPDX-License-Identifier: LGPL-2.1-or-later
// The field of a body at any place, with derivatives.
#include <softgrain/mpm/field/body_field.h>
#include <softgrain/mpm/field/place_functions.h>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int none = static_cast<unsigned int>(-1);
} // namespace

template <int dim>
PlaceFunctions<dim> BodyField<dim>::functions_at(const dealii::Point<dim> &x) const
{
  PlaceFunctions<dim> result;
  const Index c = home(lattice->cell_of(x));
  if (!cell_box.contains(c) || cell_box(c) == none)
    return result;
  std::vector<double> values(n_cell_nodes);
  std::vector<dealii::Tensor<1, dim>> slopes(n_cell_nodes);
  std::vector<dealii::Tensor<2, dim>> curvatures(n_cell_nodes);
  functions->evaluate(unit_position(x, c), values, slopes, curvatures);
  const unsigned int cell = cell_box(c);
  const double edge_length = edge(c) * lattice->cell_size();
  result.cell = cell;
  result.node = cell_dependence[cell];
  result.value.assign(result.node.size(), 0.);
  result.slope.resize(result.node.size());
  result.curvature.resize(result.node.size());
  const Eigen::MatrixXd &spread = cell_matrix[cell]; // from independent nodes to those of the cell
  const auto add = [&](const unsigned int at, const unsigned int k, const double weight)
  {
    result.value[at] += weight * values[k];
    result.slope[at] += weight / edge_length * slopes[k];
    result.curvature[at] += weight / (edge_length * edge_length) * curvatures[k];
  };
  for (unsigned int k = 0; k < n_cell_nodes; ++k)
    if (spread.size() == 0)
      add(k, k, 1.);
    else
      for (unsigned int at = 0; at < result.node.size(); ++at)
        add(at, k, spread(k, at));
  return result;
}

template PlaceFunctions<2> BodyField<2>::functions_at(const dealii::Point<2> &) const;
template PlaceFunctions<3> BodyField<3>::functions_at(const dealii::Point<3> &) const;
} // namespace softgrain::mpm
