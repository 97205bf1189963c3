// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_ray_step_h
#define softgrain_mpm_stepping_ray_step_h

#include <softgrain/mpm/stepping/step.h>

namespace softgrain::mpm
{
/**
 * @brief One step of `quasi_static` or `moreau_jean` with rays: no ray overlaps at its end. Without inertia
 * it is a minimum of the energy of the bodies and of what resists their motion. See
 * doc/results/contact-geometry.md.
 */
StepOutcome ray_step(const Problem &problem, State &state, Workspace &work, const StepPlan &plan);
} // namespace softgrain::mpm

#endif
