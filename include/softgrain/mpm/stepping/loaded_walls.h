// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_loaded_walls_h
#define softgrain_mpm_stepping_loaded_walls_h

#include <softgrain/driving/cell_motion.h>
#include <softgrain/driving/obstacle.h>
#include <softgrain/driving/wall_parts.h>
#include <softgrain/driving/wall_step.h>
#include <softgrain/mpm/contact/free_walls.h>
#include <softgrain/mpm/contact/wall_motion.h>
#include <softgrain/mpm/stepping/wall_imbalance.h>

#include <optional>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/// A wall under a load that has a mass, as it begins a step.
struct WallWithMass
{
  FreeWall<3> wall;
  WallLoad load; ///< in the middle of the step
};

/// What is told how to move in a step in space, and which walls are under loads.
struct SpaceMotion
{
  std::vector<WallMotion<3>> walls; ///< those under loads where they began, at rest
  std::vector<ObstacleMotion<3>> obstacles;
  std::vector<std::optional<double>> pressure; ///< of walls under loads, towards the bodies, at the end [Pa]
  std::vector<double> pressure_at_start;       ///< the same, 0 without a load [Pa]
  std::vector<WallWithMass> free;              ///< of all walls, with inertia alone
  double cell_offset = 0.; ///< of the cell above, of one that repeats, as the step begins [m]

  /// The cell between those walls that are its sides, as it is and as it deforms; nothing without any.
  std::optional<CellMotion<3>> cell() const;

  /// All stands where a step of @p dt ends, but for walls under loads.
  SpaceMotion at_end(double dt) const;
};

/// How far a wall under a load in space has come.
struct LoadedWall
{
  double way = 0.;   ///< along its normal since the start [m]
  double speed = 0.; ///< along its normal, with inertia [m/s]
  double work = 0.;  ///< of its load since the start [J]
};

/// Area on which a pressure on wall @p w acts: between the walls beside it, which look along the two other
/// axes, where they are; 0 without them [m^2].
double pressed_area(const std::vector<WallMotion<3>> &walls, std::size_t w);

/// Walls under loads where they have come to.
std::vector<WallMotion<3>> walls_now(const SpaceMotion &motion, const std::vector<LoadedWall> &loaded);

/// @param force of walls on the bodies [N]
/// @param floor of loads, below which nothing is asked [N]
WallImbalance least_balanced_wall(const SpaceMotion &motion,
                                  const std::vector<LoadedWall> &loaded,
                                  const std::vector<dealii::Tensor<1, 3>> &force,
                                  double floor);
} // namespace softgrain::mpm

#endif
