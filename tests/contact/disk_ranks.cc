// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts between disks, swept by several ranks. Known: what one rank finds by itself, to the last bit;
// ranks that share it exchange less than all velocities after every colour.
#include "packing.h"

#include <softgrain/base/exchange.h>
#include <softgrain/base/mpi_session.h>
#include <softgrain/contact/disk_solver.h>

#include <iostream>

using namespace softgrain;
using contact::DiskAlgorithm;

namespace
{
bool same(const DiskSystem &one, const DiskSystem &other)
{
  return one.bodies.velocity == other.bodies.velocity &&
         one.bodies.angular_velocity == other.bodies.angular_velocity &&
         one.contacts.impulse == other.contacts.impulse &&
         one.contacts.tangential_impulse == other.contacts.tangential_impulse &&
         one.contacts.rolling_impulse == other.contacts.rolling_impulse;
}
} // namespace

int main(int, char **argv)
{
  const MPISession mpi(argv);
  const Exchange ranks;
  for (const double friction : {-1., 0.3})
    for (const bool rolling : {false, true})
      for (const DiskAlgorithm algorithm : {DiskAlgorithm::gauss_seidel, DiskAlgorithm::accelerated})
      {
        if (rolling && friction < 0.)
          continue;
        SystemSettings settings;
        settings.reach = 0.3;
        settings.friction = friction;
        settings.rolling = rolling ? 0.02 : -1.;
        contact::DiskSolverSettings solver;
        solver.algorithm = algorithm;
        solver.tolerance = 1e-3;
        solver.max_sweeps = 200000;
        const DiskSystem start = random_system(lattice_packing(80, 60), settings, 3);
        DiskSystem alone = start, shared = start;
        const auto expected = solve_disks(alone.bodies, alone.contacts, solver);
        const auto bytes = ranks.taken().bytes;
        const auto found = solve_disks(shared.bodies, shared.contacts, solver, &ranks);
        const double told = static_cast<double>(ranks.taken().bytes - bytes) / found.sweeps;
        const bool here = same(alone, shared) && expected.converged && found.sweeps == expected.sweeps &&
                          found.residual == expected.residual;
        const bool wrong = ranks.any(!here);
        const double all = start.bodies.size() * (friction > 0. ? 24. : 16.);
        const bool little = !ranks.any(told > 0.3 * all);
        if (ranks.first())
          std::cout << "friction " << friction << ", rolling " << rolling
                    << (algorithm == DiskAlgorithm::accelerated ? ", momentum" : ", plain")
                    << ": the same bits " << !wrong << ", a rank is told "
                    << (told == 0. ? "nothing"
                        : little   ? "little"
                                   : "much")
                    << " in a sweep\n";
      }
}
