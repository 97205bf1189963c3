// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_begin_step_h
#define softgrain_mpm_stepping_begin_step_h

#include <softgrain/mpm/stepping/step.h>

#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Puts on walls and obstacles what is asked of them in a step: loads, velocities, ways. Walls that are
 * free become unknowns of the step.
 * @return how walls move, slabs among them
 */
std::vector<WallMotion<2>>
begin_step(const Problem &problem, State &state, Workspace &work, const StepPlan &plan);

/// How walls move under the loads that they have; obstacles plan their way. begin_step() ends with it.
std::vector<WallMotion<2>> wall_motion(State &state, Workspace &work, const StepPlan &plan);

/// Slabs go with their walls.
void drive_slabs(const State &state, const std::vector<WallMotion<2>> &motion, Workspace &work);
} // namespace softgrain::mpm

#endif
