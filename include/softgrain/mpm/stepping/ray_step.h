// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_ray_step_h
#define softgrain_mpm_stepping_ray_step_h

#include <softgrain/mpm/stepping/step.h>

#include <limits>

namespace softgrain::mpm
{
/**
 * @brief One step of `quasi_static` or `moreau_jean` with rays: no ray overlaps at its end. Without inertia
 * it is a minimum of the energy of the bodies and of what resists their motion. See
 * doc/results/contact-geometry.md.
 * @param careful bodies resist so much that none goes further than rays have looked. That is for a step that
 * has failed, as under a load that nothing bears yet: it would take bodies into others that no ray has seen.
 * @param most_resistance from which on a step without a minimum fails, in place of one in which bodies resist
 * more (dimensionless, as 'Quasi-static/Regularisation')
 */
StepOutcome ray_step(const Problem &problem,
                     State &state,
                     Workspace &work,
                     const StepPlan &plan,
                     bool careful = false,
                     double most_resistance = std::numeric_limits<double>::max());
} // namespace softgrain::mpm

#endif
