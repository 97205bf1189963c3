// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest force on a wall counts as no less than a floor: a floor far below the forces changes nothing,
// and one far above them costs as few sweeps as no tolerance on walls at all.
#include "packing.h"
#include "reference.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/contact/disk_solver.h>

#include <iostream>

using namespace softgrain;

namespace
{
unsigned int sweeps(const double wall_tolerance, const double floor)
{
  SystemSettings settings;
  settings.reach = 0.3;
  const Packing packing = lattice_packing(12, 12);
  DiskSystem system = make_system(packing, settings);
  squeeze(system, packing, 0.1, false);
  contact::DiskSolverSettings solver;
  solver.tolerance = 1e-2;
  solver.wall_tolerance = wall_tolerance;
  solver.wall_floor = floor;
  solver.max_sweeps = 100000;
  return solve_disks(system.bodies, system.contacts, solver).sweeps;
}
} // namespace

int main()
{
  const unsigned int strict = sweeps(1e-6, 0.), free = sweeps(1e300, 0.);
  std::cout << "a tolerance on walls costs sweeps: " << verdict(strict > free) << '\n'
            << "a low floor changes nothing: " << verdict(sweeps(1e-6, 1e-12) == strict) << '\n'
            << "under a high floor they are free: " << verdict(sweeps(1e-6, 1e12) == free) << '\n';
  std::cerr << strict << ' ' << free << '\n';
  try
  {
    sweeps(1e-6, -1.);
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
