// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/output_schedule.h>

#include <cmath>
#include <limits>

namespace softgrain
{
OutputSchedule::OutputSchedule(const double interval) : interval(interval) {}

double OutputSchedule::next() const
{
  return active() ? (count + 1) * interval : std::numeric_limits<double>::infinity();
}

bool OutputSchedule::reached(const double time, const double slack)
{
  if (time < next() - slack)
    return false;
  skip_to(time, slack);
  return true;
}

void OutputSchedule::skip_to(const double time, const double slack)
{
  if (active())
    count = static_cast<unsigned long>(std::floor((time + slack) / interval));
}

double step_limit(const double time, const double target, const double last_dt)
{
  const double rest = target - time;
  return last_dt < rest && rest < 2 * last_dt ? rest / 2 : rest;
}
} // namespace softgrain
