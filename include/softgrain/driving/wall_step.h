// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_wall_step_h
#define softgrain_driving_wall_step_h

#include <softgrain/driving/wall.h>

#include <vector>

namespace softgrain
{
/**
 * @brief The step in which the fastest of the walls that are told how to move goes @p way [m].
 *
 * Walls under pressure do not count: nobody knows beforehand how far they go.
 * @param time     at its start [s]
 * @param shortest the step that is certainly not too long [s]
 * @param longest  the longest that is looked at [s]
 * @return 0 if no such wall goes that far within @p longest
 */
double
step_of_wall_way(const std::vector<Wall<2>> &walls, double time, double way, double shortest, double longest);
} // namespace softgrain

#endif
