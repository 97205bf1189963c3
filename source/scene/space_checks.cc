// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/geometry/rigid_surface.h>
#include <softgrain/geometry/shape_pairs.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/scene/cell_checks.h>
#include <softgrain/scene/obstacle_parameters.h>
#include <softgrain/scene/space_checks.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain
{
namespace
{
/// Parameters that are known in space: "Section/Key", "*" for any name, and all of a section with a slash at
/// the end.
const std::vector<std::string> known = {"Dimension",
                                        "Model",
                                        "Output directory",
                                        "Additional shared libraries",
                                        "Threads",
                                        "Output/Fields every",
                                        "Output/Number of field outputs",
                                        "Output/Field parts",
                                        "Output/Snapshots every",
                                        "Output/Points in snapshots",
                                        "Output/Measures",
                                        "Output/Compression level",
                                        "Output/History every",
                                        "Output/Checkpoint every",
                                        "Output/Checkpoints kept",
                                        "Materials/",
                                        "Bodies/",
                                        "Packing/",
                                        "Loads/",
                                        "Walls/Names",
                                        "Walls/*/Type",
                                        "Walls/*/Point",
                                        "Walls/*/Normal",
                                        "Walls/*/Drive",
                                        "Walls/*/Velocity",
                                        "Walls/*/Tangential velocity",
                                        "Walls/*/Friction",
                                        "Walls/*/Position",
                                        "Walls/*/Pressure",
                                        "Walls/*/Mass",
                                        "Walls/*/Damping",
                                        "Obstacles/",
                                        "Mesh/Lower",
                                        "Mesh/Upper",
                                        "Mesh/Cell size",
                                        "Material points/Points per direction",
                                        "Material points/Fill limit",
                                        "Material points/F-bar",
                                        "Time/Scheme",
                                        "Time/Time step",
                                        "Time/Wall way",
                                        "Time/CFL multiple",
                                        "Time/Theta",
                                        "Time/Smallest step",
                                        "Newton/Residual tolerance",
                                        "Newton/Maximum iterations",
                                        "Newton/Largest strain",
                                        "Linear solver/Type",
                                        "Quasi-static/Regularisation",
                                        "Quasi-static/Unbalanced force",
                                        "Quasi-static/Held steps",
                                        "Quasi-static/Wall motion",
                                        "Contact/Sub-grid compliance",
                                        "Contact/Friction",
                                        "Contact/Friction at walls",
                                        "Contact/Friction of pairs",
                                        "Stop/",
                                        "Stages/Names",
                                        "Stages/*/*/Drive",
                                        "Stages/*/*/Velocity",
                                        "Stages/*/*/Tangential velocity",
                                        "Stages/*/*/Position",
                                        "Stages/*/*/Pressure",
                                        "Stages/*/*/Mass",
                                        "Stages/*/*/Damping",
                                        "Stages/*/Stop/"};

/// Of these what is the plane's alone: shapes have any parameters.
const std::vector<std::string> unknown = {"Bodies/*/Body force", "Bodies/*/Driven"};

/// What bonded particles know in space beside these.
const std::vector<std::string> known_to_bonded_particles = {"Output/Inner forces",
                                                            "Primaries/Smallest diameter",
                                                            "Primaries/Largest diameter",
                                                            "Primaries/Size distribution",
                                                            "Primaries/Mean diameter",
                                                            "Primaries/Standard deviation",
                                                            "Primaries/Exponent",
                                                            "Primaries/Number per body",
                                                            "Primaries/Seed",
                                                            "Primaries/Variants",
                                                            "Time/Step fraction",
                                                            "Contact/Restitution",
                                                            "Contact/Gap correction",
                                                            "Contact/Range",
                                                            "Contact/Skin",
                                                            "Contact/Largest penetration",
                                                            "Contact/Tolerance",
                                                            "Contact/Maximum sweeps",
                                                            "Contact/Relaxation",
                                                            "Contact/Algorithm",
                                                            "Contact/Wall tolerance",
                                                            "Contact/Wall floor",
                                                            "Contact/Penetration tolerance"};

/// What material points know in space, and bonded particles do not.
const std::vector<std::string> unknown_to_bonded_particles = {
    "Obstacles/",          "Walls/*/Pressure", "Walls/*/Mass",       "Walls/*/Damping",
    "Stages/*/*/Pressure", "Stages/*/*/Mass",  "Stages/*/*/Damping", "Quasi-static/"};

/// What a scheme does not know in space, beside what none does.
const std::vector<std::string> unknown_at_rest = {"Time/Theta",      "Time/CFL multiple",
                                                  "Walls/*/Mass",    "Walls/*/Damping",
                                                  "Stages/*/*/Mass", "Stages/*/*/Damping"},
                               unknown_to_inertia = {"Quasi-static/"};

bool matches(const std::vector<std::string> &path, const std::string &pattern)
{
  const std::vector<std::string> wanted = dealii::Utilities::split_string_list(pattern, "/");
  const bool whole = pattern.back() == '/';
  // A list that ends with its separator has no empty part at its end.
  if (whole ? path.size() <= wanted.size() : path.size() != wanted.size())
    return false;
  return std::equal(wanted.begin(), wanted.end(), path.begin(),
                    [](const std::string &w, const std::string &name) { return w == "*" || w == name; });
}

bool is_in(const std::vector<std::string> &patterns, const std::vector<std::string> &path)
{
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string &pattern) { return matches(path, pattern); });
}

