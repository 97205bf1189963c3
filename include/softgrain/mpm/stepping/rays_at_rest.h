// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_rays_at_rest_h
#define softgrain_mpm_stepping_rays_at_rest_h

#include <softgrain/mpm/stepping/step.h>

namespace softgrain::mpm
{
/// quasi_static_step() where contact is found by rays: bodies that find no minimum with walls on their way
/// resist more.
StepOutcome rays_step(const Problem &problem, State &state, Workspace &work, double dt, double wanted);

/// Held steps of it, until what resists the bodies is no more than 'Quasi-static/Unbalanced force' of the
/// mean force of a contact. Forces below a hundredth of Young's modulus times a cell count as that much:
/// between bodies that hardly touch nothing else than resistance acts.
/// @throw ComputationError as find_balance()
StepOutcome settle_rays(const Problem &problem, State &state, Workspace &work, double dt);
} // namespace softgrain::mpm

#endif
