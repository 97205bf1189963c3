// SPDX-License-Identifier: LGPL-2.1-or-later
// Attraction that differs within a body: forces and energies are linear in it, a pair has the mean of its two
// primaries; bodies of one filling differ by random factors in the range that is asked for.
#include "bpm_scene.h"

#include <algorithm>
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

/// Bodies far apart with the same filling; the weakest bears least.
void spread()
{
  std::vector<Disk> all;
  for (unsigned int i = 0; i < 8; ++i)
    all.push_back({std::to_string(30 * i) + ", 0", "0; 0"});
  const auto strengths = [&](const std::string &seed)
  {
    const auto model =
        bpm_scene(grain_scene(disks(all, "5")),
                  {"Primaries/Strength spread=0.4", "Primaries/Variants=1", "Primaries/Seed=" + seed});
    model->advance(1e-6);
    // The largest stress in a body is that of its bonds.
    const Snapshot<2> now = model->snapshot();
    std::vector<double> of_body(all.size(), 0.);
    for (const ContactState<2> &contact : now.contacts)
      of_body[contact.body_a] += contact.force.norm();
    return of_body;
  };
  const std::vector<double> some = strengths("1"), same = strengths("1"), other = strengths("2");
  const auto [low, high] = std::minmax_element(some.begin(), some.end());
  std::cout << "spread 0.4: strongest over weakest between 1.2 and 1.4/0.6 "
            << (*high / *low > 1.2 && *high / *low < 1.4 / 0.6 ? "yes" : "NO") << ", the same again "
            << (some == same ? "yes" : "NO") << ", others with another seed "
            << (some != other ? "yes" : "NO") << '\n';
}
} // namespace

int main()
{
  linear();
  spread();
}
