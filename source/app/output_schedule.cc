// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/output_schedule.h>

#include <algorithm>
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
  if (!due(time, slack))
    return false;
  skip_to(time, slack);
  return true;
}

void OutputSchedule::skip_to(const double time, const double slack)
{
  if (!active())
    return;
  count = static_cast<unsigned long>(std::floor(time / interval));
  // Division rounds; what counts is that the next time lies ahead.
  while (next() <= time + slack)
    ++count;
}

double StepPlanner::limit(const double time, const double target)
{
  const double rest = target - time;
  last_limit = rest < shared_by * natural ? rest / std::max(1., std::ceil(rest / natural - sliver)) : rest;
  return last_limit;
}

void StepPlanner::taken(const double dt)
{
  // A step as long as its limit only tells that the natural one is not shorter.
  natural = dt < last_limit * (1 - sliver) ? dt : std::max(natural, dt);
}
} // namespace softgrain
