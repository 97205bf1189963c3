// SPDX-License-Identifier: LGPL-2.1-or-later
// The speed of the machine is measured within a few hundredths of a second, and again comes out alike: two
// measurements differ by less than forecasts may.
#include <softgrain/app/machine_speed.h>
#include <softgrain/base/rank_times.h>

#include <algorithm>
#include <iostream>

using namespace softgrain;

int main()
{
  const double begin = processor_seconds();
  const double first = slowness_of_machine(), second = slowness_of_machine();
  const double seconds = (processor_seconds() - begin) / 2.;
  std::cerr << first << ' ' << second << ' ' << seconds << " s\n";
  std::cout << "alike: " << (std::max(first, second) < 2. * std::min(first, second)) << '\n'
            << "a few hundredths of a second on a machine as slow as this one: "
            << (seconds < 0.1 * std::max(1., first))
            << '\n'
            // Ten times slower or faster than the machine of the constants, or built without optimisation.
            << "of a machine: " << (first > 0.05 && first < 100.) << '\n';
}
