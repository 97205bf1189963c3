// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_whole_rotation_h
#define softgrain_mpm_whole_rotation_h

#include <softgrain/mpm/body.h>

#include <Eigen/Core>

namespace softgrain::mpm
{
/// Vector z over the dofs of a body whose product with a nodal velocity is the mean angular velocity [1/s] of
/// the whole body, mass by mass; force z times a torque turns the body and does nothing else.
Eigen::VectorXd whole_rotation(const Body<2> &body);

/**
 * @brief Torque per radian of a step that resists rotation of a whole body in steps without inertia [N m/m].
 *
 * A round body between frictionless walls may turn at no cost, and its few contact rows may even push it
 * round. 2.5 p A, with p the mean pressure and A the area, outweighs the -2 p A of forces that keep their
 * direction. The resistance vanishes with the step, and deformation and translation never feel it.
 */
double rotation_resistance(const Body<2> &body);

/// Adds the sum of nodal impulses [N s/m] over the mass of the body to every nodal velocity [m/s]: what
/// Newton left unbalanced on the body as a whole, so that momentum is exact.
void spread_imbalance(const Body<2> &body, const Eigen::VectorXd &impulse, Eigen::VectorXd &velocity);
} // namespace softgrain::mpm

#endif
