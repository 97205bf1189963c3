// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/parameters/parameter_values.h>
#include <softgrain/parameters/within_section.h>
#include <softgrain/scene/wall_drive.h>
#include <softgrain/scene/wall_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace softgrain
{
namespace
{
const std::string before = "as before";
const char *const sliding = "Tangential velocity";
const char *const shearing = "Shear stress";

/// Inward normal of a wall of the usual box.
std::string usual_normal(const std::string &name, const unsigned int dimension)
{
  if (dimension == 3)
    return name == "bottom"  ? "0, 0, 1"
           : name == "top"   ? "0, 0, -1"
           : name == "left"  ? "1, 0, 0"
           : name == "right" ? "-1, 0, 0"
           : name == "front" ? "0, 1, 0"
           : name == "back"  ? "0, -1, 0"
                             : "";
  return name == "bottom"  ? "0, 1"
         : name == "top"   ? "0, -1"
         : name == "left"  ? "1, 0"
         : name == "right" ? "-1, 0"
                           : "";
}

/// What a drive declares: names and defaults.
std::vector<ParameterEntry> parameters_of(const std::string &drive)
{
  dealii::ParameterHandler own;
  Registry<WallDrive>::instance().create(drive)->declare_parameters(own);
  return parameter_tree(own).entries;
}
} // namespace

WallParameters::WallParameters(const std::vector<std::string> &names, const unsigned int dimension)
    : names(names), dimension(dimension)
{
}

void WallParameters::declare_drive(dealii::ParameterHandler &prm, const bool as_before)
{
  const Registry<WallDrive> &drives = Registry<WallDrive>::instance();
  using dealii::Patterns::Selection;
  if (as_before)
    prm.declare_entry(
        "Drive", before, Selection(before + "|" + drives.choice()),
        "How the wall is driven from now on; formulas count the time t, and 'Position' the way, "
        "from the start of the stage. " +
            before + ": nothing changes; " + drives.choice_in_words());
  else
    prm.declare_entry("Drive", "velocity", Selection(drives.choice()), drives.choice_in_words());
  for (const std::string &drive : drives.names())
    drives.create(drive)->declare_parameters(prm);
  prm.declare_entry(
      sliding, "0", dealii::Patterns::Anything(),
      "Velocity along the tangent, which is the normal turned by -90 degrees: towards +x at the "
      "bottom, -x at the top; in space it is the direction of the wall nearest to +x, or to +y where the "
      "wall looks along x. Bodies feel it by friction, or, with 'Type = periodic', because "
      "their images move; a formula of t (doc/formulas.md). Units: m/s.");
  prm.declare_entry(
      shearing, "0", dealii::Patterns::Anything(),
      "Stress along the tangent, on the length between the walls beside it: the wall is free to "
      "move that way, with the mass of a free wall, and bodies resist it by friction, or, with "
      "'Type = periodic', as images of each other. 0: it is not free. A formula of t "
      "(doc/formulas.md). Units: Pa.");
}

std::shared_ptr<const WallDrive> WallParameters::parse_drive(const dealii::ParameterHandler &prm,
                                                             const std::string &wall)
{
  const Registry<WallDrive> &drives = Registry<WallDrive>::instance();
  const std::string chosen = prm.get("Drive");
  std::shared_ptr<WallDrive> drive;
  std::vector<ParameterEntry> own;
  if (chosen != before)
  {
    drive = drives.create(chosen);
    drive->parse_parameters(prm, wall);
    own = parameters_of(chosen);
    if (prm.get(sliding) != "0")
      drive->slide(formula_of_time(prm.get(sliding), wall + "/" + sliding));
    if (prm.get(shearing) != "0")
      drive->shear(formula_of_time(prm.get(shearing), wall + "/" + shearing));
    if (drive->slides() && drive->shears())
      throw InputError("'" + wall + "/" + shearing + "' = '" + prm.get(shearing) +
                       "' is not allowed beside '" + sliding + "': leave out one of them");
  }
  else
    for (const char *const key : {sliding, shearing})
      if (prm.get(key) != "0")
        throw InputError("'" + wall + "/" + key + "' = '" + prm.get(key) +
                         "' has no effect with 'Drive' = '" + before + "': choose a drive");
  for (const std::string &other : drives.names())
    for (const ParameterEntry &entry : parameters_of(other))
      if (prm.get(entry.name) != entry.default_value &&
          std::none_of(own.begin(), own.end(),
                       [&entry](const ParameterEntry &mine) { return mine.name == entry.name; }))
        throw InputError("'" + wall + "/" + entry.name + "' = '" + prm.get(entry.name) +
                         "' has no effect with 'Drive' = '" + chosen + "': leave it out, or choose '" +
                         other + "'");
  return drive;
}

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
    prm.declare_entry("Type", "plane", Selection("plane|material points|periodic"),
                      "plane: an exact plane; material points: a rigid slab of material points, as in the "
                      "thesis; periodic: "
                      "with the wall that faces it a pair of sides of a cell that repeats. Bodies go through "
                      "it; it is driven "
                      "as other walls are, and the cell deforms with all that is in it.");
    prm.declare_entry("Point", dimension == 3 ? "0, 0, 0" : "0, 0", List(Double(), dimension, dimension, ","),
                      "A point of the plane at the start. Units: m.");
    prm.declare_entry(
        "Normal", usual_normal(name, dimension), List(Double(), 0, dimension, ","),
        std::string("Normal that points to the bodies, of any length; may be left out for bottom, "
                    "top, left") +
            (dimension == 3 ? ", right, front and back" : " and right") + ". Units: none.");
    declare_drive(prm, false);
    prm.declare_entry("Friction", "0", Double(0),
                      "Coefficient of friction between the wall and bodies; see 'Contact/Friction at walls', "
                      "too. Units: none.");
    prm.leave_subsection();
  }
  prm.leave_subsection();
}

