// SPDX-License-Identifier: LGPL-2.1-or-later
// An aggregate left alone for 100 000 steps: whole, at rest, no drift of centre, momentum, energy or shape.
#include "bpm/bpm_scene.h"

#include <algorithm>
#include <iostream>

using namespace softgrain;

int main()
{
  const auto model = bpm_scene(grain_scene(disks({{"3, -2", "0; 0"}}, "10")), {"Stop/End time=1e9"});
  const Snapshot<2> start = model->snapshot();
  const double energy = model->energies().elastic;
  double fastest = 0., deepest = 0.;
  for (unsigned int i = 0; i < 100000; ++i)
  {
    deepest = std::max(deepest, model->advance(1e9).max_penetration);
    fastest = std::max(fastest, model->energies().kinetic);
  }
  const Snapshot<2> end = model->snapshot();
  double moved = 0.;
  for (std::size_t i = 0; i < end.points.position.size(); ++i)
    moved = std::max(moved, end.points.position[i].distance(start.points.position[i]));
  std::cout << "steps " << model->step() << ", pieces " << end.bodies[0].outline.size()
            << "\ncentre moved by " << below(1e-8, end.bodies[0].center.distance(start.bodies[0].center))
            << ", primaries by " << below(0.02, moved) << "\nkinetic over stored energy "
            << below(2e-5, fastest / energy) << ", stored energy changed by "
            << below(1e-5, end.energies.elastic / energy - 1.) << ", balance "
            << below(1e-5, energy_error(start.energies, end.energies)) << "\nmomentum error "
            << below(1e-9, model->momentum_error()) << ", penetration " << below(1e-4, deepest) << '\n';
}
