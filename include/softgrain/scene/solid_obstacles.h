// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_solid_obstacles_h
#define softgrain_scene_solid_obstacles_h

#include <softgrain/scene/scene.h>

#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// Refuses values of parameters that only another `Shape` of an obstacle or a body has. @param declare all
/// parameters of the section. @throw InputError
void check_unused_by_shape(const dealii::ParameterHandler &prm,
                           const std::string &where,
                           const std::vector<std::string> &others,
                           void (*declare)(dealii::ParameterHandler &));

/// Declares what an obstacle in space has, in its own section.
void declare_solid_obstacle(dealii::ParameterHandler &prm);

/// @param prm where the section stands. @throw InputError when it encloses nothing, or a file is none
ObstacleDescription<3> parse_solid_obstacle(const dealii::ParameterHandler &prm, const std::string &name);
} // namespace softgrain

#endif
