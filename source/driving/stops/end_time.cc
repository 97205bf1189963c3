// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/stop_condition.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
namespace
{
class EndTime final : public StopCondition
{
public:
  std::string key() const override { return "End time"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry(key(), "0", dealii::Patterns::Double(0),
                      "The run ends at this time; 0: no such condition. Units: s.");
  }

  std::string in_words(const double limit) const override { return "t = " + number_in_words(limit, "s"); }
  double end_time(const double limit) const override { return limit; }

  double fraction_done(const RunState &state, const double limit) const override
  {
    return fraction(state, limit);
  }

  bool works_in_space() const override { return true; }
  double fraction_done_in_space(const RunStateIn<3> &state, const double limit) const override
  {
    return fraction(state, limit);
  }

private:
  template <int dim>
  static double fraction(const RunStateIn<dim> &state, const double limit)
  {
    const double elapsed = state.model.time() - state.begin;
    return elapsed >= limit - state.time_slack ? 1. : elapsed / limit;
  }
};

[[maybe_unused]] const bool registered = Registry<StopCondition>::instance().add(
    "time", "simulated time", [] { return std::make_unique<EndTime>(); });
} // namespace
} // namespace softgrain
