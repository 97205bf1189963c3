// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/scene/wall_drive.h>

#include <deal.II/base/parameter_handler.h>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::WallDrive)

namespace softgrain
{
std::shared_ptr<const WallDrive>
make_drive(const std::string &name, const std::string &wall, const std::vector<std::string> &parameters)
{
  std::shared_ptr<WallDrive> drive = Registry<WallDrive>::instance().create(name);
  dealii::ParameterHandler prm;
  drive->declare_parameters(prm);
  for (const std::string &parameter : parameters)
  {
    const auto equals = parameter.find('=');
    prm.set(parameter.substr(0, equals), parameter.substr(equals + 1));
  }
  drive->parse_parameters(prm, wall);
  return drive;
}
} // namespace softgrain
