// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/free_wall_drive.h>

namespace softgrain
{
namespace
{
class PressureDrive final : public FreeWallDrive
{
public:
  PressureDrive()
      : FreeWallDrive("pressure",
                      "Pressure",
                      "pressure towards the bodies, acting on the length between the walls beside it; a "
                      "formula of t (doc/formulas.md). Units: Pa.")
  {
  }

  WallDemand demand(const WallStep &step) const override { return {0., value(step)}; }
};

[[maybe_unused]] const bool registered =
    Registry<WallDrive>::instance().add("pressure",
                                        "it moves along its normal under 'Pressure'",
                                        [] { return std::make_unique<PressureDrive>(); });
} // namespace
} // namespace softgrain
