// SPDX-License-Identifier: LGPL-2.1-or-later
// Fifteen grains without friction under a third of their modulus, where hardly a pore is left, and sheared
// there: the wall above goes down, the one on the right holds its pressure. Contact rows do not settle in
// such steps, which are refused only when they gain energy: that keeps the number of Newton iterations low.
#include "continued.h"
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
constexpr double pressure = 3e6;                     // [Pa]
constexpr unsigned int n_pressed = 8, n_sheared = 5; // steps

/// Furthest that the stress on the right wall is from its pressure, relative.
double off(const mpm::MpmModel &model, const double wanted)
{
  const auto walls = model.walls(); // bottom, top, left, right
  return std::abs(walls[3].normal_force / (walls[1].position - walls[0].position) / wanted - 1.);
}
} // namespace

int main()
{
  std::vector<std::string> changes = {
      "Mesh/Cell size=4e-4",        "Time/Time step=1e-4",          "Time/Wall way=0",
      "Packing/Number=15",          "Packing/Packing fraction=0.7", "Packing/Upper=7.2e-3, 7.2e-3",
      "Walls/top/Point=0, 7.2e-3",  "Walls/right/Point=7.2e-3, 0",  "Mesh/Upper=8.2e-3, 8.2e-3",
      "Walls/right/Drive=pressure", "Walls/top/Velocity=0",         "Walls/top/Drive=pressure"};
  std::ostringstream rising;
  rising << pressure / (n_pressed * 1e-4) << "*min(t, " << n_pressed * 1e-4 << ")";
  for (const std::string wall : {"top", "right"})
    changes.push_back("Walls/" + wall + "/Pressure=" + rising.str());
  const std::string scene = "gallery/thirty_grains_quasi_static_mpm.prm";
  const auto pressed = shipped_scene(scene, changes);
  unsigned int iterations = 0;
  double worst = 0.;
  for (unsigned int i = 1; i <= n_pressed; ++i)
  {
    iterations += pressed->advance(1.).newton_iterations;
    worst = std::max(worst, off(*pressed, pressure * i / n_pressed));
  }
  const auto walls = pressed->walls();
  std::cout << "pressed: stress off by " << below(5e-4, worst) << ", packing fraction "
            << pressed->solid_area() /
                   ((walls[1].position - walls[0].position) * (walls[3].position - walls[2].position))
            << ", Newton iterations a step " << below(200., 1. * iterations / n_pressed) << '\n';

  std::ostringstream position; // a fifth of a cell a step
  position.precision(17);
  position << "Walls/top/Position=t == 0 ? 0 : " << 7.2e-3 - walls[1].position << " + 0.8*(t - "
           << n_pressed * 1e-4 << ")";
  for (const std::string &change :
       {std::string("Walls/top/Drive=position"), std::string("Walls/top/Pressure=0"), position.str()})
    changes.push_back(change);
  const auto sheared = shipped_scene(scene, changes);
  take_state(*pressed, *sheared);
  iterations = 0;
  worst = 0.;
  for (unsigned int i = 0; i < n_sheared; ++i)
  {
    iterations += sheared->advance(1.).newton_iterations;
    worst = std::max(worst, off(*sheared, pressure));
  }
  std::cout << "sheared: stress off by " << below(5e-4, worst) << ", Newton iterations a step "
            << below(450., 1. * iterations / n_sheared) << '\n';
}
