// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/driving/step_control.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace softgrain
{
namespace
{
constexpr double hardly_longer = 10.;     ///< over the smallest step, for one that counts as short
constexpr unsigned int most_short = 1000; ///< steps in a row, after which a run gives up
} // namespace

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

void StepControl::note(const double dt, const double floor)
{
  if (dt >= hardly_longer * floor)
  {
    n_short = 0;
    way_of_short = 0.;
    return;
  }
  ++n_short;
  way_of_short += dt;
}

void StepControl::check_that_time_moves(const double time,
                                        const double wanted,
                                        const double asked,
                                        const SafeStep &safe) const
{
  std::ostringstream message;
  if (safe.dt < std::min(asked, safe.shortest))
  {
    message << "at time " << time << " s time no longer moves: a safe step is " << safe.dt
            << " s long, the smallest is " << std::min(asked, safe.shortest) << " s: " << safe.cause();
    throw ComputationError(message.str());
  }
  if (n_short < most_short)
    return;
  message << "at time " << time << " s time hardly moves: " << n_short << " steps in a row took "
          << way_of_short << " s together, where one is to take " << wanted << " s ('Time/Smallest step')"
          << (last_refusal.empty() ? "" : "; the last one that failed: " + last_refusal);
  throw ComputationError(message.str());
}

StepTaken StepControl::advance(const StepSettings &settings,
                               const double wanted,
                               const double dt_limit,
                               const double time,
                               const std::function<Attempt(double dt)> &attempt,
                               const SafeStep &safe)
{
  std::ostringstream message;
  const double asked = std::min(wanted, dt_limit), floor = settings.smallest_step * asked;
  check_that_time_moves(time, wanted, asked, safe);
  // A step below this is lost in the time that it is added to.
  const double rounding = 4. * std::numeric_limits<double>::epsilon() * std::abs(time);
  const double limit = std::min(dt_limit, safe.dt);
  const double shortest = std::max(settings.smallest_step * std::min(wanted, limit), rounding);
  if (std::min(wanted * scale, limit) < std::min(rounding, dt_limit))
  {
    message << "at time " << time << " s time no longer moves: a step of " << std::min(wanted * scale, limit)
            << " s is lost in its rounding"
            << (last_refusal.empty() ? "" : "; the last step that failed: " + last_refusal);
    throw ComputationError(message.str());
  }
  const double scale_before = scale;
  StepTaken step;
  for (step.dt = std::min(wanted * scale, limit);; ++step.attempts)
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
      // What is due soon makes a step short, too.
      if (step.dt < dt_limit)
        note(step.dt, floor);
      return step;
    }
    last_refusal = done.reason;
    step.dt *= std::clamp(done.share, 0.1, 0.9);
    scale = std::min(scale, step.dt / wanted);
    if (step.dt < shortest)
    {
      message << "at time " << time << " s no step longer than " << step.dt << " s succeeds: " << done.reason;
      throw ComputationError(message.str());
    }
  }
}
} // namespace softgrain
