// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_external_force_h
#define softgrain_mpm_stepping_external_force_h

#include <softgrain/mpm/body/body.h>

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

namespace softgrain::mpm
{
/// Force of gravity and the body's own load on the independent nodes [N]; false when there is none.
template <int dim>
bool external_force(const Body<dim> &body,
                    const dealii::Tensor<1, dim> &gravity,
                    double time,
                    Eigen::VectorXd &force);
} // namespace softgrain::mpm

#endif
