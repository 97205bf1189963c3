// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/box_measures.h>
#include <softgrain/driving/stop_condition.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
namespace
{
class AxialStrainReached final : public StopCondition
{
public:
  std::string key() const override { return "Axial strain"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry(key(), "0", dealii::Patterns::Double(0),
                      "The run ends when ln(h0/h), where h is the distance of the walls bottom and top, "
                      "reaches this; 0: no such condition. Units: none.");
  }

  std::string in_words(const double limit) const override { return "axial strain " + number_in_words(limit); }

  void check(const Scene<2> &scene, const double) const override
  {
    need_walls(scene, key(), {"bottom", "top"});
  }

  double fraction_done(const RunState &state, const double limit) const override
  {
    return axial_strain(state.walls_at_start, state.model.walls()).value_or(0.) / limit;
  }

  bool works_in_space() const override { return true; }
  void check_in_space(const Scene<3> &scene, const double) const override
  {
    need_walls(scene, key(), {"bottom", "top"});
  }
  double fraction_done_in_space(const RunStateIn<3> &state, const double limit) const override
  {
    return axial_strain(state.walls_at_start, state.model.walls()).value_or(0.) / limit;
  }
};

[[maybe_unused]] const bool registered = Registry<StopCondition>::instance().add(
    "axial_strain", "strain between bottom and top", [] { return std::make_unique<AxialStrainReached>(); });
} // namespace
} // namespace softgrain
