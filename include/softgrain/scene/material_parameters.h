// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_material_parameters_h
#define softgrain_scene_material_parameters_h

#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/scene/law_catalogue.h>
#include <softgrain/scene/scene.h>

#include <string>
#include <vector>

namespace softgrain
{
/// Section `Materials`: one subsection per name.
class MaterialParameters
{
public:
  MaterialParameters(const std::vector<std::string> &names, const LawCatalogue &laws);

  void declare_parameters(dealii::ParameterHandler &prm) const;
  std::vector<MaterialDescription> parse_parameters(dealii::ParameterHandler &prm) const;

private:
  const std::vector<std::string> names;
  const LawCatalogue laws;
};

/// A line for each subsection of a law that a material does not have, where something in it is set: that
/// has no effect. @param all parameters of a file
std::vector<std::string> unused_law_subsections(const ParameterSection &all,
                                                const std::vector<MaterialDescription> &materials,
                                                const LawCatalogue &laws);
} // namespace softgrain

#endif
