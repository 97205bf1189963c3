// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/stop_condition.h>
#include <softgrain/geometry/box.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <cmath>

namespace softgrain
{
namespace
{
class ShearStrainReached final : public StopCondition
{
public:
  std::string key() const override { return "Shear strain"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry(key(), "0", dealii::Patterns::Double(0),
                      "The run ends when |ln(h0/h) - ln(w0/w)|, where h and w are the distances of the walls "
                      "bottom and top, left and right, reaches this; 0: no such condition. Units: none.");
  }

  std::string in_words(const double limit) const override { return "shear strain " + number_in_words(limit); }

  void check(const Scene<2> &scene, const double) const override
  {
    need_walls(scene, key(), {"bottom", "top", "left", "right"});
  }

  double fraction_done(const RunState &state, const double limit) const override
  {
    const std::optional<Box<2>> start = box_of(state.walls_at_start), now = box_of(state.model.walls());
    if (!start || !now)
      return 0.;
    return std::abs(std::log(start->height() / now->height()) - std::log(start->width() / now->width())) /
           limit;
  }
};

[[maybe_unused]] const bool registered =
    Registry<StopCondition>::instance().add("shear_strain",
                                            "strain of the box along one axis over that along the other",
                                            [] { return std::make_unique<ShearStrainReached>(); });
} // namespace
} // namespace softgrain
