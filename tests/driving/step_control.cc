// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps above a limit fail: they are halved until one passes, grow again by the factor given but not above
// the wanted step, and a run that finds no step says why. An interrupted step leaves the length as it was.
// A run ends where time no longer moves: steps that are lost in it, safe steps that are far too short, and a
// thousand steps in a row that are hardly longer than the smallest; not where what is due makes steps short.
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/driving/step_control.h>

#include <iostream>

using namespace softgrain;

int main()
{
  StepControl control(1.5);
  StepSettings settings;
  settings.smallest_step = 1e-2;
  std::cout << "wanted " << settings.wanted(2.) << ' ';
  settings.time_step = 1.;
  std::cout << settings.wanted(2.) << '\n';
  double longest = 1.;
  bool may_grow = true;
  const auto attempt = [&](const double dt) -> Attempt {
    return {dt <= longest, "it is longer than it may be", may_grow};
  };
  const auto advance = [&](const double dt_limit)
  {
    const StepTaken step = control.advance(settings, settings.wanted(0.), dt_limit, 7., attempt);
    std::cout << "step " << step.dt << " at attempt " << step.attempts << ", then " << control.scale << '\n';
  };
  advance(10.);
  longest = 0.3;
  advance(10.); // 1, 1/2, 1/4, which grows to 3/8
  longest = 1.;
  may_grow = false;
  advance(10.);
  may_grow = true;
  advance(10.);
  advance(0.1); // an output is near: a short step, and not because it failed
  for (unsigned int i = 0; i < 3; ++i)
    advance(10.);
  longest = 1e-3;
  try
  {
    advance(10.);
  }
  catch (const ComputationError &error)
  {
    std::cout << error.what() << '\n';
  }
  control.scale = 0.5;
  unsigned int calls = 0;
  try
  {
    control.advance(settings, 1., 10., 7.,
                    [&](const double) -> Attempt
                    {
                      if (++calls == 3)
                        throw Interrupted();
                      return {};
                    });
  }
  catch (const Interrupted &)
  {
    std::cout << "interrupted at attempt " << calls << ", then " << control.scale << '\n';
  }
  const auto why = [](const std::function<void()> &run)
  {
    try
    {
      run();
      std::cout << "goes on\n";
    }
    catch (const ComputationError &error)
    {
      std::cout << error.what() << '\n';
    }
  };
  const auto good = [](const double) -> Attempt { return {true, "", false}; };
  StepControl late(1.5), fast(1.5), slow(1.5), due(1.5);
  why([&]() { late.advance(settings, 1., 10., 1e16, good); });
  SafeStep safe;
  safe.cause = []() { return std::string("body 'a' at (0 0) m moves at 1e+30 m/s"); };
  safe.dt = 1e-3;
  safe.shortest = 1e-4;
  why([&]() { fast.advance(settings, 1., 10., 7., good, safe); });
  safe.dt = 1e-5;
  why([&]() { fast.advance(settings, 1., 10., 7., good, safe); });
  const auto often = [&](StepControl &of, const double dt_limit, const unsigned int n)
  {
    for (unsigned int i = 0; i < n; ++i)
      of.advance(settings, 1., dt_limit, 7., good);
  };
  slow.scale = 0.05;
  why([&]() { often(slow, 10., 1000); });
  why([&]() { often(slow, 10., 1); });
  why([&]() { often(due, 0.05, 2000); });
}
