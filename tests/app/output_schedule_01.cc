// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps of any length meet every output time exactly, without slivers, also where intervals round.
#include <softgrain/app/output_schedule.h>

#include <algorithm>
#include <iostream>

int main()
{
  using namespace softgrain;
  for (const double interval : {0.1, 0.25, 1e-7, 1. / 3})
    for (const double natural : {0.03, 0.0299, 0.1, 0.7, 1e-3})
    {
      const double dt = natural * interval / 0.1;
      OutputSchedule schedule(interval);
      StepPlanner planner;
      double time = 0, last = 0, shortest = dt, error = 0;
      unsigned int n_steps = 0, n_outputs = 0;
      while (n_outputs < 1000)
      {
        last = std::min(dt, planner.limit(time, schedule.next()));
        planner.taken(last);
        shortest = std::min(shortest, last);
        const double due = schedule.next();
        time += last;
        ++n_steps;
        if (schedule.reached(time, planner.slack()))
        {
          ++n_outputs;
          error = std::max(error, std::abs(time - due) / interval);
        }
      }
      std::cout << time / interval << ' ' << n_steps << ' '
                << (shortest > 0.49 * std::min(dt, interval) ? "no slivers" : "slivers") << ' '
                << (error < 2e-6 ? "exact" : "missed") << '\n';
    }
  OutputSchedule restarted(0.1);
  restarted.skip_to(0.3, 1e-9);
  std::cout << restarted.next() << '\n';
}
