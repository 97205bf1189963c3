// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/parameters/parameter_values.h>
#include <softgrain/scene/wall_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace softgrain
{
namespace
{
/// Inward normal of a wall of the usual box.
std::string usual_normal(const std::string &name)
{
  return name == "bottom"  ? "0, 1"
         : name == "top"   ? "0, -1"
         : name == "left"  ? "1, 0"
         : name == "right" ? "-1, 0"
                           : "";
}
} // namespace

WallParameters::WallParameters(const std::vector<std::string> &names) : names(names) {}

void WallParameters::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  prm.enter_subsection("Walls");
  prm.declare_entry("Names", "", List(Anything()),
                    "Names of the walls; each has a subsection of its name. The names bottom, top, left and "
                    "right know their normal; axial strain and packing fraction are measured between them.");
  for (const std::string &name : names)
  {
    prm.enter_subsection(name);
    prm.declare_entry(
        "Type", "plane", Selection("plane|material points"),
        "plane: an exact plane; material points: a rigid slab of material points, as in the thesis.");
    prm.declare_entry("Point", "0, 0", List(Double(), 2, 2, ","),
                      "A point of the plane at the start. Units: m.");
    prm.declare_entry("Normal", usual_normal(name), List(Double(), 0, 2, ","),
                      "Normal that points to the bodies, of any length; may be left out for bottom, top, "
                      "left and right. Units: none.");
    prm.declare_entry("Velocity", "0", Anything(),
                      "Velocity along the normal, positive towards the bodies; a formula of t "
                      "(doc/formulas.md). Units: m/s.");
    prm.declare_entry("Drive", "velocity", Selection("velocity|pressure"),
                      "velocity: the wall moves as 'Velocity' says; pressure: it has a 'Mass' and moves "
                      "along its normal under 'Pressure'.");
    prm.declare_entry("Pressure", "0", Anything(),
                      "With 'Drive = pressure': pressure towards the bodies, acting on the length between "
                      "the walls beside it; a formula of t (doc/formulas.md). Units: Pa.");
    prm.declare_entry("Mass", "0", Double(0), "With 'Drive = pressure': mass of the wall. Units: kg/m.");
    prm.declare_entry(
        "Damping", "0", Double(0),
        "With 'Drive = pressure': force that resists the motion, per velocity. Units: kg/(m s).");
    prm.declare_entry("Friction", "0", Double(0),
                      "Coefficient of friction between the wall and bodies. Units: none.");
    prm.leave_subsection();
  }
  prm.leave_subsection();
}

std::vector<WallDescription<2>> WallParameters::parse_parameters(dealii::ParameterHandler &prm) const
{
  std::vector<WallDescription<2>> walls;
  prm.enter_subsection("Walls");
  for (const std::string &name : names)
  {
    prm.enter_subsection(name);
    WallDescription<2> wall;
    wall.name = name;
    wall.type = prm.get("Type") == "plane" ? WallDescription<2>::Type::plane
                                           : WallDescription<2>::Type::material_points;
    wall.point = dealii::Point<2>(pair_of_numbers(prm.get("Point")));
    const std::string written = prm.get("Normal");
    const std::string normal = written.empty() ? usual_normal(name) : written;
    if (normal.empty())
      throw InputError("'Walls/" + name +
                       "/Normal' is missing; only bottom, top, left and right know theirs");
    if (normal.find(',') == std::string::npos)
      throw InputError("'Walls/" + name + "/Normal' = '" + normal +
                       "' is not allowed: it must be two numbers \"x, y\"");
    wall.normal = pair_of_numbers(normal);
    if (wall.normal.norm() == 0)
      throw InputError("'Walls/" + name + "/Normal' = '" + normal + "' is not allowed: it must not be zero");
    wall.normal /= wall.normal.norm();
    wall.velocity = prm.get("Velocity");
    wall.friction = prm.get_double("Friction");
    if (prm.get("Drive") == "pressure")
    {
      wall.pressure = prm.get("Pressure");
      wall.mass = prm.get_double("Mass");
      wall.damping = prm.get_double("Damping");
      if (!(wall.mass > 0.))
        throw InputError("'Walls/" + name + "/Mass' = '" + prm.get("Mass") +
                         "' is not allowed with 'Drive' = 'pressure': it must be greater than 0");
      if (wall.velocity != "0")
        throw InputError("'Walls/" + name + "/Velocity' = '" + wall.velocity +
                         "' has no effect with 'Drive' = 'pressure': leave it out");
    }
    else
      for (const char *key : {"Pressure", "Mass", "Damping"})
        if (prm.get(key) != "0")
          throw InputError("'Walls/" + name + "/" + key + "' = '" + prm.get(key) +
                           "' has no effect without 'Drive' = 'pressure'");
    walls.push_back(wall);
    prm.leave_subsection();
  }
  prm.leave_subsection();
  return walls;
}
} // namespace softgrain
