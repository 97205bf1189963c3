// SPDX-License-Identifier: LGPL-2.1-or-later
// A run of so many steps.
#include <softgrain/driving/stop_condition.h>

#include <deal.II/base/parameter_handler.h>

using namespace softgrain;

class StepsMade final : public StopCondition
{
public:
  std::string key() const override { return "Steps"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry(key(), "0", dealii::Patterns::Integer(0),
                      "The run ends after so many steps; 0: no limit.");
  }

  std::string in_words(const double limit) const override { return number_in_words(limit, "steps"); }

  double fraction_done(const RunState &state, const double limit) const override
  {
    return state.model.step() / limit;
  }
};

[[maybe_unused]] const bool registered = Registry<StopCondition>::instance().add(
    "steps", "number of steps", [] { return std::make_unique<StepsMade>(); });
