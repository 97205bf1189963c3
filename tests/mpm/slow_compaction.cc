// SPDX-License-Identifier: LGPL-2.1-or-later
// A wall that is 25 or 100 times slower than that of the gallery takes the same number of steps, each 25 or
// 100 times longer: contact gives nothing to the bodies, frictionless disks do not spin, opposite walls bear
// the same, and the energy balance closes.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
double column(const mpm::MpmModel &model, const std::string &name)
{
  for (const auto &[title, value] : model.extra_history())
    if (title == name)
      return value;
  return -1.;
}

void squeeze(const std::string &what, std::vector<std::string> changes)
{
  changes.insert(changes.end(), {"Mesh/Cell size=4e-4", "Packing/Packing fraction=0.76"});
  const auto model = shipped_scene("gallery/thirty_grains_mpm.prm", changes);
  EnergyWatch energy(*model);
  double loss = 0., most = 0., gave = 0., spin = 0.;
  unsigned int steps = 0;
  const auto fraction = [&]()
  {
    const auto walls = model->walls(); // bottom, top, left, right
    return model->solid_area() /
           ((walls[3].position - walls[2].position) * (walls[1].position - walls[0].position));
  };
  for (; fraction() < 0.9 && steps < 100; ++steps)
  {
    model->advance(1.);
    energy.look(*model);
    loss = column(*model, "contact_loss_J_per_m");
    most = std::max(most, loss);
    gave = std::max(gave, most - loss);
    const double kinetic = model->energies().kinetic;
    if (kinetic > 0.)
      spin = std::max(spin, column(*model, "rotational_energy_J_per_m") / kinetic);
  }
  const auto walls = model->walls();
  const bool friction = walls[1].normal_force > 1.1 * walls[0].normal_force;
  std::cout << what << ": in less than 60 steps " << (steps < 60 ? "yes" : "no") << ", energy balance "
            << below(0.01, energy.error()) << ", contact gave over work of walls "
            << below(1e-3, gave / model->energies().external_work);
  if (!friction)
    std::cout << ", rotational over kinetic energy " << below(0.01, spin) << ", top over bottom force less 1 "
              << below(0.005, walls[1].normal_force / walls[0].normal_force - 1.);
  std::cout << '\n';
}
} // namespace

int main()
{
  const std::vector<std::string> slow = {"Walls/top/Velocity=0.2", "Time/CFL multiple=100",
                                         "Stop/End time=1"},
                                 slower = {"Walls/top/Velocity=0.05", "Time/CFL multiple=400",
                                           "Stop/End time=1"};
  squeeze("0.2 m/s", slow);
  squeeze("0.05 m/s", slower);
  std::vector<std::string> rough = slow;
  rough.push_back("Contact/Friction=0.5");
  for (const std::string wall : {"bottom", "top", "left", "right"})
    rough.push_back("Walls/" + wall + "/Friction=0.5");
  squeeze("0.2 m/s, friction 0.5", rough);
}
