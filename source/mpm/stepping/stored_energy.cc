// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/model/world.h>
#include <softgrain/mpm/stepping/stored_energy.h>
#include <softgrain/mpm/stepping/stress.h>

namespace softgrain::mpm
{
double stored_energy(const World &world)
{
  std::vector<double> elastic(world.bodies.size(), 0.);
  parallel_for(world.bodies.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   if (!world.bodies[b].driven)
                     elastic[b] = measure_points(
                                      world.bodies[b], world.bodies[b].displacement,
                                      Eigen::VectorXd(Eigen::VectorXd::Zero(world.bodies[b].field.n_dofs())))
                                      .energy;
               });
  double sum = world.balance.subgrid_energy;
  for (const double energy : elastic)
    sum += energy;
  return sum;
}
} // namespace softgrain::mpm
