// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_wall_balance_h
#define softgrain_driving_wall_balance_h

#include <softgrain/driving/wall.h>

#include <vector>

namespace softgrain
{
/// Largest |force - load| over the load of the walls that are free to move; 0 without any.
double unbalanced(const std::vector<Wall<2>> &walls);
} // namespace softgrain

#endif
