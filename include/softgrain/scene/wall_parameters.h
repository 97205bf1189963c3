// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_wall_parameters_h
#define softgrain_scene_wall_parameters_h

#include <softgrain/scene/scene.h>

#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// Section `Walls`: one subsection per name; bottom, top, left and right know their normals.
class WallParameters
{
public:
  explicit WallParameters(const std::vector<std::string> &names);

  void declare_parameters(dealii::ParameterHandler &prm) const;

  /// @throw InputError when a normal is missing or zero.
  std::vector<WallDescription<2>> parse_parameters(dealii::ParameterHandler &prm) const;

private:
  const std::vector<std::string> names;
};
} // namespace softgrain

#endif
