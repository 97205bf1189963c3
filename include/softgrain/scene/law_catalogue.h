// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_law_catalogue_h
#define softgrain_scene_law_catalogue_h

#include <functional>
#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// The laws a model offers to `Materials/NAME/Law`, so that the scene need not know any of them.
struct LawCatalogue
{
  std::vector<std::string> names;
  /// Declares one subsection per law where the handler stands, which is inside the section of a material.
  std::function<void(dealii::ParameterHandler &)> declare_law_subsections;
  /// Name of the subsection of a law.
  std::function<std::string(const std::string &law)> subsection_of;
};
} // namespace softgrain

#endif
