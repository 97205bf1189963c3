// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_assembly_h
#define softgrain_mpm_assembly_h

#include <softgrain/mpm/body.h>

#include <Eigen/Core>

#include <cstddef>

namespace softgrain::mpm
{
class SystemMatrix;

/// What evaluate_stress() is to compute besides the stress.
struct StressWishes
{
  bool tangent = false;
  bool energy = false; ///< energy, dissipation, out-of-plane stress and history of the end of the step
};

/// How evaluate_stress() came out.
struct StressOutcome
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t bad_point = none; ///< first point whose trial deformation is inside out
  bool good() const { return bad_point == none; }
};

/**
 * @brief Deformation and stress at all points for a trial displacement of the nodes.
 *
 * @param body         its step state is filled
 * @param displacement of the independent nodes since the grid was built [m]
 * @param increment    the part of it that belongs to this step [m]
 * @param half_dt      dt/2 when volumes of small-strain laws follow (3.17) within the step, 0 when they stay
 * [s]
 */
template <int dim>
StressOutcome evaluate_stress(Body<dim> &body,
                              const Eigen::VectorXd &displacement,
                              const Eigen::VectorXd &increment,
                              double half_dt,
                              const StressWishes &wishes);

/// Internal force (3.11) on the independent nodes for the stress last evaluated [N].
template <int dim>
void internal_force(Body<dim> &body, Eigen::VectorXd &force);

/**
 * @brief Stiffness -d(internal force)/d(displacement) for the stress and tangent last evaluated, times @p
 * factor, added.
 * @param guard_rotation whether to leave the exact tangent and add what keeps a compressed free body from
 * having a negative stiffness against rotation; what holds it in truth are its contacts, which the matrix
 * does not know. Newton then converges linearly, at a rate of about mean pressure over modulus.
 */
template <int dim>
void add_stiffness(const Body<dim> &body, double factor, bool guard_rotation, SystemMatrix &matrix);

/// Sum of the stored energy last evaluated [J].
template <int dim>
double stored_energy(const Body<dim> &body);
} // namespace softgrain::mpm

#endif
