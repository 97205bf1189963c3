// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_moving_step_h
#define softgrain_mpm_stepping_moving_step_h

#include <softgrain/mpm/stepping/space_ray_step.h>

#include <vector>

namespace softgrain::mpm
{
/// One step of `moreau_jean` in space, as ray_step() makes it in the plane; @p state goes on only if it is
/// accepted.
StepOutcome moving_step(SpaceState &state, const SpaceScene &scene, const SpaceMotion &motion, double dt);
} // namespace softgrain::mpm

#endif
