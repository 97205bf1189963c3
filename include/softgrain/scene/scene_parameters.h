// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_scene_parameters_h
#define softgrain_scene_scene_parameters_h

#include <softgrain/scene/body_parameters.h>
#include <softgrain/scene/law_catalogue.h>
#include <softgrain/scene/material_parameters.h>
#include <softgrain/scene/obstacle_parameters.h>
#include <softgrain/scene/scene.h>
#include <softgrain/scene/wall_parameters.h>

#include <string>
#include <vector>

namespace softgrain
{
/// The lists `Names` of a parameter file, which say what else it may contain.
struct SceneNames
{
  std::vector<std::string> materials;
  std::vector<std::string> bodies;
  std::vector<std::string> walls;
  std::vector<std::string> stages = {};
  std::vector<std::string> obstacles = {};
};

/**
 * @brief All sections that make a Scene: Materials, Bodies, Packing, Walls, Obstacles, Contact (friction),
 * Loads.
 */
class SceneParameters
{
public:
  SceneParameters(const SceneNames &names, const LawCatalogue &laws, unsigned int dimension = 2);

  void declare_parameters(dealii::ParameterHandler &prm) const;

  /// The scene, not yet checked as a whole; see check_scene().
  /// @throw InputError naming section, value and what is allowed.
  Scene<2> parse_parameters(dealii::ParameterHandler &prm) const;
  /// Parses a scene in space: what is in no Scene<3> yet is looked for by check_scene_in_space().
  Scene<3> parse_parameters_in_space(dealii::ParameterHandler &prm) const;

private:
  template <int dim>
  void parse_contact(dealii::ParameterHandler &prm, Scene<dim> &scene) const;
  /// Where walls and obstacles are to rub as bodies do.
  template <int dim>
  void rub_at_walls(dealii::ParameterHandler &prm, Scene<dim> &scene) const;

  const SceneNames names;
  const unsigned int dimension;
  const MaterialParameters materials;
  const BodyParameters bodies;
  const WallParameters walls;
  const ObstacleParameters obstacles;
};
} // namespace softgrain

#endif
