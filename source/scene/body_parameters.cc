// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/geometry/polygon.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/parameters/parameter_values.h>
#include <softgrain/parameters/within_section.h>
#include <softgrain/scene/body_parameters.h>
#include <softgrain/scene/solid_obstacles.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>

namespace softgrain
{
namespace
{
void declare_shape_in_space(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  const Registry<Shape<3>> &shapes = Registry<Shape<3>>::instance();
  prm.declare_entry("Shape", "sphere", Selection(shapes.choice()),
                    "Shape at rest, with its parameters; " + shapes.choice_in_words());
  prm.declare_entry("Center", "0, 0, 0", List(Double(), 3, 3, ","),
                    "Center of the body, \"x, y, z\". Units: m.");
  for (const std::string &shape : shapes.names())
    shapes.create(shape)->declare_parameters(prm);
}

void declare_shape(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  const Registry<Shape<2>> &shapes = Registry<Shape<2>>::instance();
  prm.declare_entry("Shape", "disk", Selection(shapes.choice()),
                    "Shape at rest, with its parameters; " + shapes.choice_in_words());
  prm.declare_entry(
      "Center", "0, 0", List(Double(), 2, 2, ","),
      "Center of a disk, a rectangle or an ellipse, \"x, y\"; a polygon has that of its area. Units: m.");
  for (const std::string &shape : shapes.names())
    shapes.create(shape)->declare_parameters(prm);
}

void declare_motion(dealii::ParameterHandler &prm, const bool in_space)
{
  using namespace dealii::Patterns;
  prm.declare_entry("Velocity", in_space ? "0; 0; 0" : "0; 0", Anything(),
                    std::string("Velocity at the start, formulas (doc/formulas.md) of ") +
                        (in_space ? "x, y and z: \"vx; vy; vz\"" : "x and y: \"vx; vy\"") + ". Units: m/s.");
  if (in_space)
    prm.declare_entry("Angular velocity", "0, 0, 0", List(Double(), 3, 3, ","),
                      "Angular velocity at the start about the center, \"wx, wy, wz\"; added to Velocity. "
                      "Units: rad/s.");
  else
    prm.declare_entry("Angular velocity", "0", Double(),
                      "Angular velocity at the start about the center, counter-clockwise; added to Velocity. "
                      "Units: rad/s.");
  prm.declare_entry(
      "Body force", "0; 0", Anything(),
      "Force per mass beside section 'Loads', formulas of x, y (place now), X, Y (place at rest) and t: "
      "\"bx; by\". Units: N/kg.");
  prm.declare_entry(
      "Driven", "false", Bool(),
      "Whether the body keeps its velocity, the same everywhere, whatever it meets; it does not turn, "
      "and passes through walls, obstacles and other driven bodies.");
}

/// Adds a spin about the centre to the formulas of the velocity, which know places. Formulas that are not
/// three are left as they are: they will be refused.
void add_spin(const dealii::Tensor<1, 3> &spin, BodyDescription<3> &body)
{
  const std::vector<std::string> axes = {"x", "y", "z"},
                                 given = dealii::Utilities::split_string_list(body.velocity, ';');
  if (spin.norm_square() == 0. || given.size() != 3)
    return;
  std::ostringstream sum;
  sum << std::setprecision(17);
  for (unsigned int d = 0; d < 3; ++d)
  {
    const unsigned int m = (d + 1) % 3, n = (d + 2) % 3;
    sum << (d == 0 ? "" : "; ") << '(' << given[d] << ") + (" << spin[m] << ") * (" << axes[n] << " - ("
        << body.center[n] << ")) - (" << spin[n] << ") * (" << axes[m] << " - (" << body.center[m] << "))";
  }
  body.velocity = sum.str();
}

/// Parameters of a body that only other shapes than the one of this name read.
template <int dim>
std::vector<std::string> read_by_others(const std::string &shape)
{
  const Registry<Shape<dim>> &shapes = Registry<Shape<dim>>::instance();
  dealii::ParameterHandler own, all;
  shapes.create(shape)->declare_parameters(own);
  for (const std::string &name : shapes.names())
    shapes.create(name)->declare_parameters(all);
  const ParameterSection read = parameter_tree(own);
  std::vector<std::string> names;
  for (const std::string &name : parameter_tree(all).entry_names())
    if (read.entry(name) == nullptr)
      names.push_back(name);
  if (shape == "polygon")
    names.push_back("Center");
  return names;
}

template <int dim>
BodyDescription<dim> parse_body(const std::string &name,
                                std::map<std::string, std::vector<std::string>> &unread,
                                dealii::ParameterHandler &prm)
{
  BodyDescription<dim> body;
  body.name = name;
  body.center = dealii::Point<dim>(vector_of_numbers<dim>(prm.get("Center")));
  std::shared_ptr<Shape<dim>> shape = Registry<Shape<dim>>::instance().create(prm.get("Shape"));
  const auto [others, first] = unread.try_emplace(prm.get("Shape"));
  if (first)
    others->second = read_by_others<dim>(prm.get("Shape"));
  check_unused_by_shape(prm, "Bodies/" + name, others->second,
                        dim == 3 ? declare_shape_in_space : declare_shape);
  shape->parse_parameters(prm, body.center);
  body.shape = shape;
  // A polygon says where it is by its corners alone; it turns about its middle as other shapes do.
  if constexpr (dim == 2)
    if (const Polygon corners = shape->corners(); prm.get("Shape") == "polygon" && corners.size() > 2)
      body.center = area_and_centroid(corners).second;
  body.velocity = prm.get("Velocity");
  if constexpr (dim == 2)
    body.angular_velocity = prm.get_double("Angular velocity");
  else
    add_spin(vector_of_numbers<3>(prm.get("Angular velocity")), body);
  body.body_force = prm.get("Body force");
  body.driven = prm.get_bool("Driven");
  return body;
}
} // namespace

BodyParameters::BodyParameters(const std::vector<std::string> &names, const unsigned int dimension)
    : names(names), dimension(dimension)
{
}

void BodyParameters::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  prm.enter_subsection("Bodies");
  prm.declare_entry("Names", "", List(Anything()), "Names of the bodies; each has a subsection of its name.");
  for (const std::string &name : names)
  {
    prm.enter_subsection(name);
    prm.declare_entry(
        "Material", "", Anything(),
        "Material of the body, one of Materials/Names; may be left out when there is only one.");
    if (dimension == 3)
      declare_shape_in_space(prm);
    else
      declare_shape(prm);
    declare_motion(prm, dimension == 3);
    prm.leave_subsection();
  }
  prm.leave_subsection();
}

