// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_explicit_space_step_h
#define softgrain_mpm_stepping_explicit_space_step_h

#include <softgrain/mpm/stepping/space_step.h>

namespace softgrain::mpm
{
/// One explicit step in space, as explicit_step() makes it in the plane; @p state goes on only if it is
/// accepted.
StepOutcome
explicit_space_step(SpaceState &state, const SpaceScene &scene, const SpaceMotion &motion, double dt);
} // namespace softgrain::mpm

#endif
