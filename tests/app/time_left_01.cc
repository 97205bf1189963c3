// SPDX-License-Identifier: LGPL-2.1-or-later
// The time left of an even run is exact from the second step on, before and after a restart; of a run whose
// first step is slow, or whose steps become twice as long half way, it is right soon after.
#include <softgrain/app/time_left.h>

#include <functional>
#include <iomanip>
#include <iostream>

using namespace softgrain;

namespace
{
/// 100 steps of a run that begins at @p start; prints estimate and truth after some of them.
void run(const std::string &name, const double start, const std::function<double(int)> &duration)
{
  std::cout << name << '\n';
  constexpr int n = 100;
  double whole = 0, seconds = 0;
  for (int step = 0; step < n; ++step)
    whole += duration(step);
  TimeLeft left;
  for (int step = 0; step < n; ++step)
  {
    seconds += duration(step);
    left.add(seconds, start + (1 - start) * (step + 1) / n);
    if (step == 0)
      std::cout << "  known after the first step: " << left.seconds().has_value() << '\n';
    if (step == 1 || step == 4 || step == 19 || step == 49 || step == 69 || step == 99)
      std::cout << "  after " << step + 1 << ": " << std::fixed << std::setprecision(1) << *left.seconds()
                << " of " << whole - seconds << '\n';
  }
}
} // namespace

int main()
{
  run("even", 0, [](int) { return 1.; });
  run("restarted at 0.6", 0.6, [](int) { return 1.; });
  run("slow first step", 0, [](const int step) { return step == 0 ? 30. : 1.; });
  run("dearer from half way", 0, [](const int step) { return step < 50 ? 1. : 2.; });
  TimeLeft waiting;
  for (const double seconds : {1., 2., 3.})
    waiting.add(seconds, 0.2);
  std::cout << "steps that bring nothing: " << waiting.seconds().has_value() << '\n';
}
