// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/nearest_name.h>
#include <softgrain/scene/material_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <set>

namespace softgrain
{
MaterialParameters::MaterialParameters(const std::vector<std::string> &names, const LawCatalogue &laws)
    : names(names), laws(laws)
{
}

void MaterialParameters::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  prm.enter_subsection("Materials");
  prm.declare_entry("Names", "", List(Anything()),
                    "Names of the materials; each has a subsection of its name.");
  std::string law_choice;
  for (const std::string &law : laws.names)
    law_choice += (law_choice.empty() ? "" : "|") + law;
  for (const std::string &name : names)
  {
    prm.enter_subsection(name);
    prm.declare_entry("Law", laws.names.empty() ? "" : laws.names.front(), Selection(law_choice),
                      "Constitutive law; its parameters are in the subsection of the law.");
    prm.declare_entry("Density", "1000", Double(1e-300), "Density at rest. Units: kg/m^3.");
    if (laws.declare_law_subsections)
      laws.declare_law_subsections(prm);
    prm.leave_subsection();
  }
  prm.leave_subsection();
}

std::vector<MaterialDescription> MaterialParameters::parse_parameters(dealii::ParameterHandler &prm) const
{
  std::vector<MaterialDescription> materials;
  prm.enter_subsection("Materials");
  for (const std::string &name : names)
  {
    prm.enter_subsection(name);
    materials.push_back({name, prm.get("Law"), prm.get_double("Density")});
    prm.leave_subsection();
  }
  prm.leave_subsection();
  return materials;
}

std::vector<std::string> unused_law_subsections(const ParameterSection &all,
                                                const std::vector<MaterialDescription> &materials,
                                                const LawCatalogue &laws)
{
  std::set<std::string> subsections;
  for (const std::string &law : laws.names)
    subsections.insert(laws.subsection_of(law));
  std::vector<std::string> lines;
  const ParameterSection &of_materials = *all.section("Materials");
  for (const MaterialDescription &material : materials)
  {
    const std::string used = laws.subsection_of(material.law);
    for (const ParameterSection &section : of_materials.section(material.name)->sections)
      if (section.name != used && subsections.count(section.name) > 0 &&
          std::any_of(section.entries.begin(), section.entries.end(),
                      [](const ParameterEntry &entry) { return entry.value != entry.default_value; }))
        lines.push_back("'Materials/" + material.name + "/" + section.name +
                        "' has no effect with 'Law' = '" + material.law + "', which reads '" + used + "'");
  }
  return lines;
}
} // namespace softgrain
