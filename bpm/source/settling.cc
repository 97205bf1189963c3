// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/dynamics.h>
#include <softgrain/bpm/settling.h>

#include <deal.II/base/numbers.h>

#include <sstream>
#include <vector>

namespace softgrain::bpm
{
namespace
{
Primaries disks_of(const Aggregate &aggregate, const double density)
{
  Primaries disks;
  disks.position = aggregate.position;
  disks.radius = aggregate.radius;
  disks.velocity.assign(aggregate.size(), {0., 0.});
  disks.body.assign(aggregate.size(), 0);
  for (const double r : aggregate.radius)
    disks.mass.push_back(dealii::numbers::PI * r * r * density);
  return disks;
}

/// One way to rest. In units of F0, the mean diameter a0 and attraction_time().
struct Protocol
{
  double step;       ///< 0.2 is near the longest that primaries held by few contacts come to rest with
  double kinetic;    ///< energy of a primary that counts as rest
  double tolerance;  ///< of contact solutions: what they leave moves primaries, so it must be below rest
  double overlap;    ///< that a contact solution may add in a step
  unsigned int most; ///< steps
};
/// Contact solutions a hundred times as rough take a tenth of the sweeps.
constexpr Protocol rough = {0.2, 2e-5, 1e-2, 1e-2, 1000};
/// A step changes the velocity of a free primary by 0.2: rest is 2e-3 of that.
constexpr Protocol whole = {0.2, 1e-7, 1e-4, 1e-4, 2000};
/// Where contacts of long steps stir as much as is taken.
constexpr Protocol careful = {0.05, 2e-8, 1e-4, 1e-4, 20000};
/// Primaries at rest have moved by now, if anything moves them.
constexpr unsigned int fewest = 20;

/// @return the kinetic energy at the end, over that of rest; not above 1: at rest
double relax(Aggregate &aggregate,
             const double density,
             const std::shared_ptr<const Attraction> &attraction,
             const Protocol &protocol)
{
  // How the run is to be solved does not matter here, so that one aggregate serves many runs.
  DynamicsSettings settings;
  settings.solver.tolerance = protocol.tolerance;
  settings.solver_penetration = protocol.overlap;
  std::vector<Wall> no_walls;
  Dynamics dynamics(disks_of(aggregate, density), {attraction}, {}, settings);
  dynamics.detect(no_walls);
  const double force = attraction->contact_force(), a0 = dynamics.mean_diameter();
  const double dt = protocol.step * attraction_time(a0, density, force);
  const double rest = protocol.kinetic * force * a0 * aggregate.size();
  double before = 0., now = 0.;
  for (unsigned int step = 0; step < protocol.most; ++step)
  {
    dynamics.step(dt, no_walls, {});
    now = dynamics.kinetic_energy();
    if (step > fewest && now < rest)
      break;
    const bool past_maximum = now < before;
    before = past_maximum ? 0. : now;
    if (past_maximum)
      dynamics.disks().velocity.assign(aggregate.size(), {0., 0.});
  }
  aggregate.position = dynamics.disks().position;
  return now / rest;
}

/// Overlap that stays, and error of the contact solution of the last steps [mean diameters, dimensionless].
constexpr double last_overlap = 1e-10, last_tolerance = 1e-8;
/// One is enough unless primaries turn about each other on their way.
constexpr unsigned int most_last_steps = 10;

/// Pushes out what primaries overlap and closes what is open. A run would else do the first against the
/// attraction, so that contact would give energy.
void touch(Aggregate &aggregate, const double density, const std::shared_ptr<const Attraction> &attraction)
{
  DynamicsSettings settings;
  settings.solver.tolerance = last_tolerance;
  settings.solver_penetration = 0.5 * last_overlap;
  std::vector<Wall> no_walls;
  Dynamics dynamics(disks_of(aggregate, density), {attraction}, {}, settings);
  dynamics.detect(no_walls);
  const double a0 = dynamics.mean_diameter(),
               dt = whole.step * attraction_time(a0, density, attraction->contact_force());
  for (unsigned int step = 0; step < most_last_steps; ++step)
  {
    dynamics.step(dt, no_walls, {});
    dynamics.disks().velocity.assign(aggregate.size(), {0., 0.});
    if (dynamics.penetration() <= last_overlap * a0)
      break;
  }
  aggregate.position = dynamics.disks().position;
}
} // namespace

void settle(Aggregate &aggregate,
            const std::string &name,
            const double density,
            const std::shared_ptr<const Attraction> &attraction,
            const Settling how)
{
  if (how == Settling::roughly)
  {
    relax(aggregate, density, attraction, rough);
    return;
  }
  double left = relax(aggregate, density, attraction, whole);
  if (left > 1.)
    left = relax(aggregate, density, attraction, careful);
  if (left <= 1.)
  {
    touch(aggregate, density, attraction);
    return;
  }
  std::ostringstream message;
  message << "the primaries of body '" << name << "' do not come to rest: after " << careful.most
          << " steps their kinetic energy is " << left << " times that of rest";
  throw ComputationError(message.str());
}
} // namespace softgrain::bpm
