// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_safe_step_h
#define softgrain_mpm_stepping_safe_step_h

#include <softgrain/mpm/body/body.h>

#include <vector>

namespace softgrain::mpm
{
struct Problem;
struct State;
struct Workspace;

/**
 * @brief The longest step from here, up to @p dt, in which no body can pass through another unseen [s].
 *
 * Two bodies whose boxes meet on their way may come nearer by the way that the contact geometry allows, by
 * the velocities that they have now and their loads add; those that are apart may go as far as they are
 * apart.
 */
double safe_step(const Problem &problem, const State &state, const Workspace &work, double dt);

/// Longest such step in space, where rays see walls and nothing is driven [s].
double safe_step_in_space(const std::vector<Body<3>> &bodies,
                          const std::vector<Obstacle<3>> &obstacles,
                          double time,
                          double dt);
} // namespace softgrain::mpm

#endif
