// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_external_force_h
#define softgrain_mpm_stepping_external_force_h

#include <softgrain/mpm/body/body_share.h>

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <vector>

namespace softgrain::mpm
{
/// Force of gravity and the body's own load on the independent nodes [N]; false when there is none.
template <int dim>
bool external_force(const Body<dim> &body,
                    const dealii::Tensor<1, dim> &gravity,
                    double time,
                    Eigen::VectorXd &force);

/// External forces on all bodies that are not driven, on all ranks; empty vectors where there is none. Loads
/// of gravity are computed by all alike, those of a body's own by its rank.
std::vector<Eigen::VectorXd> external_forces(const std::vector<Body<2>> &bodies,
                                             const BodyShare &share,
                                             const dealii::Tensor<1, 2> &gravity,
                                             double time);
} // namespace softgrain::mpm

#endif
