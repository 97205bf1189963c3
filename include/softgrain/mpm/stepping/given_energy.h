// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_given_energy_h
#define softgrain_mpm_stepping_given_energy_h

#include <softgrain/mpm/stepping/step_equations.h>

#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Whether contact without friction gives energy to the bodies in a step that has converged otherwise.
 *
 * Contact rows are looked for where bodies are, and bodies are held where rows are. Where that has not come
 * to an end, bodies overlap by more than the rows say, and have lost energy on the way that the next step
 * gives back. And where a packing is unstable, a step may end at a saddle, uphill. Both are refused: the step
 * is made again with more resistance, or shorter.
 */
class GivenEnergy
{
public:
  /// All are kept by reference. @param motion of the walls in the step
  GivenEnergy(const Problem &problem,
              const State &state,
              const Workspace &work,
              const StepPlan &plan,
              const std::vector<WallMotion<2>> &motion,
              const StepEquations &equations);

  /// @param settled     whether the rows are those of the step as it came out
  /// @param deeper      how much deeper bodies are in each other at its end than they were [m]
  /// @return whether contact gives more than rounding and tolerances do
  bool is_given(bool settled, double deeper) const;

private:
  /// Work of the present contact forces on the overlaps of bodies at a share of the step, 0 or 1 [J/m].
  /// @param grown only on what they have grown by since the start of the step
  double work_of_overlaps(double share, bool grown = false) const;
  /// What pressures and shear stresses do on the walls that they move, in a held step: loads stay as they are
  /// [J/m].
  double work_of_free_walls() const;

  const Problem &problem;
  const State &state;
  const Workspace &work;
  const StepPlan &plan;
  const std::vector<WallMotion<2>> &motion;
  const StepEquations &equations;
};
} // namespace softgrain::mpm

#endif
