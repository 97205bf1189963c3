// SPDX-License-Identifier: LGPL-2.1-or-later
// A wall that is where a formula says has a velocity and an energy from the first state on. A balance of
// which all terms are rounding has no value, and a scene with masses that differ too much for sweeps ends
// with that cause.
#include "bpm_scene.h"

#include <softgrain/app/run_statistics.h>
#include <softgrain/base/exceptions.h>

#include <cmath>
#include <iostream>

using namespace softgrain;

namespace
{
std::string number_or_none(const double value, const double limit)
{
  return std::isfinite(value) ? below(limit, value) : "none";
}

/// Balances after a few steps of one disk with this velocity that meets nothing.
void balances(const std::string &velocity)
{
  const auto model = bpm_scene(grain_scene(disks({{"0, 0", velocity}}, "10")),
                               {"Primaries/Number per body=1", "Time/Time step=0.1"});
  RunStatistics statistics(*model);
  for (unsigned int i = 0; i < 5; ++i)
    model->advance(1.);
  statistics.add_energies(model->energies(), model->energy_of_rounding());
  std::cout << "a disk at " << velocity << ": error of energy "
            << number_or_none(statistics.energy_balance_error(), 1e-12) << ", of momentum "
            << number_or_none(model->momentum_error(), 1e-12) << '\n';
}
} // namespace

int main()
{
  const auto pressed = bpm_scene(grain_scene(disks({{"0, 0", "0; 0"}}, "10") + R"(
subsection Walls
  set Names = bottom, top
  subsection bottom
    set Point = 0, -11
  end
  subsection top
    set Point    = 0, 11
    set Drive    = position
    set Position = 0.02*t
  end
end
)"));
  std::cout << "velocity of the wall in the first state " << pressed->walls()[1].velocity << ", energies "
            << (std::isfinite(pressed->energies().kinetic) ? "finite" : "NOT FINITE") << '\n';

  balances("0; 0");
  balances("0.1; 0");

  // A disk of 1 that bears one of 1e10: each on its place, so that nothing but their masses is unusual.
  const auto heavy = bpm_scene(R"(
subsection Materials
  set Names = light, heavy
  subsection light
    set Density = 1
    subsection Power law
      set Force at contact = 0
    end
  end
  subsection heavy
    set Density = 1e10
    subsection Power law
      set Force at contact = 0
    end
  end
end
subsection Bodies
  set Names = below, middle, above
  subsection below
    set Center   = 0, 1
    set Radius   = 1
    set Material = light
  end
  subsection middle
    set Center   = 0, 3
    set Radius   = 1
    set Material = light
  end
  subsection above
    set Center   = 0, 5
    set Radius   = 1
    set Material = heavy
  end
end
subsection Primaries
  set Smallest diameter = 2
  set Largest diameter  = 2
  set Number per body   = 1
end
subsection Walls
  set Names = bottom
  subsection bottom
    set Point = 0, 0
  end
end
subsection Loads
  set Gravity = 0, -10
end
subsection Time
  set Time step = 1e-2
end
subsection Contact
  set Maximum sweeps = 2000
end
subsection Stop
  set End time = 1
end
)");
  try
  {
    heavy->advance(1.);
    std::cout << "1e10 on 1: found\n";
  }
  catch (const ComputationError &error)
  {
    const std::string text = error.what();
    std::cout << "1e10 on 1: "
              << (text.find("'above' is 1e+10 times as heavy as one of body 'below'") != std::string::npos
                      ? "the cause is named"
                      : text)
              << '\n';
  }
}
