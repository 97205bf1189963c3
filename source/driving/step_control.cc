// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/driving/step_control.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <sstream>

namespace softgrain
{
void StepSettings::declare_parameters(dealii::ParameterHandler &prm,
                                      const std::string &zero,
                                      const std::string &smallest_step)
{
  prm.declare_entry("Time step", "0", dealii::Patterns::Double(0.),
                    "Length of a step; 0: " + zero + ". Units: s.");
  prm.declare_entry("Smallest step", smallest_step, dealii::Patterns::Double(1e-12, 1.),
                    "A step that fails is repeated with half its length. The run gives up when a step is "
                    "shorter than this share of the length asked for. Units: none.");
}

void StepSettings::parse_parameters(const dealii::ParameterHandler &prm)
{
  time_step = prm.get_double("Time step");
  smallest_step = prm.get_double("Smallest step");
}

StepTaken StepControl::advance(const StepSettings &settings,
                               const double wanted,
                               const double dt_limit,
                               const double time,
                               const std::function<Attempt(double dt)> &attempt)
{
  const double scale_before = scale;
  StepTaken step;
  for (step.dt = std::min(wanted * scale, dt_limit);; ++step.attempts)
  {
    Attempt done;
    try
    {
      done = attempt(step.dt);
    }
    catch (const Interrupted &)
    {
      scale = scale_before;
      throw;
    }
    if (done.accepted)
    {
      if (done.may_grow)
        scale = std::min(1., growth * scale);
      return step;
    }
    step.dt *= std::clamp(done.share, 0.1, 0.9);
    scale = std::min(scale, step.dt / wanted);
    if (step.dt < settings.smallest_step * std::min(wanted, dt_limit))
    {
      std::ostringstream message;
      message << "at time " << time << " s no step longer than " << step.dt << " s succeeds: " << done.reason;
      throw ComputationError(message.str());
    }
  }
}
} // namespace softgrain
