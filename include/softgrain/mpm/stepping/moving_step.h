// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_moving_step_h
#define softgrain_mpm_stepping_moving_step_h

#include <softgrain/mpm/stepping/space_ray_step.h>

#include <vector>

namespace softgrain::mpm
{
/// One step of `moreau_jean` in space, as ray_step() makes it in the plane; @p state goes on only if it is
/// accepted. @param motion of the walls
StepOutcome
moving_step(SpaceState &state, const SpaceScene &scene, const std::vector<WallMotion<3>> &motion, double dt);
} // namespace softgrain::mpm

#endif