/// Finds parameters that nothing in space knows, or that the scheme does not.
class ParameterCheck
{
public:
  ParameterCheck(const ParameterSection &parameters, Mistakes &mistakes)
      : bonded(value_in(parameters, "", "Model") == "bpm")
      , scheme(value_in(parameters, "Time", "Scheme"))
      , mistakes(mistakes)
  {
  }

  void look_at(const ParameterSection &section)
  {
    for (const ParameterEntry &entry : section.entries)
      if (entry.value != entry.default_value)
      {
        path.push_back(entry.name);
        if (is_in(unknown, path) ||
            (bonded ? !is_in(known_to_bonded_particles, path) &&
                          (!is_in(known, path) || is_in(unknown_to_bonded_particles, path))
                    : !is_in(known, path)))
          refuse(entry, "");
        else if (!bonded && is_in(scheme == "quasi_static" ? unknown_at_rest : unknown_to_inertia, path))
          refuse(entry, " and 'Time/Scheme' = '" + scheme + "'");
        path.pop_back();
      }
    for (const ParameterSection &part : section.sections)
    {
      path.push_back(part.name);
      look_at(part);
      path.pop_back();
    }
  }

private:
  void refuse(const ParameterEntry &entry, const std::string &scheme_too)
  {
    std::string name;
    for (const std::string &part : path)
      name += (name.empty() ? "" : "/") + part;
    mistakes.add(InputError("'" + name + "' = '" + entry.value + "' is not allowed with 'Dimension' = '3'" +
                            (bonded ? " and 'Model' = 'bpm'" : scheme_too) +
                            ", where it is not there yet: it must be '" + entry.default_value + "'"));
  }

  const bool bonded; ///< bonded particles, which have no schemes
  const std::string scheme;
  Mistakes &mistakes;
  std::vector<std::string> path;
};

void check_velocity(const BodyDescription<3> &body)
{
  const std::string path = "Bodies/" + body.name + "/Velocity";
  std::vector<Expression> formulas;
  try
  {
    formulas = vector_expression(body.velocity, {"x", "y", "z"}, 3);
  }
  catch (const InputError &error)
  {
    throw InputError("'" + path + "': " + error.what());
  }
  for (const Expression &component : formulas)
    if (!std::isfinite(component({body.center[0], body.center[1], body.center[2]})))
      throw InputError("'" + path + "' = '" + body.velocity + "' is not finite at the center of the body");
}

