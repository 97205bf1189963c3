// SPDX-License-Identifier: LGPL-2.1-or-later
// Attraction that differs within a body: forces and energies are linear in it, a pair has the mean of its two
// primaries; whole bodies differ by random factors that are the same in every run.
#include "bpm_scene.h"

#include <iostream>

using namespace softgrain;

namespace
{
double energy(const Changes &changes)
{
  return bpm_scene(grain_scene(disks({{"0, 0", "0; 0"}}, "10")), changes)->energies().elastic;
}

void linear()
{
  const double one = energy({});
  std::cout << "energy over that of one strength: twice as strong " << energy({"Primaries/Strength=2"}) / one
            << ", 2 + x and 2 - x together "
            << (energy({"Primaries/Strength=2 + x"}) + energy({"Primaries/Strength=2 - x"})) / one
            << ", core and skin together "
            << (energy({"Primaries/Strength=r < 0.6 ? 1 : 0"}) +
                energy({"Primaries/Strength=r < 0.6 ? 0 : 1"})) /
                   one
            << '\n';
}

/// Bodies far apart: energy over that without a spread.
void spread()
{
  std::vector<Disk> all;
  for (unsigned int i = 0; i < 8; ++i)
    all.push_back({std::to_string(30 * i) + ", 0", "0; 0"});
  const auto energy_of = [&](const std::string &width)
  {
    return bpm_scene(grain_scene(disks(all, "5")), {"Primaries/Strength spread=" + width})
        ->energies()
        .elastic;
  };
  const double none = energy_of("0"), some = energy_of("0.4") / none, more = energy_of("0.8") / none;
  std::cout << "spread 0.4: energy within 0.4 of 1 " << (std::abs(some - 1.) < 0.4 ? "yes" : "NO")
            << ", not 1 " << (std::abs(some - 1.) > 1e-3 ? "yes" : "NO") << ", the same again "
            << (energy_of("0.4") / none == some ? "yes" : "NO") << "; deviation of spread 0.8 over it "
            << (more - 1.) / (some - 1.) << '\n';
}
} // namespace

int main()
{
  linear();
  spread();
}
