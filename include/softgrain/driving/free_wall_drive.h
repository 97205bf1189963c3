// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_free_wall_drive_h
#define softgrain_driving_free_wall_drive_h

#include <softgrain/base/expression.h>
#include <softgrain/scene/wall_drive.h>

#include <string>

namespace softgrain
{
/// A wall that is a body of one degree of freedom, along its normal; members say what presses it.
class FreeWallDrive : public WallDrive
{
public:
  /// @param name    of the member, @param key its parameter, a formula of t, @param meaning what that is
  FreeWallDrive(std::string name, std::string key, std::string meaning);

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(const dealii::ParameterHandler &prm, const std::string &wall) override;
  bool prescribed() const override { return false; }
  WallInertia inertia() const override { return resistance; }

protected:
  /// Value of the parameter in the middle of a step.
  double value(const WallStep &step) const { return formula({step.middle()}); }

private:
  const std::string name, key, meaning;
  Expression formula{"0", {"t"}};
  WallInertia resistance;
};
} // namespace softgrain

#endif