template <int dim>
std::vector<BodyDescription<dim>>
BodyParameters::parse_parameters(dealii::ParameterHandler &prm,
                                 const std::vector<MaterialDescription> &materials) const
{
  std::vector<std::string> material_names;
  for (const MaterialDescription &material : materials)
    material_names.push_back(material.name);

  std::vector<BodyDescription<dim>> bodies;
  std::map<std::string, std::vector<std::string>> unread; // of every shape that bodies have
  const auto parse_one = [&](const std::string &name)
  {
    const WithinSection section(prm, name);
    bodies.push_back(parse_body<dim>(name, unread, prm));
    const std::string material = prm.get("Material");
    if (material.empty() && materials.size() == 1)
      return;
    const auto found = std::find(material_names.begin(), material_names.end(), material);
    if (found == material_names.end())
    {
      const std::string near = nearest_name(material, material_names);
      throw InputError("'Bodies/" + name + "/Material' = '" + material +
                       "' is not the name of a material; Materials/Names are: " + join(material_names) +
                       (near.empty() ? "" : " (did you mean '" + near + "'?)"));
    }
    bodies.back().material = found - material_names.begin();
  };
  Mistakes mistakes;
  const WithinSection section(prm, "Bodies");
  for (const std::string &name : names)
    mistakes.attempt([&]() { parse_one(name); });
  mistakes.end();
  return bodies;
}

template std::vector<BodyDescription<2>>
BodyParameters::parse_parameters<2>(dealii::ParameterHandler &,
                                    const std::vector<MaterialDescription> &) const;
template std::vector<BodyDescription<3>>
BodyParameters::parse_parameters<3>(dealii::ParameterHandler &,
                                    const std::vector<MaterialDescription> &) const;
} // namespace softgrain