/// No place of a body may lie in an obstacle at the start; triangles a twentieth of the body wide are looked
/// at.
void check_beside(const BodyDescription<3> &body, const ObstacleDescription<3> &obstacle)
{
  const Pose<3> pose = pose_of(obstacle, 0.);
  const auto [lower, upper] = body.shape->bounding_box();
  const double size = (upper - lower).norm();
  double deepest = 0.;
  for (const dealii::Point<3> &x : body.shape->surface(0.05 * size).vertices)
    deepest = std::max(deepest, -obstacle.surface->height(pose.drawn(x), size));
  if (deepest <= 1e-9 * size)
    return;
  std::ostringstream text;
  text << "'Bodies/" << body.name << "' reaches " << deepest << " m into obstacle '" << obstacle.name
       << "': they must lie beside each other at the start";
  throw InputError(text.str());
}

void check_obstacles(const Scene<3> &scene, Mistakes &mistakes)
{
  for (const ObstacleDescription<3> &obstacle : scene.obstacles)
  {
    for (const WallDescription<3> &wall : scene.walls)
      if (wall.name == obstacle.name)
        mistakes.add(InputError("'Obstacles/Names': '" + obstacle.name +
                                "' is not allowed: a wall has this name, and columns of history.csv could "
                                "not be told apart"));
    for (const BodyDescription<3> &body : scene.bodies)
      if (!mistakes.attempt([&]() { check_beside(body, obstacle); }))
        break; // often the obstacle is wrong
  }
}

void check_cell_in_space(const Scene<3> &scene)
{
  check_sides(scene.walls);
  check_loads_in_cell(scene);
  check_cell(scene);
  std::vector<const Shape<3> *> shapes;
  for (const BodyDescription<3> &body : scene.bodies)
    shapes.push_back(body.shape.get());
  const auto found = find_overlap<3>(shapes, cell_of(scene), 0.);
  if (found && overlap(*shapes[found->first], *shapes[found->second]) <= 0.)
    throw InputError("the bodies '" + scene.bodies[found->first].name + "' and '" +
                     scene.bodies[found->second].name +
                     "' overlap at the start, through a side of the cell that repeats");
}

/// @return whether all shapes enclose something
bool check_bodies(const Scene<3> &scene, Mistakes &mistakes)
{
  std::vector<std::string> names;
  bool all_enclose = true;
  for (const BodyDescription<3> &body : scene.bodies)
  {
    names.push_back(body.name);
    if (!mistakes.attempt([&]() { body.shape->check("Bodies/" + body.name); }))
      all_enclose = false;
    mistakes.attempt([&]() { check_velocity(body); });
  }
  if (names.empty() && !scene.packing.method)
    mistakes.add(
        InputError("'Bodies/Names' = '' is not allowed with 'Dimension' = '3': it must name at least one "
                   "body, or 'Packing' must bring some"));
  // A shape that encloses nothing has no surface to look at.
  for (unsigned int b = 0; b < scene.bodies.size() && all_enclose; ++b)
    for (unsigned int a = 0; a < b; ++a)
    {
      const double depth = overlap(*scene.bodies[a].shape, *scene.bodies[b].shape);
      if (depth > 0.)
      {
        std::ostringstream text;
        text << "'Bodies/" << names[a] << "' and 'Bodies/" << names[b] << "' overlap by " << depth
             << " m: they must lie beside each other at the start";
        mistakes.add(InputError(text.str()));
      }
    }
  return all_enclose;
}
} // namespace

void check_scene_in_space(const Scene<3> &scene, const ParameterSection &parameters)
{
  Mistakes mistakes;
  ParameterCheck(parameters, mistakes).look_at(parameters);
  const bool all_enclose = check_bodies(scene, mistakes);
  check_walls_in_space(scene, parameters, mistakes);
  const bool may_repeat = value_in(parameters, "", "Model") != "bpm";
  if (may_repeat && all_enclose && std::any_of(scene.walls.begin(), scene.walls.end(), repeats<3>))
    mistakes.attempt([&]() { check_cell_in_space(scene); });
  check_obstacles(scene, mistakes);
  mistakes.end();
}
} // namespace softgrain
