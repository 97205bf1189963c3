// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/parameters/within_section.h>
#include <softgrain/scene/contact_law.h>
#include <softgrain/scene/packing_parameters.h>
#include <softgrain/scene/scene_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace softgrain
{
SceneParameters::SceneParameters(const SceneNames &names,
                                 const LawCatalogue &laws,
                                 const unsigned int dimension)
    : names(names)
    , dimension(dimension)
    , materials(names.materials, laws)
    , bodies(names.bodies, dimension)
    , walls(names.walls, dimension)
    , obstacles(names.obstacles, dimension)
{
}

void SceneParameters::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  materials.declare_parameters(prm);
  bodies.declare_parameters(prm);
  PackingParameters::declare_parameters(prm, dimension);
  walls.declare_parameters(prm);
  obstacles.declare_parameters(prm);
  prm.enter_subsection("Contact");
  prm.declare_entry("Friction", "0", Double(0),
                    "Coefficient of friction between bodies; at walls and obstacles only with 'Friction at "
                    "walls' = same. With Model = "
                    "bpm it hardly acts while the primaries of bodies may roll: see 'Contact/Rolling "
                    "resistance'. Units: none.");
  prm.declare_entry("Friction at walls", "own", Selection("own|same"),
                    "own: each wall and obstacle has its own 'Friction', 0 where it sets none; same: "
                    "'Contact/Friction' holds there "
                    "too. 'Friction of pairs' counts more than either.");
  const std::string table =
      "Other values for pairs, \"first / second: value; ...\". Each name is that of a material, of a body or "
      "of "
      "a wall; an entry that names a body counts more than one that names its material.";
  prm.declare_entry("Friction of pairs", "", Anything(), table + " Units: none.");
  declare_contact_laws(prm);
  prm.declare_entry(
      "Adhesion", "0", Double(0),
      "Strength with which a 'Law' that adheres holds bodies together, and to walls. Units: N/m^2 with Model "
      "= "
      "mpm, of the length along which bodies touch; N/m with Model = bpm, of every pair of primaries.");
  prm.declare_entry("Adhesion of pairs", "", Anything(), table + " Units: those of 'Adhesion'.");
  prm.leave_subsection();
  if (dimension == 3)
    Loads<3>::declare_parameters(prm);
  else
    Loads<2>::declare_parameters(prm);
}

template <int dim>
void SceneParameters::parse_contact(dealii::ParameterHandler &prm, Scene<dim> &scene) const
{
  const WithinSection section(prm, "Contact");
  scene.friction = prm.get_double("Friction");
  scene.friction_pairs = parse_pairs("Contact/Friction of pairs", prm.get("Friction of pairs"), names);
  scene.contact_law = parse_contact_law(prm);
  scene.adhesion = prm.get_double("Adhesion");
  scene.adhesion_pairs = parse_pairs("Contact/Adhesion of pairs", prm.get("Adhesion of pairs"), names);
  const bool table = !scene.adhesion_pairs.empty();
  if (!scene.contact_law->adheres() && (scene.adhesion > 0. || table))
  {
    const std::string name = table ? "Adhesion of pairs" : "Adhesion";
    throw InputError("'Contact/" + name + "' = '" + prm.get(name) + "' has no effect with 'Contact/Law' = '" +
                     prm.get("Law") + "': leave it out, or choose a law that adheres");
  }
}

template <int dim>
void SceneParameters::rub_at_walls(dealii::ParameterHandler &prm, Scene<dim> &scene) const
{
  if (prm.get({"Contact"}, "Friction at walls") != "same")
    return;
  const auto take = [&](const std::string &path, double &friction)
  {
    if (friction != 0.)
      throw InputError(
          "'" + path +
          "/Friction' has no effect with 'Contact/Friction at walls' = 'same': leave one of them out");
    friction = scene.friction;
  };
  for (WallDescription<dim> &wall : scene.walls)
    if (wall.type != WallDescription<dim>::Type::periodic)
      take("Walls/" + wall.name, wall.friction);
  for (ObstacleDescription<dim> &obstacle : scene.obstacles)
    take("Obstacles/" + obstacle.name, obstacle.friction);
}

Scene<2> SceneParameters::parse_parameters(dealii::ParameterHandler &prm) const
{
  Scene<2> scene;
  scene.materials = materials.parse_parameters(prm);
  Mistakes mistakes;
  mistakes.attempt([&]() { scene.bodies = bodies.parse_parameters<2>(prm, scene.materials); });
  mistakes.attempt([&]() { scene.packing = PackingParameters::parse_parameters<2>(prm, scene.materials); });
  mistakes.attempt([&]() { scene.walls = walls.parse_parameters<2>(prm); });
  mistakes.attempt([&]() { parse_contact(prm, scene); });
  mistakes.attempt([&]() { scene.obstacles = obstacles.parse_parameters<2>(prm); });
  mistakes.attempt([&]() { rub_at_walls(prm, scene); });
  mistakes.attempt([&]() { scene.loads = Loads<2>::parse_parameters(prm); });
  mistakes.end();
  return scene;
}

Scene<3> SceneParameters::parse_parameters_in_space(dealii::ParameterHandler &prm) const
{
  Scene<3> scene;
  scene.materials = materials.parse_parameters(prm);
  Mistakes mistakes;
  mistakes.attempt([&]() { scene.bodies = bodies.parse_parameters<3>(prm, scene.materials); });
  mistakes.attempt([&]() { scene.packing = PackingParameters::parse_parameters<3>(prm, scene.materials); });
  mistakes.attempt([&]() { scene.walls = walls.parse_parameters<3>(prm); });
  mistakes.attempt([&]() { scene.obstacles = obstacles.parse_parameters<3>(prm); });
  mistakes.attempt([&]() { scene.loads = Loads<3>::parse_parameters(prm); });
  mistakes.end();
  parse_contact(prm, scene);
  rub_at_walls(prm, scene);
  return scene;
}
} // namespace softgrain
