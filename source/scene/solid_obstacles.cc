// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/revolved_surface.h>
#include <softgrain/geometry/stl_file.h>
#include <softgrain/geometry/triangle_sheet.h>
#include <softgrain/parameters/parameter_values.h>
#include <softgrain/scene/solid_obstacles.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <memory>

namespace softgrain
{
namespace
{
using namespace dealii::Patterns;

const std::vector<std::string> of_revolution = {"Points", "Center", "Axis"}, of_stl = {"File", "Unit"};

void check_unused(const dealii::ParameterHandler &prm,
                  const std::string &where,
                  const std::vector<std::string> &others)
{
  check_unused_by_shape(prm, where, others, declare_solid_obstacle);
}

dealii::Tensor<1, 3>
direction(const dealii::ParameterHandler &prm, const std::string &where, const std::string &name)
{
  const auto axis = vector_of_numbers<3>(prm.get(name));
  if (!(axis.norm() > 0.))
    throw InputError("'" + where + "/" + name + "' = '" + prm.get(name) +
                     "' is not allowed: it must have a direction");
  return axis / axis.norm();
}

std::shared_ptr<const RigidSurface>
revolved(const dealii::ParameterHandler &prm, const std::string &where, const double thickness)
{
  check_unused(prm, where, of_stl);
  std::vector<RevolvedSurface::Point2> line;
  for (const dealii::Tensor<1, 2> &point : list_of_vectors<2>(prm.get("Points")))
  {
    if (point[0] < 0.)
      throw InputError("'" + where + "/Points': point " + std::to_string(line.size() + 1) +
                       " has a negative distance from the axis; 0 or more is allowed");
    line.push_back({{point[0], point[1]}});
    if (line.size() > 1 && line.back() == line[line.size() - 2])
      throw InputError("'" + where + "/Points': point " + std::to_string(line.size() - 1) +
                       " is the same as the next one");
  }
  if (line.empty())
    throw InputError("'" + where + "/Points' is missing: it must have at least one point \"r, z\"");
  return std::make_shared<RevolvedSurface>(line, dealii::Point<3>(vector_of_numbers<3>(prm.get("Center"))),
                                           direction(prm, where, "Axis"), thickness);
}

std::shared_ptr<const RigidSurface>
from_file(const dealii::ParameterHandler &prm, const std::string &where, const double thickness)
{
  check_unused(prm, where, of_revolution);
  if (prm.get("File").empty())
    throw InputError("'" + where + "/File' is missing: with 'Shape' = 'stl' it must name a file");
  try
  {
    return std::make_shared<TriangleSheet>(read_stl(prm.get("File"), prm.get_double("Unit")), thickness);
  }
  catch (const InputError &error)
  {
    throw InputError("'" + where + "/File': " + error.what());
  }
}
} // namespace

void declare_solid_obstacle(dealii::ParameterHandler &prm)
{
  prm.declare_entry("Shape", "revolution", Selection("revolution|stl"),
                    "revolution: what the line through 'Points' makes as it turns about 'Axis': a tube, a "
                    "cone, a disk, a drum with lids; a ball is one point on the axis, a rod two; stl: the "
                    "triangles of 'File'. Both are sheets of 'Thickness', and have two sides.");
  prm.declare_entry("Points", "", List(List(Double(), 2, 2, ","), 0, List::max_int_value, ";"),
                    "Corners of the line in order, \"r1, z1; r2, z2; ...\": distance from the axis, and "
                    "height along it from 'Center'. Units: m.");
  prm.declare_entry("Center", "0, 0, 0", List(Double(), 3, 3, ","),
                    "Place on the axis from where heights are measured. Units: m.");
  prm.declare_entry("Axis", "0, 0, 1", List(Double(), 3, 3, ","),
                    "Direction of the axis of revolution. Units: none.");
  prm.declare_entry("File", "", Anything(), "STL file, binary or ASCII. It need not be closed.");
  prm.declare_entry("Unit", "1", Double(1e-12, 1e12), "Length of the unit of the file. Units: m.");
  prm.declare_entry("Thickness", "0", Double(0),
                    "Thickness of the sheet, whose edges and corners are round: half of it lies on either "
                    "side of what 'Points' or 'File' tell. At least the edge of a cell. Units: m.");
  prm.declare_entry("Displacement", "0; 0; 0", Anything(),
                    "How far it has gone, formulas (doc/formulas.md) of t: \"ux; uy; uz\". Units: m.");
  prm.declare_entry("Angle", "0", Anything(),
                    "How far it has turned about 'Turning axis', counter-clockwise when that points to the "
                    "eye; a formula of t. Units: degrees.");
  prm.declare_entry("Pivot", "0, 0, 0", List(Double(), 3, 3, ","),
                    "Place on the axis about which it turns, and about which its torque is taken; it goes "
                    "with 'Displacement'. Units: m.");
  prm.declare_entry("Turning axis", "0, 0, 1", List(Double(), 3, 3, ","),
                    "Direction of the axis about which it turns. Units: none.");
  prm.declare_entry("Friction", "0", Double(0),
                    "Coefficient of friction between the obstacle and bodies; see 'Contact/Friction at "
                    "walls', too. Units: none.");
}

ObstacleDescription<3> parse_solid_obstacle(const dealii::ParameterHandler &prm, const std::string &name)
{
  const std::string where = "Obstacles/" + name;
  ObstacleDescription<3> obstacle;
  obstacle.name = name;
  const double thickness = prm.get_double("Thickness");
  if (!(thickness > 0.))
    throw InputError("'" + where + "/Thickness' = '" + prm.get("Thickness") +
                     "' is not allowed: it must be at least the edge of a cell");
  obstacle.surface =
      prm.get("Shape") == "stl" ? from_file(prm, where, thickness) : revolved(prm, where, thickness);
  obstacle.pivot = dealii::Point<3>(vector_of_numbers<3>(prm.get("Pivot")));
  obstacle.axis = direction(prm, where, "Turning axis");
  const std::vector<std::string> ways = dealii::Utilities::split_string_list(prm.get("Displacement"), ';');
  if (ways.size() != 3)
    throw InputError("'" + where + "/Displacement' = '" + prm.get("Displacement") +
                     "' is not allowed: it must be three formulas \"ux; uy; uz\"");
  for (const std::string &way : ways)
    obstacle.motion.push_back(formula_of_time(way, where + "/Displacement"));
  obstacle.motion.push_back(formula_of_time(prm.get("Angle"), where + "/Angle"));
  obstacle.friction = prm.get_double("Friction");
  return obstacle;
}
} // namespace softgrain
