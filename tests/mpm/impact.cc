// SPDX-License-Identifier: LGPL-2.1-or-later
// Two disks run into each other: momentum to rounding, energy balance, restitution; straight and off centre
// with friction.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
/// All angular momentum about the origin.
double turning_of(const Snapshot<2> &now)
{
  double sum = 0.;
  for (const BodyState<2> &body : now.bodies)
    sum += body.angular_momentum +
           body.mass * (body.center[0] * body.velocity[1] - body.center[1] * body.velocity[0]);
  return sum;
}

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
  const double before = start.bodies[0].velocity[0] - start.bodies[1].velocity[0],
               after = end.bodies[1].velocity[0] - end.bodies[0].velocity[0];
  std::cout << what << ": restitution " << after / before << ", dissipated "
            << end.energies.dissipated / start.energies.kinetic << " of the energy, balance "
            << below(1e-2, energy.error()) << ", momentum " << below(1e-13, model->momentum_error())
            << ", turning "
            << below(1e-2, (turning_of(end) - turning_of(start)) / (start.bodies[0].mass * 5e-3))
            << ", penetration in cells " << below(0.05, penetration / 6e-4) << '\n';
}
/// Frictionless disks collide off the line of centres, by 0.1 to 1 R. A round disk should hardly turn, but
/// what it turns the other one must turn the other way.
struct Turning
{
  double spin = 0.; ///< largest angular momentum of a disk, over m v R
  double lost = 0.; ///< of all angular momentum, over m v R
};

Turning without_friction(const std::string &cell)
{
  Turning worst;
  for (const std::string offset : {"0.5e-3", "1.5e-3", "2.5e-3", "3.5e-3", "5e-3"})
  {
    const auto model = shipped_scene("gallery/two_disks.prm",
                                     {"Mesh/Cell size=" + cell, "Mesh/Lower=-0.02, -0.02",
                                      "Mesh/Upper=0.02, 0.02", "Bodies/left/Center=-5.1e-3, " + offset});
    const double before = turning_of(model->snapshot());
    run_until(*model, 1.6e-3);
    const Snapshot<2> end = model->snapshot();
    const double whole = end.bodies[0].mass * 5e-3;
    worst.lost = std::max(worst.lost, std::abs(turning_of(end) - before) / whole);
    for (const BodyState<2> &body : end.bodies)
      worst.spin = std::max(worst.spin, std::abs(body.angular_momentum) / whole);
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
  for (const std::string cell : {"1.7e-3", "1e-3", "6e-4"})
  {
    const Turning found = without_friction(cell);
    std::cout << "off centre, without friction, cells of " << cell << " m: angular momentum lost "
              << below(2e-4, found.lost) << ", spin " << found.spin << " of m v R\n";
  }
}
