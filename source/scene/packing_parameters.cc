// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/geometry/ellipse.h>
#include <softgrain/geometry/shapes_2d.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/packing/packing_method.h>
#include <softgrain/parameters/within_section.h>
#include <softgrain/scene/packing_parameters.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <cmath>
#include <filesystem>

namespace softgrain
{
namespace
{
const char *const automatic = "automatic";
const std::string of_classes = "'Packing/Classes': the material ";

/// @param where begins the message of an unknown name
unsigned int find_material(const std::string &name,
                           const std::vector<MaterialDescription> &materials,
                           const std::string &where)
{
  std::vector<std::string> names;
  for (unsigned int m = 0; m < materials.size(); ++m)
  {
    if (materials[m].name == name || (name.empty() && materials.size() == 1))
      return m;
    names.push_back(materials[m].name);
  }
  throw InputError(where + "'" + name + "' is not allowed: it must be one of " + join(names));
}

/// Materials of all disks: those that the file names, else 'Packing/Material'.
template <int dim>
std::vector<unsigned int> materials_of(const Packing<dim> &packing,
                                       const std::string &name,
                                       const std::vector<MaterialDescription> &materials)
{
  if (packing.materials.empty())
    return std::vector<unsigned int>(packing.balls.size(),
                                     find_material(name, materials, "'Packing/Material' = "));
  if (!name.empty())
    throw InputError(
        "'Packing/Material' = '" + name + "' is not allowed with " +
        (packing.file.empty() ? "'Packing/Classes'" : "'Packing/File' = '" + packing.file + "'") +
        ", which names the material of every disk: leave one of them out");
  std::vector<unsigned int> result;
  for (std::size_t i = 0; i < packing.balls.size(); ++i)
    result.push_back(find_material(packing.materials[i], materials,
                                   packing.file.empty() ? of_classes
                                                        : "'Packing/File': line " + std::to_string(i + 2) +
                                                              " of '" + packing.file + "': the material "));
  return result;
}

/// The method that the section asks for; null: none.
template <int dim>
std::shared_ptr<PackingMethod<dim>> chosen_method(const dealii::ParameterHandler &prm)
{
  const Registry<PackingMethod<dim>> &methods = Registry<PackingMethod<dim>>::instance();
  const std::string name = prm.get("Method");
  if (name != automatic)
    return methods.create(name);
  std::shared_ptr<PackingMethod<dim>> chosen;
  for (const std::string &candidate : methods.names())
  {
    std::shared_ptr<PackingMethod<dim>> method = methods.create(candidate);
    if (method->asked_for(prm))
      chosen = method; // random comes after file, and refuses one
  }
  return chosen;
}

std::shared_ptr<const Shape<2>> shape_of(const Packing<2>::Ball &disk, const GrainForm2D &form)
{
  const double angle = form.angle * dealii::numbers::PI / 180., c = std::cos(angle), s = std::sin(angle);
  if (form.kind == GrainForm2D::Kind::disk)
    return std::make_shared<Disk2D>(disk.center, disk.radius);
  if (form.kind == GrainForm2D::Kind::ellipse)
    return std::make_shared<Ellipse2D>(disk.center, dealii::Tensor<1, 2>({disk.radius, form.short_radius}),
                                       angle);
  Polygon corners;
  for (const dealii::Tensor<1, 2> &direction : form.directions())
  {
    const double x = disk.radius * direction[0], y = form.short_radius * direction[1];
    corners.emplace_back(disk.center[0] + c * x - s * y, disk.center[1] + s * x + c * y);
  }
  return std::make_shared<Polygon2D>(corners);
}

template <int dim>
void declare(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.enter_subsection("Packing");
  const Registry<PackingMethod<dim>> &methods = Registry<PackingMethod<dim>>::instance();
  prm.declare_entry(
      "Method", automatic, Selection(std::string(automatic) + "|" + methods.choice()),
      "Where the grains come from, as bodies grain_1, grain_2, …; automatic: random with 'Number', "
      "file with 'File', else there are none; " +
          methods.choice_in_words());
  prm.declare_entry(
      "Save to", "", Anything(),
      "File to which a run writes the packed grains, CSV as 'File' reads it; empty: none. One that is "
      "there with other contents is refused unless --overwrite is given.");
  prm.declare_entry("Material", "", Anything(),
                    "Material of the grains; may be left out when there is only one or the file names them.");
  for (const std::string &method : methods.names())
    methods.create(method)->declare_parameters(prm);
  prm.leave_subsection();
}

} // namespace

void PackingParameters::declare_parameters(dealii::ParameterHandler &prm, const unsigned int dimension)
{
  if (dimension == 3)
    declare<3>(prm);
  else
    declare<2>(prm);
}

template <int dim>
PackingDescription<dim> PackingParameters::parse_parameters(dealii::ParameterHandler &prm,
                                                            const std::vector<MaterialDescription> &materials)
{
  PackingDescription<dim> packing;
  const WithinSection section(prm, "Packing");
  packing.save_to = prm.get("Save to");
  const std::shared_ptr<PackingMethod<dim>> method = chosen_method<dim>(prm);
  if (method)
  {
    packing.material = prm.get("Material");
    method->parse_parameters(prm);
    // Before the packing is made, which may take long.
    if (!(method->may_name_materials() && packing.material.empty()))
      find_material(packing.material, materials, "'Packing/Material' = ");
    for (const std::string &name : method->named_materials())
      find_material(name, materials, of_classes);
    packing.method = method;
  }
  else if (!packing.save_to.empty())
    throw InputError("'Packing/Save to' = '" + packing.save_to + "' has no effect without 'Packing/Number'");
  return packing;
}

template <int dim>
Packing<dim> add_packing(Scene<dim> &scene)
{
  if (!scene.packing.method)
    return {};
  Packing<dim> packing = scene.packing.method->make();
  const std::vector<unsigned int> material_of =
      materials_of(packing, scene.packing.material, scene.materials);
  unsigned int number = 0;
  for (const typename Packing<dim>::Ball &ball : packing.balls)
  {
    BodyDescription<dim> body;
    body.material = material_of[number];
    body.name = "grain_" + std::to_string(++number);
    if constexpr (dim == 2)
      body.shape = shape_of(ball, form_of(packing, number - 1));
    else
      body.shape = std::make_shared<Sphere>(ball.center, ball.radius);
    body.center = ball.center;
    body.velocity = body.body_force = dim == 2 ? "0; 0" : "0; 0; 0";
    scene.bodies.push_back(body);
  }
  return packing;
}

template <int dim>
void save_packing(const PackingDescription<dim> &described, const Packing<dim> &packing, const bool overwrite)
{
  const std::string &file = described.save_to;
  if (file.empty() || holds_packing(file, packing))
    return;
  std::error_code ignored;
  if (!overwrite && std::filesystem::exists(file, ignored))
    throw InputError(
        "'Packing/Save to' = '" + file +
        "' is not allowed: there is a file of that name with other contents; choose another name, "
        "or run with --overwrite");
  write_packing(file, packing);
}

template PackingDescription<2>
PackingParameters::parse_parameters<2>(dealii::ParameterHandler &, const std::vector<MaterialDescription> &);
template PackingDescription<3>
PackingParameters::parse_parameters<3>(dealii::ParameterHandler &, const std::vector<MaterialDescription> &);
template Packing<2> add_packing<2>(Scene<2> &);
template Packing<3> add_packing<3>(Scene<3> &);
template void save_packing<2>(const PackingDescription<2> &, const Packing<2> &, bool);
template void save_packing<3>(const PackingDescription<3> &, const Packing<3> &, bool);
} // namespace softgrain
