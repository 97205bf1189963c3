// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/parameters/parameter_values.h>
#include <softgrain/scene/packing_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
namespace
{
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
std::vector<unsigned int> materials_of(const Packing &packing,
                                       const std::string &name,
                                       const std::string &file,
                                       const std::vector<MaterialDescription> &materials)
{
  if (packing.materials.empty())
    return std::vector<unsigned int>(packing.disks.size(),
                                     find_material(name, materials, "'Packing/Material' = "));
  if (!name.empty())
    throw InputError("'Packing/Material' = '" + name + "' is not allowed with 'Packing/File' = '" + file +
                     "', which names the material of every disk: leave one of them out");
  std::vector<unsigned int> result;
  for (std::size_t i = 0; i < packing.disks.size(); ++i)
    result.push_back(
        find_material(packing.materials[i], materials,
                      "'Packing/File': line " + std::to_string(i + 2) + " of '" + file + "': the material "));
  return result;
}

PackingRequest parse_request(dealii::ParameterHandler &prm)
{
  PackingRequest request;
  request.number = prm.get_integer("Number");
  request.sizes.parse_parameters(prm, "Packing");
  request.lower = dealii::Point<2>(pair_of_numbers(prm.get("Lower")));
  request.upper = dealii::Point<2>(pair_of_numbers(prm.get("Upper")));
  request.fraction = prm.get_double("Packing fraction");
  request.seed = prm.get_integer("Seed");
  request.protocol.jam = prm.get_bool("Until jammed");
  request.protocol.friction = prm.get_double("Friction");
  const std::string periodic = prm.get("Periodic");
  request.protocol.periodic = {
      {periodic.find('x') != std::string::npos, periodic.find('y') != std::string::npos}};
  if (request.protocol.jam && request.fraction > 0.)
    throw InputError("'Packing/Packing fraction' = '" + prm.get("Packing fraction") +
                     "' is not allowed with 'Packing/Until jammed' = 'true', which decides it: it must be 0");
  for (unsigned int d = 0; d < 2; ++d)
    if (!(request.upper[d] - request.lower[d] > request.sizes.largest))
      throw InputError("'Packing/Upper' = '" + prm.get("Upper") +
                       "' is not allowed: the box from 'Lower' = '" + prm.get("Lower") +
                       "' on must be larger than a disk");
  return request;
}
} // namespace

void PackingParameters::declare_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.enter_subsection("Packing");
  prm.declare_entry(
      "Number", "0", Integer(0, 10000000),
      "Number of disks to pack at random, as bodies grain_1, grain_2, …; 0: none. Units: none.");
  prm.declare_entry(
      "File", "", Anything(),
      "Table of disks to read instead: CSV with the columns x_m, y_m, radius_m and, where the disks are of "
      "several materials, material.");
  prm.declare_entry("Save to", "", Anything(),
                    "File to which the packed disks are written, in the same form; empty: none.");
  prm.declare_entry("Material", "", Anything(),
                    "Material of the disks; may be left out when there is only one or the file names them.");
  SizeDistribution::declare_parameters(prm, "1.4e-3", "2.4e-3");
  prm.declare_entry("Lower", "0, 0", List(Double(), 2, 2, ","),
                    "Lower left corner of the box that the disks are packed in. Units: m.");
  prm.declare_entry(
      "Upper", "1, 1", List(Double(), 2, 2, ","),
      "Upper right corner of that box. Number, diameters and box decide how dense the packing is, unless "
      "'Packing fraction' or 'Until jammed' does; up to about 0.80 is possible. Units: m.");
  prm.declare_entry("Packing fraction", "0", Double(0., 0.9),
                    "Share of the box that the disks fill; all diameters are scaled by one factor to reach "
                    "it. 0: diameters are kept. Units: none.");
  prm.declare_entry("Until jammed", "false", Bool(),
                    "Whether the box shrinks until the disks resist, as under pressure. Then everything is "
                    "scaled to the box asked for: about 0.84 of it is filled without friction and walls.");
  prm.declare_entry("Friction", "0", Double(0.),
                    "Coefficient of friction between the disks, and with the sides of the box, while they "
                    "are packed. With more friction they jam at a lower density. Units: none.");
  prm.declare_entry("Periodic", "", MultipleSelection("x|y"),
                    "Directions in which the box has no sides: x, y or both. A disk that leaves on one side "
                    "enters on the other, and disks reach over the edge. For packings without walls; a scene "
                    "with a wall there refuses them.");
  prm.declare_entry("Seed", "1", Integer(0), "Seed of the random sizes and places. Units: none.");
  prm.leave_subsection();
}

std::vector<BodyDescription<2>>
PackingParameters::parse_parameters(dealii::ParameterHandler &prm,
                                    const std::vector<MaterialDescription> &materials)
{
  std::vector<BodyDescription<2>> bodies;
  prm.enter_subsection("Packing");
  const std::string file = prm.get("File"), save_to = prm.get("Save to");
  const bool make = prm.get_integer("Number") > 0;
  if (make && !file.empty())
    throw InputError("'Packing/File' = '" + file + "' is not allowed with 'Packing/Number' = '" +
                     prm.get("Number") + "': either make a packing or read one");
  if (!save_to.empty() && !make)
    throw InputError("'Packing/Save to' = '" + save_to + "' has no effect without 'Packing/Number'");
  if (make || !file.empty())
  {
    const std::string material = prm.get("Material");
    if (make)
      find_material(material, materials, "'Packing/Material' = "); // before the packing, which may take long
    const Packing packing = make ? make_packing(parse_request(prm)) : read_packing(file);
    const std::vector<unsigned int> material_of = materials_of(packing, material, file, materials);
    if (!save_to.empty())
      write_packing(save_to, packing);
    for (const Packing::Disk &disk : packing.disks)
    {
      BodyDescription<2> body;
      body.name = "grain_" + std::to_string(bodies.size() + 1);
      body.material = material_of[bodies.size()];
      body.center = disk.center;
      body.radius = disk.radius;
      body.velocity = body.body_force = "0; 0";
      bodies.push_back(body);
    }
  }
  prm.leave_subsection();
  return bodies;
}
} // namespace softgrain
