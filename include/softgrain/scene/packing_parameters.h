// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_packing_parameters_h
#define softgrain_scene_packing_parameters_h

#include <softgrain/packing/packing.h>
#include <softgrain/scene/scene.h>

#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// Section `Packing`: many disks at once, made at random or read from a file, as bodies of one material.
class PackingParameters
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Bodies grain_1, grain_2, …; none when the section asks for none. @throw InputError as make_packing() and
  /// read_packing(), and when the material is not known.
  static std::vector<BodyDescription<2>> parse_parameters(dealii::ParameterHandler &prm,
                                                          const std::vector<MaterialDescription> &materials);
};
} // namespace softgrain

#endif
