// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/scene/body_geometry.h>
#include <softgrain/scene/scene_checks.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain
{
namespace
{
/// Part of a body's size that counts as touching.
constexpr double touching = 1e-9;

std::string number(const double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

double size_of(const BodyDescription<2> &body)
{
  const auto box = bounding_box(body);
  return box.first.distance(box.second);
}

void check_shape(const BodyDescription<2> &body)
{
  const std::string path = "'Bodies/" + body.name + "/";
  if (body.shape == BodyShape::disk)
  {
    if (!(body.radius > 0))
      throw InputError(path + "Radius' = '" + number(body.radius) +
                       "' leaves the body empty: it must be greater than 0");
    if (body.inner_radius >= body.radius)
      throw InputError(path + "Inner radius' = '" + number(body.inner_radius) +
                       "' leaves the body empty: it must be less than Radius = " + number(body.radius));
  }
  else if (body.shape == BodyShape::rectangle)
  {
    if (!(body.size[0] > 0 && body.size[1] > 0))
      throw InputError(path + "Size' = '" + number(body.size[0]) + ", " + number(body.size[1]) +
                       "' leaves the body empty: both must be greater than 0");
  }
  else
  {
    const std::string vertices = path + "Vertices'";
    if (body.vertices.size() < 3)
      throw InputError(vertices + " has " + std::to_string(body.vertices.size()) +
                       " points: a polygon needs at least 3");
    if (crosses_itself(body.vertices))
      throw InputError(vertices + ": the polygon crosses itself");
    const double size = size_of(body);
    if (!(std::abs(signed_area(body.vertices)) > touching * size * size))
      throw InputError(vertices + ": the polygon encloses no area, the body is empty");
    for (std::size_t i = 0; i < body.vertices.size(); ++i)
      if (body.vertices[i].distance(body.vertices[(i + 1) % body.vertices.size()]) <= touching * size)
        throw InputError(vertices + ": point " + std::to_string(i + 1) + " is the same as the next one");
  }
}

void check_finite(const std::string &path,
                  const std::vector<Expression> &formulas,
                  const std::vector<double> &at)
{
  for (const Expression &formula : formulas)
    if (!std::isfinite(formula(at)))
      throw InputError("'" + path + "': '" + formula.text() + "' is not finite at the start");
}

/// A formula that does not parse is reported with the parameter it stands in.
template <typename Parse>
std::vector<Expression> parse_at(const std::string &path, const Parse &parse)
{
  try
  {
    return parse();
  }
  catch (const InputError &error)
  {
    throw InputError("'" + path + "': " + error.what());
  }
}

void check_formulas(const BodyDescription<2> &body)
{
  // A place in the body; the centre of a ring is not.
  const double middle = body.inner_radius > 0. ? 0.5 * (body.inner_radius + body.radius) : 0.;
  const double x = body.shape == BodyShape::polygon ? body.vertices[0][0]
                   : body.shape == BodyShape::disk  ? body.center[0] + middle
                                                    : body.center[0];
  const double y = body.shape == BodyShape::polygon ? body.vertices[0][1] : body.center[1];
  const std::string velocity = "Bodies/" + body.name + "/Velocity";
  check_finite(velocity,
               parse_at(velocity,
                        [&] {
                          return vector_expression(body.velocity, {"x", "y"});
                        }),
               {x, y});
  const std::string force = "Bodies/" + body.name + "/Body force";
  check_finite(force,
               parse_at(force,
                        [&] {
                          return vector_expression(body.body_force, {"x", "y", "X", "Y", "t"});
                        }),
               {x, y, x, y, 0.});
}

void check_inside(const BodyDescription<2> &body, const WallDescription<2> &wall)
{
  const auto distances = distances_from_plane(body, wall.point, wall.normal);
  const double tolerance = touching * size_of(body);
  if (distances.second <= tolerance)
    throw InputError("body '" + body.name + "' lies behind the wall '" + wall.name +
                     "'; its normal must point to the bodies");
  if (distances.first < -tolerance)
    throw InputError("body '" + body.name + "' crosses the wall '" + wall.name + "' by " +
                     number(-distances.first) + " m");
}

void check_walls(const std::vector<WallDescription<2>> &walls)
{
  for (auto a = walls.begin(); a != walls.end(); ++a)
    for (auto b = walls.begin(); b != a; ++b)
      if (a->normal * b->normal < -1 + 1e-12 && (a->point - b->point) * b->normal <= 0)
        throw InputError("the walls '" + b->name + "' and '" + a->name +
                         "' leave no room between them: " + number((a->point - b->point) * b->normal) + " m");
}

void check_bodies_apart(const std::vector<BodyDescription<2>> &bodies)
{
  for (auto a = bodies.begin(); a != bodies.end(); ++a)
    for (auto b = bodies.begin(); b != a; ++b)
      if (overlap(*a, *b, touching * std::max(size_of(*a), size_of(*b))))
        throw InputError("the bodies '" + b->name + "' and '" + a->name + "' overlap at the start");
}
} // namespace

void check_scene(const Scene<2> &scene)
{
  if (scene.bodies.empty())
    throw InputError("there is nothing to compute: 'Bodies/Names' is empty");
  for (const BodyDescription<2> &body : scene.bodies)
  {
    check_shape(body);
    check_formulas(body);
  }
  check_walls(scene.walls);
  for (const WallDescription<2> &wall : scene.walls)
    for (const BodyDescription<2> &body : scene.bodies)
      check_inside(body, wall);
  check_bodies_apart(scene.bodies);
}
} // namespace softgrain
