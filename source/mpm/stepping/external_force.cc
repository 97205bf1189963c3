// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/external_force.h>

namespace softgrain::mpm
{
template <int dim>
bool external_force(const Body<dim> &body,
                    const dealii::Tensor<1, dim> &gravity,
                    const double time,
                    Eigen::VectorXd &force)
{
  force.setZero(body.field.n_dofs());
  if (gravity.norm_square() > 0.)
    for (unsigned int i = 0; i < body.field.n_independent(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        force[dim * i + d] = body.mass[i] * gravity[d];
  if (body.body_force.empty())
    return gravity.norm_square() > 0.;

  const unsigned int n = body.field.nodes_per_cell();
  Eigen::VectorXd all = Eigen::VectorXd::Zero(dim * body.field.n_nodes()), own, displacement;
  body.field.prolongate(body.displacement, displacement);
  std::vector<double> place(2 * dim + 1);
  place[2 * dim] = time;
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    const unsigned int *nodes = body.field.point_nodes(p);
    const double *value = body.field.values(p);
    const auto point = body.points[p];
    for (unsigned int d = 0; d < dim; ++d)
    {
      place[d] = point.position()[d];
      for (unsigned int k = 0; k < n; ++k)
        place[d] += value[k] * displacement[dim * nodes[k] + d];
      place[dim + d] = body.rest_position[body.points.number(p)][d];
    }
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double b = point.mass() * body.body_force[d](place);
      for (unsigned int k = 0; k < n; ++k)
        all[dim * nodes[k] + d] += b * value[k];
    }
  }
  body.field.restrict(all, own);
  force += own;
  return true;
}

template bool external_force<2>(const Body<2> &, const dealii::Tensor<1, 2> &, double, Eigen::VectorXd &);
template bool external_force<3>(const Body<3> &, const dealii::Tensor<1, 3> &, double, Eigen::VectorXd &);
} // namespace softgrain::mpm
