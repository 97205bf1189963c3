// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_field_extension_h
#define softgrain_mpm_field_field_extension_h

#include <softgrain/mpm/field/node_weights.h>

#include <deal.II/lac/affine_constraints.h>

#include <Eigen/Core>

#include <vector>

namespace softgrain::mpm
{
template <int>
class BodyField;

/**
 * @brief T of u = T q: values at all nodes of a body from those at its independent ones.
 *
 * It is an AffineConstraints of deal.II over the nodes, the same for every component. Vectors hold dim
 * components per node.
 */
template <int dim>
class FieldExtension
{
public:
  unsigned int n_independent() const { return independent.size(); }
  /// Node of independent node @p j.
  unsigned int node(const unsigned int j) const { return independent[j]; }

  /// T q: values at all nodes from those at the independent nodes.
  void prolongate(const Eigen::VectorXd &of_independent, Eigen::VectorXd &all) const;
  /// T^T f: forces at all nodes moved to the independent ones.
  void restrict(const Eigen::VectorXd &all, Eigen::VectorXd &of_independent) const;
  /// T^T m for one scalar per node.
  Eigen::VectorXd restrict_scalar(const std::vector<double> &all) const;

  /// A constraint for every node that is not independent, on nodes that are.
  const dealii::AffineConstraints<double> &constraints() const { return dependent; }
  /// Row of node @p i, in terms of independent nodes.
  NodeWeights row(unsigned int i) const;
  /// The sum of the rows of @p n nodes, each times its weight.
  NodeWeights combine(const unsigned int *nodes, const double *weights, unsigned int n) const;

private:
  friend class BodyField<dim>;
  /// Calls f(independent node, weight) for the entries of row @p i.
  template <class F>
  void for_entries(const unsigned int i, const F &f) const
  {
    const auto *entries = dependent.get_constraint_entries(i);
    if (entries == nullptr)
      f(number[i], 1.);
    else
      for (const auto &[other, weight] : *entries)
        f(number[other], weight);
  }

  std::vector<unsigned int> independent;
  std::vector<unsigned int> number;            ///< of every node; of those that depend on others: none
  dealii::AffineConstraints<double> dependent; ///< T without the rows of independent nodes
};
} // namespace softgrain::mpm

#endif
