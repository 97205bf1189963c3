// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/nodal_resistance.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
/// Share up to which a step resists by masses. In space steps that begin without a minimum are frequent, and
/// each rise in vain takes a factorisation.
template <int dim>
constexpr double calm = dim == 2 ? 1e-2 : 1e-4;

/// Sum over the nodes of what resists each of them times @p measure of its way in @p u.
template <int dim, class Measure>
double weighted_sum(const Eigen::VectorXd &of_node, const Eigen::VectorXd &u, const Measure &measure)
{
  double result = 0.;
  for (unsigned int i = 0; i < of_node.size(); ++i)
    result += of_node[i] * measure(u.segment<dim>(dim * i));
  return result;
}
} // namespace

template <int dim>
NodalResistance<dim>::NodalResistance(const Eigen::VectorXd &mass, const double share, const double whole)
    : by_mass(whole / mass.sum() * mass.cwiseAbs())
    , alike(whole / mass.size())
    , share(share)
    , of_node(at(share))
{
}

template <int dim>
Eigen::VectorXd NodalResistance<dim>::at(const double that_share) const
{
  return (std::min(that_share, calm<dim>) * by_mass).array() + std::max(0., that_share - calm<dim>) * alike;
}

template <int dim>
void NodalResistance<dim>::subtract(const Eigen::VectorXd &v, Eigen::VectorXd &missing) const
{
  for (unsigned int i = 0; i < of_node.size(); ++i)
    missing.segment<dim>(dim * i) -= of_node[i] * v.segment<dim>(dim * i);
}

template <int dim>
void NodalResistance<dim>::rise(const double factor,
                                const Eigen::VectorXd &v,
                                Eigen::VectorXd &missing,
                                SystemMatrix *const matrix)
{
  const Eigen::VectorXd before = of_node;
  share *= factor;
  of_node = at(share) - before; // what is added
  subtract(v, missing);
  if (matrix != nullptr)
    add_to(*matrix);
  of_node += before;
}

template <int dim>
double NodalResistance<dim>::amounts(const Eigen::VectorXd &u) const
{
  return weighted_sum<dim>(of_node, u, [](const auto &way) { return way.norm(); });
}

template <int dim>
dealii::Tensor<1, dim> NodalResistance<dim>::sum(const Eigen::VectorXd &u) const
{
  dealii::Tensor<1, dim> result;
  for (unsigned int i = 0; i < of_node.size(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      result[d] += of_node[i] * u[dim * i + d];
  return result;
}

template <int dim>
double NodalResistance<dim>::times_way(const Eigen::VectorXd &u) const
{
  return weighted_sum<dim>(of_node, u, [](const auto &way) { return way.squaredNorm(); });
}

template class NodalResistance<2>;
template class NodalResistance<3>;
} // namespace softgrain::mpm
