// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_material_parameters_h
#define softgrain_scene_material_parameters_h

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
} // namespace softgrain

#endif
