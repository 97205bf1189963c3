// SPDX-License-Identifier: LGPL-2.1-or-later
// An aggregate left alone stays whole and at rest: no drift of its centre, momentum, energy or shape. Tests
// in tests/nightly do the same for 100 000 steps.
#include "bpm_scene.h"

#include <iostream>

using namespace softgrain;

int main()
{
  const auto model = bpm_scene(grain_scene(disks({{"3, -2", "0; 0"}}, "10")));
  const Snapshot<2> start = model->snapshot();
  const double energy = model->energies().elastic;
  double fastest = 0.;
  for (unsigned int i = 0; i < 2000; ++i)
  {
    model->advance(1.);
    fastest = std::max(fastest, model->energies().kinetic);
  }
  const Snapshot<2> end = model->snapshot();
  double moved = 0.;
  for (std::size_t i = 0; i < end.points.position.size(); ++i)
    moved = std::max(moved, end.points.position[i].distance(start.points.position[i]));
  std::cout << "primaries " << model->n_points() << ", pieces " << end.bodies[0].outline.size()
            << "\narea over that of the primaries " << end.bodies[0].area / (end.bodies[0].mass / 1.)
            << "\nmean stress over p_I " << below(0.03, end.bodies[0].mean_stress.norm() * 2.1)
            << "\ncentre moved by " << below(1e-11, end.bodies[0].center.distance(start.bodies[0].center))
            << ", primaries by " << below(5e-3, moved) << "\nkinetic over stored energy "
            << below(2e-5, fastest / energy) << ", stored energy changed by "
            << below(1e-5, end.energies.elastic / energy - 1.) << "\nmomentum error "
            << below(1e-11, model->momentum_error()) << ", turning "
            << below(1e-5, end.bodies[0].angular_momentum) << '\n';
}
