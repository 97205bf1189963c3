// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/parameters/parameter_values.h>
#include <softgrain/scene/packing_parameters.h>
#include <softgrain/scene/scene_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace softgrain
{
SceneParameters::SceneParameters(const SceneNames &names, const LawCatalogue &laws)
    : materials(names.materials, laws), bodies(names.bodies), walls(names.walls), obstacles(names.obstacles)
{
}

void SceneParameters::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  materials.declare_parameters(prm);
  bodies.declare_parameters(prm);
  PackingParameters::declare_parameters(prm);
  walls.declare_parameters(prm);
  obstacles.declare_parameters(prm);
  prm.enter_subsection("Contact");
  prm.declare_entry("Friction", "0", Double(0), "Coefficient of friction between bodies. Units: none.");
  prm.leave_subsection();
  prm.enter_subsection("Loads");
  prm.declare_entry("Gravity", "0, 0", List(Double(), 2, 2, ","),
                    "Acceleration of gravity, \"gx, gy\". Units: m/s^2.");
  prm.leave_subsection();
}

Scene<2> SceneParameters::parse_parameters(dealii::ParameterHandler &prm) const
{
  Scene<2> scene;
  scene.materials = materials.parse_parameters(prm);
  scene.bodies = bodies.parse_parameters(prm, scene.materials);
  scene.packing = PackingParameters::parse_parameters(prm, scene.materials);
  scene.walls = walls.parse_parameters(prm);
  scene.obstacles = obstacles.parse_parameters(prm);
  scene.friction = prm.get_double({"Contact"}, "Friction");
  scene.gravity = pair_of_numbers(prm.get({"Loads"}, "Gravity"));
  return scene;
}
} // namespace softgrain
