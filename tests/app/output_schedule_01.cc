// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps of any length meet every output time exactly, without slivers, also where intervals round. Where
// eight steps share the rest of the way none is shorter than seven eighths of the others, in as many steps as
// before.
#include <softgrain/app/output_schedule.h>

#include <algorithm>
#include <iostream>

namespace
{
void meet(const double interval, const double dt, const unsigned int shared_by)
{
  using namespace softgrain;
  OutputSchedule schedule(interval);
  StepPlanner planner(shared_by);
  double time = 0, shortest = dt, shortest_later = dt, error = 0;
  unsigned int n_steps = 0, n_outputs = 0;
  while (n_outputs < 1000)
  {
    const double step = std::min(dt, planner.limit(time, schedule.next()));
    planner.taken(step);
    shortest = std::min(shortest, step);
    if (n_outputs > 0) // before that the natural step is not known
      shortest_later = std::min(shortest_later, step);
    const double due = schedule.next();
    time += step;
    ++n_steps;
    if (schedule.reached(time, planner.slack()))
    {
      ++n_outputs;
      error = std::max(error, std::abs(time - due) / interval);
    }
  }
  const double equal = interval < shared_by * dt ? interval / std::ceil(interval / dt - 1e-6)
                                                 : (shared_by - 1) * dt / shared_by;
  const bool none = shortest > 0.49 * std::min(dt, interval) && shortest_later > 0.99 * equal;
  std::cout << time / interval << ' ' << n_steps << ' ' << (none ? "no slivers" : "slivers") << ' '
            << (error < 2e-6 ? "exact" : "missed") << '\n';
}
} // namespace

int main()
{
  using namespace softgrain;
  for (const unsigned int shared_by : {2, 8})
    for (const double interval : {0.1, 0.25, 1e-7, 1. / 3})
      for (const double natural : {0.03, 0.0299, 0.0085, 0.1, 0.7, 1e-3})
        meet(interval, natural * interval / 0.1, shared_by);
  OutputSchedule restarted(0.1);
  restarted.skip_to(0.3, 1e-9);
  std::cout << restarted.next() << '\n';
}
