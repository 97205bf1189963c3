// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>

namespace softgrain
{
namespace
{
/// Area of the bodies over that of the box, and the void ratio @cite nguyen2016, eq. (5.1).
class Packing final : public Measure
{
public:
  std::vector<std::string> columns() const override { return {"packing_fraction", "void_ratio"}; }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    if (!assembly.box || assembly.snapshot.bodies.empty())
      return {std::nullopt, std::nullopt};
    double solid = 0.;
    for (const BodyState<2> &body : assembly.snapshot.bodies)
      solid += body.area;
    const double fraction = solid / assembly.box->volume();
    return {fraction, 1. / fraction - 1.};
  }
};

[[maybe_unused]] const bool registered =
    register_measure<Packing>("packing", "packing fraction and void ratio");
} // namespace
} // namespace softgrain
