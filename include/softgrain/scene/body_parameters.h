// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_body_parameters_h
#define softgrain_scene_body_parameters_h

#include <softgrain/scene/scene.h>

#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// Section `Bodies`: one subsection per name.
class BodyParameters
{
public:
  explicit BodyParameters(const std::vector<std::string> &names, unsigned int dimension = 2);

  void declare_parameters(dealii::ParameterHandler &prm) const;

  /// @throw InputError when a body names a material that is not among @p materials.
  template <int dim>
  std::vector<BodyDescription<dim>> parse_parameters(dealii::ParameterHandler &prm,
                                                     const std::vector<MaterialDescription> &materials) const;

private:
  const std::vector<std::string> names;
  const unsigned int dimension;
};
} // namespace softgrain

#endif
