// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_obstacle_h
#define softgrain_driving_obstacle_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/scene/obstacle_drive.h>
#include <softgrain/scene/obstacle_parameters.h>
#include <softgrain/scene/scene.h>

#include <string>
#include <vector>

namespace softgrain
{
class StateReader;
class StateWriter;

/// How an obstacle moves in a step.
template <int dim>
struct ObstacleMotion
{
  Pose<dim> start, end;
  double dt = 0;   ///< [s]; 0: it stands
  double way = 0;  ///< that an obstacle which is free goes along its own way, see FreeObstacle
  double load = 0; ///< see ObstacleDrive::load()

  /// Pose @p share of the step after its start.
  Pose<dim> at(double share) const;
  /// That it stands where the step ends.
  ObstacleMotion at_end() const { return {end, end, 0.}; }

  /// Way of a point of the drawn obstacle over the step [m].
  dealii::Tensor<1, dim> way_of(const dealii::Point<dim> &drawn) const
  {
    return end.placed(drawn) - start.placed(drawn);
  }
  /// Mean over the step, of a point of the drawn obstacle [m/s].
  dealii::Tensor<1, dim> velocity(const dealii::Point<dim> &drawn) const
  {
    return dt > 0. ? way_of(drawn) / dt : dealii::Tensor<1, dim>();
  }
  double spin() const { return dt > 0. ? (end.angle - start.angle) / dt : 0.; } ///< [rad/s]
};

/**
 * @brief A rigid line of finite length, in space a sheet, on its way; the same in both models.
 *
 * Bodies may touch it from both sides. Where it is, is a formula of time, and what it meets moves it where
 * its drive lets it go.
 */
template <int dim>
struct Obstacle
{
  ObstacleDescription<dim> description;
  Pose<dim> now;                ///< where it is
  ObstacleMotion<dim> way;      ///< of the step to come, or of the last one
  dealii::Tensor<1, dim> force; ///< on it, mean over the last step [N/m; N]
  double torque = 0;            ///< of these forces about the axis through the pivot [N; N m]
  double work = 0;              ///< done by it since the start [J/m; J]
  FreeObstacle own;             ///< what it has gone where it is free

  /// What it would do in a step of @p dt from @p time on [s].
  ObstacleMotion<dim> motion(double time, double dt) const;

  /// Makes ready for a step of @p dt from @p time on; 0: it stands [s].
  void plan(const double time, const double dt) { way = motion(time, dt); }

  /// It has gone the planned way, and felt nothing yet.
  void arrive();

  /// Books an impulse that it has given to a body at @p place in a step of @p dt [s].
  void give(const dealii::Tensor<1, dim> &given, const dealii::Point<dim> &place, double dt);

  /// Ends the step, when all is felt: where it is free, its speed changes.
  void go_on();

  /// What history, pictures and measures show of it.
  ObstacleState<dim> state() const;
};

/// The obstacles of a scene, where they are at time 0.
template <int dim>
std::vector<Obstacle<dim>> make_obstacles(const Scene<dim> &scene);

template <int dim>
std::vector<ObstacleState<dim>> states_of(const std::vector<Obstacle<dim>> &obstacles);

template <int dim>
bool rough(const std::vector<ObstacleDescription<dim>> &obstacles); ///< Whether one has friction.

/// Keeps what obstacles feel under @p name in a checkpoint; without obstacles nothing.
template <int dim>
void save_obstacles(StateWriter &out, const std::string &name, const std::vector<Obstacle<dim>> &obstacles);
/// @throw InputError when there were other obstacles
template <int dim>
void load_obstacles(const StateReader &in,
                    const std::string &name,
                    double time,
                    std::vector<Obstacle<dim>> &obstacles);
} // namespace softgrain

#endif
