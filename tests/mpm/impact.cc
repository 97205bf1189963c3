// SPDX-License-Identifier: LGPL-2.1-or-later
// Two disks run into each other: momentum to rounding, energy balance, restitution; straight and off centre
// with friction.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
void collide(const std::string &what, const std::vector<std::string> &changes)
{
  const auto model = shipped_scene("gallery/two_disks.prm", changes);
  EnergyWatch energy(*model);
  const Snapshot<2> start = model->snapshot();
  double penetration = 0.;
  run_until(*model, 1.6e-3,
            [&](const StepReport &report)
            {
              energy.look(*model);
              penetration = std::max(penetration, report.max_penetration);
            });
  const Snapshot<2> end = model->snapshot();
  const auto spin = [](const Snapshot<2> &now)
  {
    double sum = 0.;
    for (const BodyState<2> &body : now.bodies)
      sum += body.angular_momentum +
             body.mass * (body.center[0] * body.velocity[1] - body.center[1] * body.velocity[0]);
    return sum;
  };
  const double before = start.bodies[0].velocity[0] - start.bodies[1].velocity[0],
               after = end.bodies[1].velocity[0] - end.bodies[0].velocity[0];
  std::cout << what << ": restitution " << after / before << ", dissipated "
            << end.energies.dissipated / start.energies.kinetic << " of the energy, balance "
            << below(1e-2, energy.error()) << ", momentum " << below(1e-13, model->momentum_error())
            << ", turning " << below(1e-2, (spin(end) - spin(start)) / (start.bodies[0].mass * 5e-3))
            << ", penetration in cells " << below(0.05, penetration / 6e-4) << '\n';
}
/// Largest angular momentum of a frictionless disk over m v R after collisions off the line of centres, by
/// 0.1 to 1 R: nothing outside has a lever on a round disk.
double spin_without_friction(const std::string &cell)
{
  double worst = 0.;
  for (const std::string offset : {"0.5e-3", "1.5e-3", "2.5e-3", "3.5e-3", "5e-3"})
  {
    const auto model = shipped_scene("gallery/two_disks.prm",
                                     {"Mesh/Cell size=" + cell, "Mesh/Lower=-0.02, -0.02",
                                      "Mesh/Upper=0.02, 0.02", "Bodies/left/Center=-5.1e-3, " + offset});
    run_until(*model, 1.6e-3);
    for (const BodyState<2> &body : model->snapshot().bodies)
      worst = std::max(worst, std::abs(body.angular_momentum) / (body.mass * 5e-3));
  }
  return worst;
}
} // namespace

int main()
{
  collide("trapezoidal, 2 CFL", {});
  collide("1 CFL", {"Time/CFL multiple=1"});
  collide("10 CFL", {"Time/CFL multiple=10"});
  collide("explicit", {"Time/Scheme=explicit", "Time/CFL multiple=0.3"});
  collide("off centre, mu = 0.5", {"Contact/Friction=0.5", "Bodies/left/Center=-5.1e-3, 1e-3"});
  std::cout << "without friction: spin after collisions off centre at cells of 0.17 and 0.1 diameters "
            << below(0.015, spin_without_friction("1.7e-3")) << ", "
            << below(0.005, spin_without_friction("1e-3")) << " of m v R\n";
}
