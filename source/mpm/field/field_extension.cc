// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/field/field_extension.h>

#include <algorithm>

namespace softgrain::mpm
{
template <int dim>
void FieldExtension<dim>::prolongate(const Eigen::VectorXd &of_independent, Eigen::VectorXd &all) const
{
  all.resize(dim * number.size());
  for (unsigned int j = 0; j < n_independent(); ++j)
    all.template segment<dim>(dim * independent[j]) = of_independent.template segment<dim>(dim * j);
  for (const auto &line : dependent.get_lines())
  {
    Eigen::Matrix<double, dim, 1> value = Eigen::Matrix<double, dim, 1>::Zero();
    for (const auto &[node, weight] : line.entries)
      value += weight * all.template segment<dim>(dim * node);
    all.template segment<dim>(dim * line.index) = value;
  }
}

template <int dim>
void FieldExtension<dim>::restrict(const Eigen::VectorXd &all, Eigen::VectorXd &of_independent) const
{
  of_independent.resize(dim * n_independent());
  for (unsigned int j = 0; j < n_independent(); ++j)
    of_independent.template segment<dim>(dim * j) = all.template segment<dim>(dim * independent[j]);
  for (const auto &line : dependent.get_lines())
    for (const auto &[node, weight] : line.entries)
      of_independent.template segment<dim>(dim * number[node]) +=
          weight * all.template segment<dim>(dim * line.index);
}

template <int dim>
Eigen::VectorXd FieldExtension<dim>::restrict_scalar(const std::vector<double> &all) const
{
  Eigen::VectorXd result(n_independent());
  for (unsigned int j = 0; j < n_independent(); ++j)
    result[j] = all[independent[j]];
  for (const auto &line : dependent.get_lines())
    for (const auto &[node, weight] : line.entries)
      result[number[node]] += weight * all[line.index];
  return result;
}

template <int dim>
NodeWeights
FieldExtension<dim>::combine(const unsigned int *nodes, const double *weights, const unsigned int n) const
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
NodeWeights FieldExtension<dim>::row(const unsigned int i) const
{
  const double one = 1.;
  return combine(&i, &one, 1);
}

template class FieldExtension<2>;
template class FieldExtension<3>;
} // namespace softgrain::mpm
