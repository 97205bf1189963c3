// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/geometry/shape_pairs.h>
#include <softgrain/scene/cell_checks.h>
#include <softgrain/scene/contact_pairs.h>
#include <softgrain/scene/obstacle_parameters.h>
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
  const dealii::Point<2> place = body.shape->some_place();
  const double x = place[0], y = place[1];
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

/// A driven body moves as one: what would turn or deform it would be left out without a word.
void check_drive(const BodyDescription<2> &body)
{
  if (!body.driven)
    return;
  const std::string path = "'Bodies/" + body.name;
  if (body.angular_velocity != 0.)
    throw InputError(path + "/Angular velocity' = '" + number(body.angular_velocity) +
                     "' is not allowed with " + path +
                     "/Driven' = 'true': a driven body does not turn; leave it at 0");
  // Three places that no symmetry connects.
  const double places[3][2] = {{0.31, 0.17}, {-0.23, 0.41}, {0.07, -0.37}}, width = body.shape->size();
  for (const Expression &component : vector_expression(body.velocity, {"x", "y"}))
    for (const auto &place : places)
      if (component({body.center[0] + width * place[0], body.center[1] + width * place[1]}) !=
          component({body.center[0], body.center[1]}))
        throw InputError(path + "/Velocity' = '" + body.velocity + "' is not allowed with " + path +
                         "/Driven' = 'true': a driven body moves as one, give the same velocity everywhere");
}

void check_inside(const BodyDescription<2> &body, const WallDescription<2> &wall)
{
  const auto distances = body.shape->distances_from_plane(wall.point, wall.normal);
  const double tolerance = touching * body.shape->size();
  if (distances.second <= tolerance)
    throw InputError("body '" + body.name + "' lies behind the wall '" + wall.name +
                     "'; its normal must point to the bodies");
  if (distances.first < -tolerance)
    throw InputError("body '" + body.name + "' crosses the wall '" + wall.name + "' by " +
                     number(-distances.first) + " m");
}

/// No place of an obstacle may be inside of a body at the start; places a hundredth of the body apart are
/// looked at.
void check_outside(const BodyDescription<2> &body, const ObstacleDescription<2> &obstacle)
{
  const Pose<2> pose = pose_of(obstacle, 0.);
  const double size = body.shape->size(), tolerance = touching * size;
  const auto box = body.shape->bounding_box();
  // Chords lie up to half a thousandth of an arc's radius off it.
  const auto in_box = [&](const dealii::Point<2> &p, const double margin)
  {
    return p[0] > box.first[0] - margin && p[0] < box.second[0] + margin && p[1] > box.first[1] - margin &&
           p[1] < box.second[1] + margin;
  };
  for (const Curve &piece : obstacle.pieces)
  {
    const Polygon line = piece.line(0.06);
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      const dealii::Point<2> from = pose.placed(line[i]);
      const dealii::Tensor<1, 2> edge = pose.placed(line[i + 1]) - from;
      const unsigned int n = 1 + static_cast<unsigned int>(std::min(1e5, edge.norm() / (0.01 * size)));
      for (unsigned int k = 0; k <= n; ++k)
      {
        const dealii::Point<2> on_chord = from + (static_cast<double>(k) / n) * edge;
        if (!in_box(on_chord, 0.01 * edge.norm()))
          continue;
        const dealii::Point<2> p = pose.placed(piece.foot(pose.drawn(on_chord)).place);
        if (in_box(p, 0.) && body.shape->depth(p) > tolerance)
          throw InputError("the obstacle '" + obstacle.name + "' crosses body '" + body.name + "' at (" +
                           number(p[0]) + ", " + number(p[1]) + ") m at the start");
      }
    }
  }
}

void check_walls(const std::vector<WallDescription<2>> &walls)
{
  for (auto a = walls.begin(); a != walls.end(); ++a)
    for (auto b = walls.begin(); b != a; ++b)
      if (a->normal * b->normal < -1 + 1e-12 && (a->point - b->point) * b->normal <= 0)
        throw InputError("the walls '" + b->name + "' and '" + a->name +
                         "' leave no room between them: " + number((a->point - b->point) * b->normal) + " m");
}

/// Bodies may touch at the start, but not overlap: directly or through the sides of a cell.
void check_bodies_apart(const Scene<2> &scene)
{
  std::vector<const Shape<2> *> shapes;
  for (const BodyDescription<2> &body : scene.bodies)
    shapes.push_back(body.shape.get());
  if (const auto found = find_overlap<2>(shapes, cell_of(scene), touching))
    throw InputError("the bodies '" + scene.bodies[found->first].name + "' and '" +
                     scene.bodies[found->second].name + "' overlap at the start" +
                     (overlap(*shapes[found->first], *shapes[found->second], 0.)
                          ? ""
                          : ", through a side of the cell that repeats"));
}
} // namespace

void check_scene(const Scene<2> &scene)
{
  if (scene.bodies.empty() && !scene.packing.method)
    throw InputError("there is nothing to compute: 'Bodies/Names' is empty");
  // Each step needs the ones before it: a body that has no shape does not lie anywhere.
  Mistakes mistakes;
  for (const BodyDescription<2> &body : scene.bodies)
  {
    if (mistakes.attempt([&]() { body.shape->check("Bodies/" + body.name); }))
      mistakes.attempt(
          [&]()
          {
            check_formulas(body);
            check_drive(body);
          });
  }
  mistakes.attempt([&]() { check_walls(scene.walls); });
  mistakes.attempt([&]() { (void) ContactPairs(scene); }); // whether its tables agree with themselves
  mistakes.attempt([&]() { check_sides(scene.walls); });
  mistakes.attempt([&]() { check_loads_in_cell(scene); });
  mistakes.end();
  // Of each wall and each obstacle the first body: often one place is wrong, and many bodies lie beyond it.
  for (const WallDescription<2> &wall : scene.walls)
    if (!repeats(wall))
      mistakes.attempt(
          [&]()
          {
            for (const BodyDescription<2> &body : scene.bodies)
              check_inside(body, wall);
          });
  mistakes.end();
  check_cell(scene);
  for (const ObstacleDescription<2> &obstacle : scene.obstacles)
    mistakes.attempt(
        [&]()
        {
          for (const BodyDescription<2> &body : scene.bodies)
            check_outside(body, obstacle);
        });
  mistakes.end();
  check_bodies_apart(scene);
}
} // namespace softgrain
