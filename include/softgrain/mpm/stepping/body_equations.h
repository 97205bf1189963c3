// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_body_equations_h
#define softgrain_mpm_stepping_body_equations_h

#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/step_state.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The equations of a step for the velocities of the nodes at its end, without contact, as a search for
 * balance with rays needs them. Nothing is known here of how inertia or resistance enter.
 *
 * Vectors hold one nodal vector per body.
 */
template <int dim>
class BodyEquations
{
public:
  using Vectors = std::vector<Eigen::VectorXd>;

  virtual ~BodyEquations() = default;

  /// Stress and unbalanced impulse for the end velocities @p v [m/s]; false when a point turns inside out or
  /// deforms by too much over the step.
  virtual bool evaluate(const Vectors &v) = 0;
  /// Why the last evaluate() failed.
  virtual std::string why_not() const = 0;
  /// The velocity at the end with which an owned body goes this way over the step [m/s].
  virtual Eigen::VectorXd end_velocity(const Body<dim> &body, const Eigen::VectorXd &way) const = 0;
  /// Impulse that is missing for balance without contact, as last evaluated [N s/m^(3-dim)].
  virtual const Eigen::VectorXd &missing(unsigned int b) const = 0;
  /// Size of what the unbalanced impulse of a body may be off by rounding, as last evaluated.
  /// @param contact norm of the impulses of contacts on its nodes
  virtual double rounding(const Body<dim> &body, double contact) const = 0;
  /// Fills the matrix A of one body as its forces have it, nothing held stable.
  virtual void assemble_exact(const Body<dim> &body) = 0;
  /// Makes all bodies resist motion by @p factor more, in the impulses that are missing as well.
  /// @param v for which these were last evaluated [m/s]
  /// @param in_matrices whether the matrices, too, were assembled for @p v and are to know it
  virtual void resist_more(double factor, const Vectors &v, bool in_matrices) = 0;
  /// A x = the missing impulse of a body that touches nothing [m/s].
  virtual void solve_free(unsigned int b, Eigen::VectorXd &x) const = 0;

  /// Displacements over the step for the velocities last evaluated [m].
  Vectors increment;
  /// Internal forces for them [N/m^(3-dim)].
  Vectors internal;
  /// Loads of the bodies, empty where there are none [N/m^(3-dim)].
  Vectors external;
};

/// What is summed for the forces on a body, without regard to signs, so that rounding is a part of it: forces
/// of its stress, times the length of a step, and of contact. @param internal norm of the internal forces
template <int dim>
double summed_in_forces(const Body<dim> &body,
                        const StepState<dim> &trial,
                        double cell_size,
                        double contact,
                        double internal,
                        double dt);
} // namespace softgrain::mpm

#endif
