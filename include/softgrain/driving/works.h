// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_works_h
#define softgrain_driving_works_h

#include <softgrain/driving/balance.h>
#include <softgrain/driving/obstacle.h>
#include <softgrain/driving/wall.h>

#include <string>
#include <utility>
#include <vector>

namespace softgrain
{
/// What does work in a scene beside walls and obstacles, whether it has done any yet or not.
struct Workers
{
  bool driven_bodies = false, growth = false, cell = false, adhesion = false;
  std::vector<std::string> loads; ///< by name
};

/// All that was done on the bodies since the start: by walls, obstacles and what @p balance has [J/m].
double external_work(const Balance &balance,
                     const std::vector<Wall<2>> &walls,
                     const std::vector<Obstacle<2>> &obstacles);

/// The terms of external_work() one by one, as columns of a history: "NAME_work_J_per_m" and the value.
std::vector<std::pair<std::string, double>> columns_of_work(const Balance &balance,
                                                            const std::vector<Wall<2>> &walls,
                                                            const std::vector<Obstacle<2>> &obstacles,
                                                            const Workers &workers);
} // namespace softgrain

#endif