template <int dim>
std::vector<WallDescription<dim>> WallParameters::parse_parameters(dealii::ParameterHandler &prm) const
{
  std::vector<WallDescription<dim>> walls;
  const auto parse_one = [&](const std::string &name)
  {
    const WithinSection section(prm, name);
    WallDescription<dim> wall;
    wall.name = name;
    const std::string type = prm.get("Type");
    wall.type = type == "plane"      ? WallDescription<dim>::Type::plane
                : type == "periodic" ? WallDescription<dim>::Type::periodic
                                     : WallDescription<dim>::Type::material_points;
    wall.point = dealii::Point<dim>(vector_of_numbers<dim>(prm.get("Point")));
    const std::string written = prm.get("Normal");
    const std::string normal = written.empty() ? usual_normal(name, dim) : written;
    if (normal.empty())
      throw InputError("'Walls/" + name + "/Normal' is missing; only bottom, top, left" +
                       (dim == 3 ? ", right, front and back" : " and right") + " know theirs");
    if (std::count(normal.begin(), normal.end(), ',') != dim - 1)
      throw InputError("'Walls/" + name + "/Normal' = '" + normal + "' is not allowed: it must be " +
                       (dim == 3 ? "three numbers \"x, y, z\"" : "two numbers \"x, y\""));
    wall.normal = vector_of_numbers<dim>(normal);
    if (wall.normal.norm() == 0)
      throw InputError("'Walls/" + name + "/Normal' = '" + normal + "' is not allowed: it must not be zero");
    wall.normal /= wall.normal.norm();
    wall.friction = prm.get_double("Friction");
    wall.drive_name = prm.get("Drive");
    wall.drive = parse_drive(prm, "Walls/" + name);
    walls.push_back(wall);
  };
  Mistakes mistakes;
  const WithinSection section(prm, "Walls");
  for (const std::string &name : names)
    mistakes.attempt([&]() { parse_one(name); });
  mistakes.end();
  return walls;
}

template std::vector<WallDescription<2>>
WallParameters::parse_parameters<2>(dealii::ParameterHandler &) const;
template std::vector<WallDescription<3>>
WallParameters::parse_parameters<3>(dealii::ParameterHandler &) const;
} // namespace softgrain
