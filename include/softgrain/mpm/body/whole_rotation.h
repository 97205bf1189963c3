// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_whole_rotation_h
#define softgrain_mpm_body_whole_rotation_h

#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/step_state.h>

#include <Eigen/Core>

namespace softgrain::mpm
{
/// Axes about which a body may turn: one in the plane, three in space.
template <int dim>
constexpr int n_turns = dim == 2 ? 1 : 3;

/// A turn about each of them [rad], or what belongs to one.
template <int dim>
using Turn = Eigen::Matrix<double, n_turns<dim>, 1>;

/// A column over the dofs of a body for each of them.
template <int dim>
using WholeRotation = Eigen::Matrix<double, Eigen::Dynamic, n_turns<dim>>;

/// Columns z over the dofs of a body whose products with a nodal velocity are the mean angular velocity [1/s]
/// of the whole body, mass by mass; force z times a torque turns the body and does nothing else.
template <int dim>
WholeRotation<dim> whole_rotation(const Body<dim> &body);
/// Whole rotation where the nodes have moved on by @p way [m], over the rotary inertia before they did: its
/// product with the change of nodal velocities is that of the angular momentum about the place on the way,
/// over that inertia.
template <int dim>
WholeRotation<dim> whole_rotation(const Body<dim> &body, const Eigen::VectorXd &way);

/// Rotary inertia of a body about its centre of mass, of a column of its whole_rotation() [kg m^(4-dim)].
template <int dim>
double rotary_inertia(const Body<dim> &body, const Eigen::VectorXd &r);

/// Vectors at nodes, turned by @p turn [rad], whose direction is the axis.
template <int dim>
Eigen::VectorXd turned(const Eigen::VectorXd &vectors, const Turn<dim> &turn);
template <>
Eigen::VectorXd turned<2>(const Eigen::VectorXd &vectors, const Turn<2> &turn);
template <>
Eigen::VectorXd turned<3>(const Eigen::VectorXd &vectors, const Turn<3> &turn);

/// p A, with p the mean pressure of a body and A its area; in space its volume [N m^(dim-2)].
template <int dim>
double pressure_area(const Body<dim> &body, const StepState<dim> &s);

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

/// Adds the sum of nodal impulses [N s/m^(3-dim)] over the mass of the body to every nodal velocity [m/s]:
/// what Newton left unbalanced on the body as a whole, so that momentum is exact.
template <int dim>
void spread_imbalance(const Body<dim> &body, const Eigen::VectorXd &impulse, Eigen::VectorXd &velocity);
} // namespace softgrain::mpm

#endif
