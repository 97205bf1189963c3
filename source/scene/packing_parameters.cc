// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/scene/packing_parameters.h>
#include <softgrain/scene/parameter_values.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
namespace
{
unsigned int find_material(const std::string &name, const std::vector<MaterialDescription> &materials)
{
  std::vector<std::string> names;
  for (unsigned int m = 0; m < materials.size(); ++m)
  {
    if (materials[m].name == name || (name.empty() && materials.size() == 1))
      return m;
    names.push_back(materials[m].name);
  }
  throw InputError("'Packing/Material' = '" + name + "' is not allowed: it must be one of " + join(names));
}

PackingRequest parse_request(dealii::ParameterHandler &prm)
{
  PackingRequest request;
  request.number = prm.get_integer("Number");
  request.sizes.parse_parameters(prm, "Packing");
  request.lower = dealii::Point<2>(pair_of_numbers(prm.get("Lower")));
  request.upper = dealii::Point<2>(pair_of_numbers(prm.get("Upper")));
  request.seed = prm.get_integer("Seed");
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
  prm.declare_entry("Number", "0", Integer(0, 10000000),
                    "Disks to make at random, as bodies grain_1, grain_2, …; 0: none.");
  prm.declare_entry("File", "", Anything(),
                    "Disks to read instead: CSV with the columns x_m, y_m, radius_m.");
  prm.declare_entry("Save to", "", Anything(), "Where the disks made are written, in the same form.");
  prm.declare_entry("Material", "", Anything(), "Of the bodies; may be left out when there is one only.");
  SizeDistribution::declare_parameters(prm, "1.4e-3", "2.4e-3");
  prm.declare_entry("Lower", "0, 0", List(Double(), 2, 2, ","),
                    "Lower left corner of the box that the disks are packed in. Units: m.");
  prm.declare_entry("Upper", "1, 1", List(Double(), 2, 2, ","),
                    "Upper right corner. Number, diameters and box decide how dense it is; about 0.80 is "
                    "possible. Units: m.");
  prm.declare_entry("Seed", "1", Integer(0), "Of the random sizes and places.");
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
    const unsigned int material = find_material(prm.get("Material"), materials);
    const Packing packing = make ? make_packing(parse_request(prm)) : read_packing(file);
    if (!save_to.empty())
      write_packing(save_to, packing);
    for (const Packing::Disk &disk : packing.disks)
    {
      BodyDescription<2> body;
      body.name = "grain_" + std::to_string(bodies.size() + 1);
      body.material = material;
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
