// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_at_marker_h
#define softgrain_mpm_body_at_marker_h

#include <softgrain/mpm/body/body.h>

#include <Eigen/Core>

namespace softgrain::mpm
{
/// Value of a vector field at marker @p m of the boundary. @param nodal its values at the nodes
template <int dim>
dealii::Tensor<1, dim> at_marker(const Body<dim> &body, const unsigned int m, const Eigen::VectorXd &nodal)
{
  const NodeWeightsView weights = body.field.markers()[m];
  dealii::Tensor<1, dim> value;
  for (unsigned int k = 0; k < weights.size; ++k)
    for (unsigned int d = 0; d < dim; ++d)
      value[d] += weights.weight[k] * nodal[dim * weights.node[k] + d];
  return value;
}
} // namespace softgrain::mpm

#endif
