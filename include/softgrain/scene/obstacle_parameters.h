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
/// Section `Obstacles`: rigid lines, in space sheets, that move as formulas of time say; one subsection per
/// name.
class ObstacleParameters
{
public:
  ObstacleParameters(const std::vector<std::string> &names, unsigned int dimension);

  void declare_parameters(dealii::ParameterHandler &prm) const;

  /// @throw InputError when a line has no length, or something is set that belongs to the other shape
  template <int dim>
  std::vector<ObstacleDescription<dim>> parse_parameters(dealii::ParameterHandler &prm) const;

private:
  const std::vector<std::string> names;
  const unsigned int dimension;
};

/// Where an obstacle is at some time: turned about its pivot, then shifted.
template <int dim>
struct Pose
{
  dealii::Point<dim> pivot;     ///< before it is shifted [m]
  dealii::Tensor<1, dim> shift; ///< [m]
  double angle = 0;             ///< in the plane counter-clockwise, in space about the axis [rad]
  dealii::Tensor<1, 3> axis;    ///< unit, through the pivot; of space alone

  dealii::Tensor<1, dim> turned(const dealii::Tensor<1, dim> &v, double by) const;
  /// The place that a point of the drawn obstacle has now, and the way back.
  dealii::Point<dim> placed(const dealii::Point<dim> &drawn) const
  {
    return pivot + shift + turned(drawn - pivot, angle);
  }
  dealii::Point<dim> drawn(const dealii::Point<dim> &place) const
  {
    return pivot + turned(place - shift - pivot, -angle);
  }
};

/// @throw ComputationError when a formula of its motion is not finite at @p time [s]
template <int dim>
Pose<dim> pose_of(const ObstacleDescription<dim> &obstacle, double time);
} // namespace softgrain

#endif
