// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/box_measures.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/stop_condition.h>
#include <softgrain/geometry/box.h>
#include <softgrain/geometry/shape.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
class PackingFractionReached final : public StopCondition
{
public:
  std::string key() const override { return "Packing fraction"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry(
        key(), "0", dealii::Patterns::Double(0),
        "The run ends when the bodies fill this share of the box of the walls bottom, top, left "
        "and right; 0: no such condition. Units: none.");
  }

  std::string in_words(const double limit) const override
  {
    return "packing fraction " + number_in_words(limit);
  }

  void check(const Scene<2> &scene, const double) const override
  {
    need_walls(scene, key(), {"bottom", "top", "left", "right"});
  }

  void check_start(const Scene<2> &scene, const double limit) const override
  {
    double solid = 0.;
    for (const BodyDescription<2> &body : scene.bodies)
      solid += body.shape->area();
    const double fraction = solid / std::abs(box_of(scene.walls)->volume());
    if (fraction >= limit)
      throw InputError("'Stop/" + key() + "' = '" + number_in_words(limit) +
                       "' is already reached: the bodies fill " + number_in_words(fraction) +
                       " of the box at the start");
  }

  double fraction_done(const RunState &state, const double limit) const override
  {
    const double area = state.model.solid_area();
    const double packing = packing_fraction(state.model.walls(), area).value_or(0.);
    if (packing >= limit)
      return 1.;
    // The box shrinks like 1/packing: this measures the way of the walls.
    const double start = packing_fraction(state.walls_at_start, area).value_or(packing);
    return packing > 0. ? std::max(0., (1. / start - 1. / packing) / (1. / start - 1. / limit)) : 0.;
  }
};

[[maybe_unused]] const bool registered =
    Registry<StopCondition>::instance().add("packing_fraction",
                                            "share of the box that bodies fill",
                                            [] { return std::make_unique<PackingFractionReached>(); });
} // namespace
} // namespace softgrain
