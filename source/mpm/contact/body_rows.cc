// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/body_rows.h>

#include <algorithm>
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
  for (unsigned int k = 0; k < row.body_weights->node.size(); ++k)
    sum[row.body_weights->node[k]] += row.body_weights->weight[k];
  for (unsigned int k = 0; k < row.partner_weights->node.size(); ++k)
    sum[row.partner_weights->node[k]] -= row.partner_weights->weight[k];
  matrix.startVec(column);
  for (const auto &[node, weight] : sum)
    for (unsigned int d = 0; d < dim; ++d)
      matrix.insertBack(dim * node + d, column) = weight * direction[d];
}

/// The next column of @p matrix: both weights, each times its direction.
template <int dim>
void add_column(const NodeWeights &a,
                const dealii::Tensor<1, dim> &direction_of_a,
                const NodeWeights &b,
                const dealii::Tensor<1, dim> &direction_of_b,
                const unsigned int column,
                LinearSolver::Rows &matrix)
{
  matrix.startVec(column);
  for (unsigned int i = 0, j = 0; i < a.node.size() || j < b.node.size();)
  {
    const unsigned int node =
        std::min(i < a.node.size() ? a.node[i] : b.node[j], j < b.node.size() ? b.node[j] : a.node[i]);
    dealii::Tensor<1, dim> value;
    if (i < a.node.size() && a.node[i] == node)
      value += a.weight[i++] * direction_of_a;
    if (j < b.node.size() && b.node[j] == node)
      value += b.weight[j++] * direction_of_b;
    for (unsigned int d = 0; d < dim; ++d)
      matrix.insertBack(dim * node + d, column) = value[d];
  }
}
} // namespace

template <int dim>
void BodyRows<dim>::reinit(const Body<dim> &body,
                           const std::vector<ContactRow<dim>> &rows,
                           const std::vector<unsigned int> &of_body,
                           const unsigned int n_components)
{
  n_rows = of_body.size();
  const auto slides = [&](const unsigned int component)
  { return component % n_components == 0 && rows[component / n_components].slide != nullptr; };
  const bool any_slides = std::any_of(of_body.begin(), of_body.end(), slides);
  local.resize(body.field.n_dofs(), n_rows + (any_slides ? dim : 0));
  whole.setZero(dim, any_slides ? n_rows : 0);
  for (unsigned int k = 0; k < n_rows; ++k)
  {
    const ContactRow<dim> &row = rows[of_body[k] / n_components];
    const bool own = row.body == body.index;
    const NodeWeights &weights = own ? *row.body_weights : *row.partner_weights;
    const dealii::Tensor<1, dim> direction = (own ? 1. : -1.) * row.direction(of_body[k] % n_components);
    if (row.partner == row.body)
      add_column_of_both<dim>(row, direction, k, local);
    else if (own && slides(of_body[k]))
      add_column<dim>(weights, direction, row.slide->place, -row.slope * row.slide->across, k, local);
    else
      add_column<dim>(weights, direction, k, local);
    if (slides(of_body[k]))
      for (unsigned int d = 0; d < dim; ++d)
        whole(d, k) = row.slope * (own ? row.slide->of_body_centre : row.slide->of_centre)[d];
  }
  mass_share.resize(0);
  if (any_slides)
  {
    mass_share = body.mass / body.mass.sum();
    for (unsigned int d = 0; d < dim; ++d)
    {
      local.startVec(n_rows + d);
      for (unsigned int i = 0; i < mass_share.size(); ++i)
        local.insertBack(dim * i + d, n_rows + d) = mass_share[i];
    }
  }
  local.finalize();
}

template <int dim>
Eigen::VectorXd BodyRows<dim>::velocities(const Eigen::VectorXd &nodal) const
{
  const Eigen::VectorXd all = local.transpose() * nodal;
  if (mass_share.size() == 0)
    return all;
  return all.head(n_rows) + whole.transpose() * all.template tail<dim>();
}

template <int dim>
void BodyRows<dim>::add_impulses(const Eigen::VectorXd &P, Eigen::VectorXd &nodal) const
{
  if (mass_share.size() == 0)
  {
    nodal += local * P;
    return;
  }
  Eigen::VectorXd all(n_rows + dim);
  all.head(n_rows) = P;
  all.template tail<dim>() = whole * P;
  nodal += local * all;
}

template <int dim>
void BodyRows<dim>::condense(RankOneSolver &solver, Eigen::MatrixXd &W) const
{
  if (mass_share.size() == 0)
    return solver.condense(local, W);
  Eigen::MatrixXd all;
  solver.condense(local, all);
  // With w for `whole` and c for the two last: W + wᵀ W_c + W_cᵀ w + wᵀ W_cc w, and both halves alike.
  const Eigen::Matrix<double, dim, Eigen::Dynamic> half =
      all.bottomLeftCorner(dim, n_rows) + 0.5 * all.bottomRightCorner(dim, dim) * whole;
  W.noalias() = whole.transpose() * half;
  W += W.transpose().eval();
  W += all.topLeftCorner(n_rows, n_rows);
}

template <int dim>
LinearSolver::Rows BodyRows<dim>::full() const
{
  LinearSolver::Rows matrix = local.leftCols(n_rows);
  if (mass_share.size() > 0)
    matrix += LinearSolver::Rows(local.rightCols(dim) * LinearSolver::Rows(whole.sparseView()));
  return matrix;
}

template class BodyRows<2>;
} // namespace softgrain::mpm
