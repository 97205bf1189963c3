// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_step_contact_h
#define softgrain_mpm_stepping_step_contact_h

#include <softgrain/mpm/contact/row_velocity.h>
#include <softgrain/mpm/stepping/step.h>
#include <softgrain/mpm/stepping/step_equations.h>

#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The contact problems of one implicit step: Signorini's condition and Coulomb's law for the rows of
 * the step, condensed to them or with lumped masses. See doc/theory.md, "Contact solve".
 */
class StepContact
{
public:
  using Vectors = StepEquations::Vectors;

  /// @param motion    of the walls, as it comes out
  /// @param equations of the step
  /// @param outcome   takes sweeps and residuals
  StepContact(const Problem &problem,
              const State &state,
              Workspace &work,
              const StepPlan &plan,
              const std::vector<WallMotion<2>> &motion,
              const StepEquations &equations,
              StepOutcome &outcome);

  /// W = H A⁻¹ Hᵀ with the present factors of A.
  void condense();

  /// Impulses for the end velocities @p trial and the direction @p direction that leads to balance without
  /// contact [m/s]. @return why there are none, empty when it went well
  std::string solve_condensed(const Vectors &trial, const Vectors &direction);

  /// Impulses for the end velocities @p trial [m/s] with W = H M⁻¹ Hᵀ, masses alone. @return why none
  std::string solve_lumped(const Vectors &trial);

  /// Whether the last problem has been solved as well as the end of a step asks for.
  bool converged() const { return is_converged; }

private:
  std::string solve(const Vectors &v, bool relative);

  const Problem &problem;
  const State &state;
  Workspace &work;
  const StepPlan &plan;
  const std::vector<WallMotion<2>> &motion;
  const StepEquations &equations;
  StepOutcome &outcome;
  /// End velocities without contact, of owned bodies; kept, for fresh memory is dear [m/s].
  Vectors free;
  bool is_converged = true;
};
} // namespace softgrain::mpm

#endif
