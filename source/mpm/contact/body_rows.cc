// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/body_rows.h>

#include <map>

namespace softgrain::mpm
{
namespace
{
/// The next column of @p matrix: @p weights times @p direction.
template <int dim>
void add_column(const NodeWeights &weights,
                const dealii::Tensor<1, dim> &direction,
                const unsigned int column,
                LinearSolver::Rows &matrix)
{
  matrix.startVec(column);
  for (unsigned int k = 0; k < weights.node.size(); ++k)
    for (unsigned int d = 0; d < dim; ++d)
      if (direction[d] != 0.)
        matrix.insertBack(dim * weights.node[k] + d, column) = weights.weight[k] * direction[d];
}

/// The next column of @p matrix, of a body that meets itself: what both places do.
template <int dim>
void add_column_of_both(const ContactRow<dim> &row,
                        const dealii::Tensor<1, dim> &direction,
                        const unsigned int column,
                        LinearSolver::Rows &matrix)
{
  std::map<unsigned int, double> sum;
  for (unsigned int k = 0; k < row.weights.body->node.size(); ++k)
    sum[row.weights.body->node[k]] += row.weights.body->weight[k];
  for (unsigned int k = 0; k < row.weights.partner->node.size(); ++k)
    sum[row.weights.partner->node[k]] -= row.weights.partner->weight[k];
  matrix.startVec(column);
  for (const auto &[node, weight] : sum)
    for (unsigned int d = 0; d < dim; ++d)
      matrix.insertBack(dim * node + d, column) = weight * direction[d];
}
} // namespace

template <int dim>
void BodyRows<dim>::reinit(const Body<dim> &body,
                           const std::vector<ContactRow<dim>> &rows,
                           const std::vector<unsigned int> &of_body,
                           const unsigned int n_components)
{
  matrix.resize(body.field.n_dofs(), of_body.size());
  for (unsigned int k = 0; k < of_body.size(); ++k)
  {
    const ContactRow<dim> &row = rows[of_body[k] / n_components];
    const bool own = row.body == body.index;
    const dealii::Tensor<1, dim> direction = (own ? 1. : -1.) * direction_of(row, of_body[k] % n_components);
    if (row.partner == row.body)
      add_column_of_both<dim>(row, direction, k, matrix);
    else
      add_column<dim>(own ? *row.weights.body : *row.weights.partner, direction, k, matrix);
  }
  matrix.finalize();
}

template class BodyRows<2>;
template class BodyRows<3>;
} // namespace softgrain::mpm
