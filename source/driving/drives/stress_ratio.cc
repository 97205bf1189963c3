// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/free_wall_drive.h>

#include <algorithm>

namespace softgrain
{
namespace
{
/// Keeps the ratio of its own stress to that of the walls beside it.
class StressRatioDrive final : public FreeWallDrive
{
public:
  StressRatioDrive()
      : FreeWallDrive("stress_ratio",
                      "Stress ratio",
                      "stress on this wall over that on the walls beside it; a formula of t "
                      "(doc/formulas.md). Units: none.")
  {
  }

  WallDemand demand(const WallStep &step) const override
  {
    return {0., std::max(0., value(step) * step.stress_beside)};
  }
  bool looks_beside() const override { return true; }
};

[[maybe_unused]] const bool registered = Registry<WallDrive>::instance().add(
    "stress_ratio",
    "it moves along its normal so that its stress is 'Stress ratio' times that beside it",
    [] { return std::make_unique<StressRatioDrive>(); });
} // namespace
} // namespace softgrain
