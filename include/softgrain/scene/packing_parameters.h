// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_packing_parameters_h
#define softgrain_scene_packing_parameters_h

#include <softgrain/scene/scene.h>

#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// Section `Packing`: many disks at once, as bodies of one material.
class PackingParameters
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// What is to be packed, checked as far as it can be before it is. @throw InputError as the method's, and
  /// when the material is not known.
  static PackingDescription<2> parse_parameters(dealii::ParameterHandler &prm,
                                                const std::vector<MaterialDescription> &materials);
};

/**
 * @brief Makes the packing of @p scene: bodies grain_1, grain_2, … are added to its bodies, and the file that
 * the disks are saved to is written.
 * @throw InputError when the disks do not fit or cannot be read
 */
void add_packing(Scene<2> &scene);
} // namespace softgrain

#endif
