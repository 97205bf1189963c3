// SPDX-License-Identifier: LGPL-2.1-or-later
// Bonded particles in space: the same state, bit for bit, with one thread and with two, and for a run that
// was saved and continued twice.
#include "continued.h"
#include "space_scene.h"

#include <softgrain/base/parallel.h>

#include <iostream>

using namespace softgrain;

namespace
{
const std::string scene = grain_scene(
    balls({{"5, 5, 5"}, {"15, 5.2, 5"}, {"5, 15, 5.1"}, {"15.2, 15, 5"}, {"5, 5, 15"}, {"15, 5, 14.9"}},
          "4.7") +
    box("20", "0.3"));

std::string steps(bpm::SpaceModel &model, const unsigned int from, const unsigned int to)
{
  std::ostringstream text;
  text << std::hexfloat;
  for (unsigned int i = from; i < to; ++i)
  {
    const StepReport report = model.advance(1.);
    const Energies energies = model.energies();
    text << model.time() << ' ' << report.contact_sweeps << ' ' << report.contact_residual << ' '
         << energies.kinetic << ' ' << energies.elastic << ' ' << energies.dissipated << ' '
         << energies.external_work << ' ' << model.momentum_error() << ' ' << model.solid_area() << ' '
         << model.coordination();
    for (const auto &wall : model.walls())
      text << ' ' << wall.normal_force << ' ' << wall.tangential_force << ' ' << wall.position;
    text << '\n';
  }
  return text.str();
}

void compare(const std::string &what, const Changes &changes)
{
  const unsigned int n = 90;
  set_n_threads(1);
  const std::string one = steps(*space_scene(scene, changes), 0, n);
  set_n_threads(2);
  const std::string two = steps(*space_scene(scene, changes), 0, n);
  const std::string parts = continued_twice(
      n, [&] { return space_scene(scene, changes); }, steps);
  std::cout << what << ": two threads " << (one == two ? "the same" : "DIFFERENT") << ", continued twice "
            << (one == parts ? "the same" : "DIFFERENT") << '\n';
}
} // namespace

int main()
{
  compare("frictionless", {});
  compare("friction and gravity",
          {"Contact/Friction=0.5", "Contact/Friction at walls=same", "Loads/Gravity=0, 0, -1e-3"});
}
