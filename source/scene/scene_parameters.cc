// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/parameters/parameter_values.h>
#include <softgrain/scene/packing_parameters.h>
#include <softgrain/scene/scene_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace softgrain
{
namespace
{
void declare_stop(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.enter_subsection("Stop");
  prm.declare_entry("End time", "0", Double(0), "The run ends at this time; 0: no such condition. Units: s.");
  prm.declare_entry("Axial strain", "0", Double(0),
                    "The run ends when ln(h0/h), where h is the distance of the walls bottom and top, "
                    "reaches this; 0: no such condition. Units: none.");
  prm.declare_entry("Packing fraction", "0", Double(0),
                    "The run ends when the bodies fill this share of the box of the walls bottom, top, left "
                    "and right; 0: no such condition. Units: none.");
  prm.leave_subsection();
}

StopConditions parse_stop(dealii::ParameterHandler &prm)
{
  StopConditions stop;
  prm.enter_subsection("Stop");
  stop.end_time = prm.get_double("End time");
  const double strain = prm.get_double("Axial strain");
  const double packing = prm.get_double("Packing fraction");
  prm.leave_subsection();
  if (strain > 0)
    stop.axial_strain = strain;
  if (packing > 0)
    stop.packing_fraction = packing;
  return stop;
}
} // namespace

SceneParameters::SceneParameters(const SceneNames &names, const LawCatalogue &laws)
    : materials(names.materials, laws), bodies(names.bodies), walls(names.walls)
{
}

void SceneParameters::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  materials.declare_parameters(prm);
  bodies.declare_parameters(prm);
  PackingParameters::declare_parameters(prm);
  walls.declare_parameters(prm);
  prm.enter_subsection("Contact");
  prm.declare_entry("Friction", "0", Double(0), "Coefficient of friction between bodies. Units: none.");
  prm.leave_subsection();
  prm.enter_subsection("Loads");
  prm.declare_entry("Gravity", "0, 0", List(Double(), 2, 2, ","),
                    "Acceleration of gravity, \"gx, gy\". Units: m/s^2.");
  prm.leave_subsection();
  declare_stop(prm);
}

Scene<2> SceneParameters::parse_parameters(dealii::ParameterHandler &prm) const
{
  Scene<2> scene;
  scene.materials = materials.parse_parameters(prm);
  scene.bodies = bodies.parse_parameters(prm, scene.materials);
  for (BodyDescription<2> &body : PackingParameters::parse_parameters(prm, scene.materials))
    scene.bodies.push_back(std::move(body));
  scene.walls = walls.parse_parameters(prm);
  scene.friction = prm.get_double({"Contact"}, "Friction");
  scene.gravity = pair_of_numbers(prm.get({"Loads"}, "Gravity"));
  scene.stop = parse_stop(prm);
  return scene;
}
} // namespace softgrain
