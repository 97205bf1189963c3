// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_whole_rotation_h
#define softgrain_mpm_body_whole_rotation_h

#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/step_state.h>

#include <Eigen/Core>

namespace softgrain::mpm
{
/// Vector z over the dofs of a body whose product with a nodal velocity is the mean angular velocity [1/s] of
/// the whole body, mass by mass; force z times a torque turns the body and does nothing else.
Eigen::VectorXd whole_rotation(const Body<2> &body);
/// Whole rotation where the nodes have moved on by @p way [m], over the rotary inertia before they did: its
/// product with the change of nodal velocities is that of the angular momentum about the place on the way,
/// over that inertia.
Eigen::VectorXd whole_rotation(const Body<2> &body, const Eigen::VectorXd &way);

/// Rotary inertia of a body about its centre of mass, of its whole_rotation() @p r [kg m^2/m].
double rotary_inertia(const Body<2> &body, const Eigen::VectorXd &r);

/// Vectors at nodes, turned by @p angle [rad].
Eigen::VectorXd turned(const Eigen::VectorXd &vectors, double angle);

/// p A, with p the mean pressure of a body and A its area [N].
double pressure_area(const Body<2> &body, const StepState<2> &s);

/**
 * @brief Makes the rotation of a whole body in a step of Newton's method a true one.
 *
 * A step u that turns a body by φ = r·u moves its nodes along tangents, which stretches it by φ²/2: more than
 * a light contact bears. Nodes go along circles in place of tangents; the change is of second order, so
 * Newton's method converges as before.
 * @param r    whole_rotation()
 * @param from displacement of the nodes since the grid was laid, before the step [m]
 * @param step displacement, changed [m]
 */
void turn_along_circles(const Body<2> &body,
                        const Eigen::VectorXd &r,
                        const Eigen::VectorXd &from,
                        Eigen::VectorXd &step);

/// Adds the sum of nodal impulses [N s/m] over the mass of the body to every nodal velocity [m/s]: what
/// Newton left unbalanced on the body as a whole, so that momentum is exact.
void spread_imbalance(const Body<2> &body, const Eigen::VectorXd &impulse, Eigen::VectorXd &velocity);
} // namespace softgrain::mpm

#endif
