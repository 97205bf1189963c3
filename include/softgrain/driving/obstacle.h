// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_obstacle_h
#define softgrain_driving_obstacle_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/scene/obstacle_parameters.h>
#include <softgrain/scene/scene.h>

#include <string>
#include <vector>

namespace softgrain
{
class StateReader;
class StateWriter;

/// How an obstacle moves in a step.
struct ObstacleMotion
{
  Pose start, end;
  double dt = 0; ///< [s]; 0: it stands

  /// Pose @p share of the step after its start.
  Pose at(double share) const;

  /// Mean over the step, of a point of the drawn obstacle [m/s].
  dealii::Tensor<1, 2> velocity(const dealii::Point<2> &drawn) const
  {
    return dt > 0. ? (end.placed(drawn) - start.placed(drawn)) / dt : dealii::Tensor<1, 2>();
  }
  double spin() const { return dt > 0. ? (end.angle - start.angle) / dt : 0.; } ///< [rad/s]
};

/**
 * @brief A rigid line of finite length, straight or round, on its way; the same in both models.
 *
 * Bodies may touch it from both sides. Where it is, is a formula of time: nothing that it meets moves it.
 */
struct Obstacle
{
  ObstacleDescription<2> description;
  Pose now;                   ///< where it is
  ObstacleMotion way;         ///< of the step to come, or of the last one
  dealii::Tensor<1, 2> force; ///< on it, mean over the last step [N/m]
  double torque = 0;          ///< of these forces about the pivot, counter-clockwise [N]
  double work = 0;            ///< done by it since the start [J/m]

  /// Makes ready for a step of @p dt from @p time on; 0: it stands [s].
  void plan(double time, double dt);

  /// It has gone the planned way, and felt nothing yet.
  void arrive();

  /// Books an impulse that it has given to a body at @p place in a step of @p dt [s].
  void give(const dealii::Tensor<1, 2> &given, const dealii::Point<2> &place, double dt);

  /// What history, pictures and measures show of it.
  ObstacleState<2> state() const;

  /**
   * @brief Whether piece @p k begins in a corner, or in an end of the line: what can be touched by itself.
   *
   * @p k may be the number of pieces: the end of the last one.
   */
  bool has_tip(std::size_t k) const;
  /// That place, as drawn [m].
  dealii::Point<2> tip(std::size_t k) const;
};

/// The obstacles of a scene, where they are at time 0.
std::vector<Obstacle> make_obstacles(const Scene<2> &scene);

std::vector<ObstacleState<2>> states_of(const std::vector<Obstacle> &obstacles);

bool rough(const std::vector<ObstacleDescription<2>> &obstacles); ///< Whether one has friction.

/// Keeps what obstacles feel under @p name in a checkpoint; without obstacles nothing.
void save_obstacles(StateWriter &out, const std::string &name, const std::vector<Obstacle> &obstacles);
/// @throw InputError when there were other obstacles
void load_obstacles(const StateReader &in,
                    const std::string &name,
                    double time,
                    std::vector<Obstacle> &obstacles);
} // namespace softgrain

#endif
