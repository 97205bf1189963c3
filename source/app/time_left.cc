// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/time_left.h>

#include <algorithm>

namespace softgrain
{
void TimeLeft::add(const double seconds, const double fraction)
{
  last = {seconds, fraction};
  ++n_steps;
  if (n_steps == 1)
    first = from = next = last;
  else if (n_steps == 2 || seconds - first.seconds >= 2 * (next.seconds - first.seconds))
  {
    from = next;
    next = last;
  }
}

std::optional<double> TimeLeft::seconds() const
{
  const double done = n_steps < 2 ? 0. : last.fraction - from.fraction;
  if (!(done > 0))
    return std::nullopt;
  return std::max(0., (last.seconds - from.seconds) * (1 - last.fraction) / done);
}
} // namespace softgrain
