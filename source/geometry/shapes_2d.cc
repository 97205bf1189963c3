// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/shapes_2d.h>
#include <softgrain/parameters/parameter_values.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>

namespace softgrain
{
namespace
{
using namespace dealii::Patterns;

/// Part of a body's size that counts as touching.
constexpr double touching = 1e-9;

std::string number(const double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}
} // namespace

void Disk2D::declare_parameters(dealii::ParameterHandler &prm) const
{
  prm.declare_entry("Radius", "0", Double(0), "Radius of a disk. Units: m.");
  prm.declare_entry("Inner radius", "0", Double(0), "Radius of the hole of a ring; 0: no hole. Units: m.");
}

void Disk2D::parse_parameters(const dealii::ParameterHandler &prm, const Place &body_center)
{
  center = body_center;
  radius = prm.get_double("Radius");
  inner_radius = prm.get_double("Inner radius");
}

void Disk2D::check(const std::string &body) const
{
  if (!(radius > 0))
    throw InputError("'" + body + "/Radius' = '" + number(radius) +
                     "' leaves the body empty: it must be greater than 0");
  if (inner_radius >= radius)
    throw InputError("'" + body + "/Inner radius' = '" + number(inner_radius) +
                     "' leaves the body empty: it must be less than Radius = " + number(radius));
}

std::vector<Polygon> Disk2D::outline(const double spacing) const
{
  std::vector<Polygon> loops = {circle(center, radius, spacing, false)};
  if (inner_radius > 0.)
    loops.push_back(circle(center, inner_radius, spacing, true));
  return loops;
}

Shape<2>::Place Disk2D::project(const Place &on_edge, const Place &vertex) const
{
  const dealii::Tensor<1, 2> ray = on_edge - center;
  return center + ray * (vertex.distance(center) / ray.norm());
}

double Disk2D::area() const
{
  return dealii::numbers::PI * (radius * radius - inner_radius * inner_radius);
}

std::pair<double, double> Disk2D::distances_from_plane(const Place &point,
                                                       const dealii::Tensor<1, 2> &normal) const
{
  const double distance = (center - point) * normal;
  return {distance - radius, distance + radius};
}

double Disk2D::depth(const Place &p) const
{
  const double r = p.distance(center);
  return inner_radius > 0. ? std::min(radius - r, r - inner_radius) : radius - r;
}

Shape<2>::Place Disk2D::some_place() const
{
  // The centre of a ring is none.
  return {center[0] + (inner_radius > 0. ? 0.5 * (inner_radius + radius) : 0.), center[1]};
}

void Disk2D::describe(std::ostream &out, const Place &) const
{
  out << "disk " << radius << ' ' << inner_radius << ';';
}

std::vector<double> Disk2D::numbers() const
{
  return {center[0], center[1], radius, inner_radius};
}

std::vector<Polygon> Polygonal2D::outline(const double spacing) const
{
  return {subdivide(corners(), spacing)};
}

double Polygonal2D::area() const
{
  return signed_area(corners());
}

double Polygonal2D::depth(const Place &p) const
{
  const Polygon polygon = corners();
  return (is_inside(p, polygon) ? 1. : -1.) * distance_to_boundary(p, polygon);
}

void Rectangle2D::declare_parameters(dealii::ParameterHandler &prm) const
{
  prm.declare_entry("Size", "0, 0", List(Double(0), 2, 2, ","),
                    "Edge lengths of a rectangle, \"width, height\". Units: m.");
  prm.declare_entry("Angle", "0", Double(-360, 360),
                    "Rotation of a rectangle or an ellipse, counter-clockwise. Units: degrees.");
}

void Rectangle2D::parse_parameters(const dealii::ParameterHandler &prm, const Place &body_center)
{
  center = body_center;
  edges = pair_of_numbers(prm.get("Size"));
  angle = prm.get_double("Angle") * dealii::numbers::PI / 180.;
}

void Rectangle2D::check(const std::string &body) const
{
  if (!(edges[0] > 0 && edges[1] > 0))
    throw InputError("'" + body + "/Size' = '" + number(edges[0]) + ", " + number(edges[1]) +
                     "' leaves the body empty: both must be greater than 0");
}

std::vector<Polygon> Rectangle2D::outline(const double spacing) const
{
  const dealii::Tensor<1, 2> e({std::cos(angle), std::sin(angle)}), f({-e[1], e[0]});
  const dealii::Tensor<1, 2> a = 0.5 * edges[0] * e, b = 0.5 * edges[1] * f;
  return {subdivide({center - a - b, center + a - b, center + a + b, center - a + b}, spacing)};
}

Polygon Rectangle2D::corners() const
{
  Polygon result;
  for (const auto &[sx, sy] : {std::pair(-.5, -.5), {.5, -.5}, {.5, .5}, {-.5, .5}})
  {
    const double x = sx * edges[0], y = sy * edges[1];
    const double c = std::cos(angle), s = std::sin(angle);
    result.emplace_back(center[0] + c * x - s * y, center[1] + s * x + c * y);
  }
  return result;
}

void Polygon2D::declare_parameters(dealii::ParameterHandler &prm) const
{
  prm.declare_entry("Vertices", "", List(List(Double(), 2, 2, ","), 0, List::max_int_value, ";"),
                    "Corners of a polygon in order, \"x1, y1; x2, y2; ...\". Units: m.");
}

void Polygon2D::parse_parameters(const dealii::ParameterHandler &prm, const Place &)
{
  for (const dealii::Tensor<1, 2> &vertex : list_of_vectors<2>(prm.get("Vertices")))
    vertices.emplace_back(vertex);
}

void Polygon2D::check(const std::string &body) const
{
  const std::string path = "'" + body + "/Vertices'";
  if (vertices.size() < 3)
    throw InputError(path + " has " + std::to_string(vertices.size()) +
                     " points: a polygon needs at least 3");
  if (crosses_itself(vertices))
    throw InputError(path + ": the polygon crosses itself");
  if (!(std::abs(signed_area(vertices)) > touching * size() * size()))
    throw InputError(path + ": the polygon encloses no area, the body is empty");
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (vertices[i].distance(vertices[(i + 1) % vertices.size()]) <= touching * size())
      throw InputError(path + ": point " + std::to_string(i + 1) + " is the same as the next one");
}

Polygon Polygon2D::corners() const
{
  Polygon result = vertices;
  if (signed_area(result) < 0)
    std::reverse(result.begin(), result.end());
  return result;
}

namespace
{
[[maybe_unused]] const bool registered[] = {
    Registry<Shape<2>>::instance().add(
        "disk", "Center, Radius, and Inner radius for a ring", [] { return std::make_unique<Disk2D>(); }),
    Registry<Shape<2>>::instance().add(
        "rectangle", "Center, Size, Angle", [] { return std::make_unique<Rectangle2D>(); }),
    Registry<Shape<2>>::instance().add("polygon", "Vertices", [] { return std::make_unique<Polygon2D>(); })};
} // namespace
} // namespace softgrain
