// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/free_wall_drive.h>

#include <algorithm>

namespace softgrain
{
namespace
{
/// Keeps (s1 + s2)/2, the mean of its own stress and of that of the walls beside it.
class MeanPressureDrive final : public FreeWallDrive
{
public:
  MeanPressureDrive()
      : FreeWallDrive("mean_pressure",
                      "Mean pressure",
                      "mean of the stress on this wall and of that on the walls beside it; a formula of t "
                      "(doc/formulas.md). Units: Pa.")
  {
  }

  WallDemand demand(const WallStep &step) const override
  {
    return {0., std::max(0., 2. * value(step) - step.stress_beside)};
  }
  bool looks_beside() const override { return true; }
};

[[maybe_unused]] const bool registered =
    Registry<WallDrive>::instance().add("mean_pressure",
                                        "it moves along its normal so that (s1 + s2)/2 is 'Mean pressure'",
                                        [] { return std::make_unique<MeanPressureDrive>(); });
} // namespace
} // namespace softgrain
