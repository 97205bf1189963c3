// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_wall_parameters_h
#define softgrain_scene_wall_parameters_h

#include <softgrain/scene/scene.h>

#include <memory>
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
  explicit WallParameters(const std::vector<std::string> &names, unsigned int dimension = 2);

  void declare_parameters(dealii::ParameterHandler &prm) const;

  /// @throw InputError when a normal is missing or zero.
  template <int dim>
  std::vector<WallDescription<dim>> parse_parameters(dealii::ParameterHandler &prm) const;

  /// Declares 'Drive' and what belongs to every drive, where the handler stands.
  /// @param as_before whether the drive may be left as it was, which is then the default
  static void declare_drive(dealii::ParameterHandler &prm, bool as_before);

  /// @param wall "Walls/NAME", for messages. @return null for a drive that is left as before
  /// @throw InputError when something is set that belongs to another drive
  static std::shared_ptr<const WallDrive> parse_drive(const dealii::ParameterHandler &prm,
                                                      const std::string &wall);

private:
  const std::vector<std::string> names;
  const unsigned int dimension;
};
} // namespace softgrain

#endif
