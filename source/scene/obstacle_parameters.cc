// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/parameters/parameter_values.h>
#include <softgrain/parameters/within_section.h>
#include <softgrain/scene/obstacle_drive.h>
#include <softgrain/scene/obstacle_parameters.h>
#include <softgrain/scene/solid_obstacles.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain
{
namespace
{
using namespace dealii::Patterns;

constexpr double degree = dealii::numbers::PI / 180.;

const std::vector<std::string> of_segments = {"Points"}, of_arc = {"Center", "Radius", "From", "To"};

void declare(dealii::ParameterHandler &prm)
{
  prm.declare_entry(
      "Shape", "segments", Selection("segments|arc"),
      "segments: straight lines from one of 'Points' to the next; arc: of a circle about 'Center' "
      "with 'Radius', counter-clockwise from 'From' to 'To'. Both have two sides.");
  prm.declare_entry("Points", "", List(List(Double(), 2, 2, ","), 0, List::max_int_value, ";"),
                    "Corners of the line in order, \"x1, y1; x2, y2; ...\". Units: m.");
  prm.declare_entry("Center", "0, 0", List(Double(), 2, 2, ","), "Center of an arc. Units: m.");
  prm.declare_entry("Radius", "0", Double(0), "Radius of an arc. Units: m.");
  prm.declare_entry("From", "0", Double(-360, 360), "Direction in which an arc begins. Units: degrees.");
  prm.declare_entry("To", "360", Double(-360, 720),
                    "Direction in which it ends, above 'From' by at most 360. Units: degrees.");
  prm.declare_entry("Displacement", "0; 0", Anything(),
                    "How far it has gone, formulas (doc/formulas.md) of t: \"ux; uy\". Units: m.");
  prm.declare_entry(
      "Angle", "0", Anything(),
      "How far it has turned about 'Pivot', counter-clockwise; a formula of t. Units: degrees.");
  prm.declare_entry("Pivot", "0, 0", List(Double(), 2, 2, ","),
                    "Place about which it turns, and about which its torque is taken; it goes with "
                    "'Displacement'. Units: m.");
  prm.declare_entry("Friction", "0", Double(0),
                    "Coefficient of friction between the obstacle and bodies; see 'Contact/Friction at "
                    "walls', too. Units: none.");
}

void check_unused(const dealii::ParameterHandler &prm,
                  const std::string &where,
                  const std::vector<std::string> &others)
{
  check_unused_by_shape(prm, where, others, declare);
}

std::vector<Curve> segments(const dealii::ParameterHandler &prm, const std::string &where)
{
  check_unused(prm, where, of_arc);
  const std::vector<dealii::Tensor<1, 2>> corners = list_of_vectors<2>(prm.get("Points"));
  if (corners.size() < 2)
    throw InputError("'" + where + "/Points' has " + std::to_string(corners.size()) +
                     " points: a line needs at least 2");
  std::vector<Curve> pieces;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
  {
    if (!((corners[i + 1] - corners[i]).norm() > 0.))
      throw InputError("'" + where + "/Points': point " + std::to_string(i + 1) +
                       " is the same as the next one");
    pieces.push_back(Curve::segment(dealii::Point<2>(corners[i]), dealii::Point<2>(corners[i + 1])));
  }
  return pieces;
}

std::vector<Curve> arc(const dealii::ParameterHandler &prm, const std::string &where)
{
  check_unused(prm, where, of_segments);
  const double radius = prm.get_double("Radius"), from = prm.get_double("From"), to = prm.get_double("To");
  if (!(radius > 0.))
    throw InputError("'" + where + "/Radius' = '" + prm.get("Radius") +
                     "' is not allowed: it must be greater than 0");
  if (!(to > from) || to - from > 360.)
    throw InputError("'" + where + "/To' = '" + prm.get("To") +
                     "' is not allowed: it must be greater than 'From' = '" + prm.get("From") +
                     "', by at most 360");
  return {
      Curve::arc(dealii::Point<2>(pair_of_numbers(prm.get("Center"))), radius, degree * from, degree * to)};
}

/// Both formulas of 'Displacement'; a semicolon stands between them.
std::vector<Expression> displacement(const std::string &text, const std::string &parameter)
{
  const auto middle = text.find(';');
  if (middle == std::string::npos || text.find(';', middle + 1) != std::string::npos)
    throw InputError("'" + parameter + "' = '" + text +
                     "' is not allowed: it must be two formulas \"ux; uy\"");
  return {formula_of_time(text.substr(0, middle), parameter),
          formula_of_time(text.substr(middle + 1), parameter)};
}

ObstacleDescription<2> parse_line(const dealii::ParameterHandler &prm, const std::string &name)
{
  const std::string where = "Obstacles/" + name;
  ObstacleDescription<2> obstacle;
  obstacle.name = name;
  obstacle.pieces = prm.get("Shape") == "arc" ? arc(prm, where) : segments(prm, where);
  obstacle.pivot = dealii::Point<2>(pair_of_numbers(prm.get("Pivot")));
  obstacle.motion = displacement(prm.get("Displacement"), where + "/Displacement");
  obstacle.motion.push_back(formula_of_time(prm.get("Angle"), where + "/Angle"));
  obstacle.friction = prm.get_double("Friction");
  return obstacle;
}
} // namespace

void check_unused_by_shape(const dealii::ParameterHandler &prm,
                           const std::string &where,
                           const std::vector<std::string> &others,
                           void (*declare)(dealii::ParameterHandler &))
{
  dealii::ParameterHandler fresh;
  declare(fresh);
  for (const std::string &name : others)
    if (const std::string unset = fresh.get(name); prm.get(name) != unset)
      throw InputError("'" + where + "/" + name + "' = '" + prm.get(name) +
                       "' has no effect with 'Shape' = '" + prm.get("Shape") + "': leave it out" +
                       (unset.empty() ? "" : ", or set it to '" + unset + "'"));
}

ObstacleParameters::ObstacleParameters(const std::vector<std::string> &names, const unsigned int dimension)
    : names(names), dimension(dimension)
{
}

void ObstacleParameters::declare_parameters(dealii::ParameterHandler &prm) const
{
  prm.enter_subsection("Obstacles");
  prm.declare_entry("Names", "", List(Anything()),
                    dimension == 3
                        ? "Names of the obstacles: rigid sheets, tubes, cones or triangles; each has a "
                          "subsection of its name."
                        : "Names of the obstacles: rigid lines of finite length, straight or round; each has "
                          "a subsection of its name.");
  for (const std::string &name : names)
  {
    prm.enter_subsection(name);
    if (dimension == 3)
      declare_solid_obstacle(prm);
    else
      declare(prm);
    declare_obstacle_drive(prm);
    prm.leave_subsection();
  }
  prm.leave_subsection();
}

template <int dim>
std::vector<ObstacleDescription<dim>>
ObstacleParameters::parse_parameters(dealii::ParameterHandler &prm) const
{
  std::vector<ObstacleDescription<dim>> obstacles;
  const auto parse_one = [&](const std::string &name)
  {
    const WithinSection section(prm, name);
    if constexpr (dim == 3)
      obstacles.push_back(parse_solid_obstacle(prm, name));
    else
      obstacles.push_back(parse_line(prm, name));
    obstacles.back().drive = parse_obstacle_drive(prm, "Obstacles/" + name);
  };
  Mistakes mistakes;
  const WithinSection section(prm, "Obstacles");
  for (const std::string &name : names)
    mistakes.attempt([&]() { parse_one(name); });
  mistakes.end();
  return obstacles;
}

template <>
dealii::Tensor<1, 2> Pose<2>::turned(const dealii::Tensor<1, 2> &v, const double by) const
{
  const double c = std::cos(by), s = std::sin(by);
  return dealii::Tensor<1, 2>({c * v[0] - s * v[1], s * v[0] + c * v[1]});
}

template <>
dealii::Tensor<1, 3> Pose<3>::turned(const dealii::Tensor<1, 3> &v, const double by) const
{
  const double c = std::cos(by), s = std::sin(by);
  return c * v + s * dealii::cross_product_3d(axis, v) + (1. - c) * (axis * v) * axis;
}

template <int dim>
Pose<dim> pose_of(const ObstacleDescription<dim> &obstacle, const double time)
{
  Pose<dim> pose;
  pose.pivot = obstacle.pivot;
  if constexpr (dim == 3)
    pose.axis = obstacle.axis;
  for (unsigned int d = 0; d < dim; ++d)
    pose.shift[d] = obstacle.motion[d]({time});
  pose.angle = degree * obstacle.motion[dim]({time});
  if (!std::isfinite(pose.shift.norm() + pose.angle))
  {
    std::ostringstream text;
    text << "the motion of obstacle '" << obstacle.name << "' is not finite at t = " << time << " s";
    throw ComputationError(text.str());
  }
  return pose;
}

template std::vector<ObstacleDescription<2>>
ObstacleParameters::parse_parameters<2>(dealii::ParameterHandler &) const;
template std::vector<ObstacleDescription<3>>
ObstacleParameters::parse_parameters<3>(dealii::ParameterHandler &) const;
template Pose<2> pose_of(const ObstacleDescription<2> &, double);
template Pose<3> pose_of(const ObstacleDescription<3> &, double);
} // namespace softgrain
