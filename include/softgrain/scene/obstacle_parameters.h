// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_obstacle_parameters_h
#define softgrain_scene_obstacle_parameters_h

#include <softgrain/scene/scene.h>

#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// Section `Obstacles`: rigid segments and arcs that move as formulas of time say; one subsection per name.
class ObstacleParameters
{
public:
  explicit ObstacleParameters(const std::vector<std::string> &names);

  void declare_parameters(dealii::ParameterHandler &prm) const;

  /// @throw InputError when a line has no length, or something is set that belongs to the other shape
  std::vector<ObstacleDescription<2>> parse_parameters(dealii::ParameterHandler &prm) const;

private:
  const std::vector<std::string> names;
};

/// Where an obstacle is at some time: turned about its pivot, then shifted.
struct Pose
{
  dealii::Point<2> pivot;     ///< before it is shifted [m]
  dealii::Tensor<1, 2> shift; ///< [m]
  double angle = 0;           ///< counter-clockwise [rad]

  dealii::Tensor<1, 2> turned(const dealii::Tensor<1, 2> &v, double by) const;
  /// The place that a point of the drawn obstacle has now, and the way back.
  dealii::Point<2> placed(const dealii::Point<2> &drawn) const
  {
    return pivot + shift + turned(drawn - pivot, angle);
  }
  dealii::Point<2> drawn(const dealii::Point<2> &place) const
  {
    return pivot + turned(place - shift - pivot, -angle);
  }
};

/// @throw ComputationError when a formula of its motion is not finite at @p time [s]
Pose pose_of(const ObstacleDescription<2> &obstacle, double time);
} // namespace softgrain

#endif
