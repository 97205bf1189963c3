// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_space_wall_h
#define softgrain_driving_space_wall_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/geometry/wall_tangent.h>
#include <softgrain/scene/scene.h>
#include <softgrain/scene/wall_drive.h>

#include <memory>
#include <string>
#include <vector>

namespace softgrain
{
class StateReader;
class StateWriter;

/// A flat wall in space on a way that is told: where it is, how it moves and what it has felt.
struct SpaceWall
{
  WallDescription<3> description;
  double travel = 0.;         ///< along the normal since the start [m]
  double speed = 0.;          ///< along it, mean over the last step [m/s]
  double slide = 0.;          ///< along the tangent, likewise [m/s]
  double drive_begin = 0.;    ///< since when it is driven as it is [s]
  double travel_before = 0.;  ///< until then [m]
  double work = 0.;           ///< done on the bodies since the start [J]
  dealii::Tensor<1, 3> force; ///< on the bodies, mean over the last step [N]

  const dealii::Tensor<1, 3> &normal() const { return description.normal; }
  dealii::Point<3> point() const { return description.point + travel * normal(); }
  dealii::Tensor<1, 3> tangent() const { return wall_tangent(normal()); }
  dealii::Tensor<1, 3> velocity() const { return speed * normal() + slide * tangent(); } ///< [m/s]

  /// Takes the velocity that its drive asks for in a step of @p dt from @p time on [s].
  void plan(double time, double dt);
  /// Goes its way in a step in which it gave @p impulse to the bodies [N s].
  void go(double dt, const dealii::Tensor<1, 3> &impulse);
  /// What history, pictures and measures show of it.
  WallState<3> state() const;
};

/// The walls of a scene at the start.
std::vector<SpaceWall> make_walls(const Scene<3> &scene);

/// Drives walls from @p time on as @p drives say, one per wall; null: as before.
void take_drives(std::vector<SpaceWall> &walls,
                 const std::vector<std::shared_ptr<const WallDrive>> &drives,
                 double time);

/// Keeps walls under @p name in a checkpoint.
void save_walls(StateWriter &out, const std::string &name, const std::vector<SpaceWall> &walls);
/// @throw InputError when there were other walls
void load_walls(const StateReader &in, const std::string &name, std::vector<SpaceWall> &walls);
} // namespace softgrain

#endif
