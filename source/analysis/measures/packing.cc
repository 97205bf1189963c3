// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>

namespace softgrain
{
namespace
{
/// Area, in space volume, of the bodies over that of the box, and the void ratio @cite nguyen2016, eq. (5.1).
template <int dim>
class Packing final : public MeasureIn<dim>
{
public:
  std::vector<std::string> columns() const override { return {"packing_fraction", "void_ratio"}; }

  std::vector<MeasuredValue> evaluate(const AssemblyIn<dim> &assembly) const override
  {
    if (!assembly.box || assembly.snapshot.bodies.empty())
      return {std::nullopt, std::nullopt};
    double solid = 0.;
    for (const BodyState<dim> &body : assembly.snapshot.bodies)
      solid += body.area;
    const double fraction = solid / assembly.box->volume();
    return {fraction, 1. / fraction - 1.};
  }
};

constexpr const char *name = "packing", *description = "packing fraction and void ratio";
[[maybe_unused]] const bool registered = register_measure<Packing<2>>(name, description),
                            registered_in_space = register_measure<Packing<3>, 3>(name, description);
} // namespace
} // namespace softgrain
