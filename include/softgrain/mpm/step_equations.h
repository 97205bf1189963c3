// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_step_equations_h
#define softgrain_mpm_step_equations_h

#include <softgrain/mpm/stress.h>
#include <softgrain/mpm/world.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The equations of one implicit step for the velocities at its end, body by body: unbalanced impulse
 * for a trial, and the matrix of Newton's method. See doc/theory.md, "One step".
 *
 * Vectors hold one nodal vector per body; those of driven bodies are not used.
 */
class StepEquations
{
public:
  using Vectors = std::vector<Eigen::VectorXd>;

  /// Takes forces and loads at the start of the step from @p world, whose contact rows are those of the step.
  StepEquations(World &world, double dt);

  bool moves(const unsigned int b) const { return !world.bodies[b].driven; }

  /// Stress and unbalanced impulse for the end velocities @p v; false when a point turns inside out
  /// or deforms by too much over the step.
  bool evaluate(const Vectors &v);
  /// Why the last evaluate() failed.
  std::string why_not() const { return world.why_not(bad_body, trouble); }

  /// Impulse that is missing for balance at every node of a body, those of the contacts counted [N s/m].
  Eigen::VectorXd unbalanced(unsigned int b) const;
  /// Norm of unbalanced() of all bodies [N s/m].
  double unbalanced_norm() const;
  /// That norm over the largest impulse of the step.
  double residual() const;

  /// A = M + theta^2 dt^2 K of every body, factorised; shifted when it is not positive definite.
  /// @return why not, empty when it went well
  std::string factorise();
  /// A x = the missing impulse, or what is unbalanced with contact, for every body [m/s].
  void solve(bool with_contact, Vectors &x) const;

  /// Displacements over the step for the velocities last evaluated [m].
  Vectors increment;
  /// Internal forces for them [N].
  Vectors internal;
  /// Loads of the bodies, empty where there are none [N].
  Vectors external;
  /// H v at the start of the step, empty when theta is 1 [m/s].
  std::vector<double> start_relative;

private:
  World &world;
  const TimeScheme &scheme;
  const double dt;
  Vectors old_force, missing_impulse, rotation;
  std::vector<double> shift, rotation_stiffness;
  unsigned int bad_body = 0;
  StressOutcome trouble;
};
} // namespace softgrain::mpm

#endif
