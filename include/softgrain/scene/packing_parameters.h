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
/// Section `Packing`: many disks or balls at once, as bodies of one material.
class PackingParameters
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm, unsigned int dimension = 2);

  /// What is to be packed, checked as far as it can be before it is. @throw InputError as the method's, and
  /// when the material is not known.
  template <int dim>
  static PackingDescription<dim> parse_parameters(dealii::ParameterHandler &prm,
                                                  const std::vector<MaterialDescription> &materials);
};

/**
 * @brief Makes the packing of @p scene: bodies grain_1, grain_2, … are added to its bodies. No file is
 * written.
 * @return the packing, for save_packing(); empty without a packing
 * @throw InputError when the disks do not fit or cannot be read
 */
template <int dim>
Packing<dim> add_packing(Scene<dim> &scene);

/**
 * @brief Writes 'Packing/Save to', if it is asked for and not there already.
 * @throw InputError when a file of that name has other contents and may not be overwritten, or cannot be
 * written
 */
template <int dim>
void save_packing(const PackingDescription<dim> &described, const Packing<dim> &packing, bool overwrite);
} // namespace softgrain

#endif
