// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/contact/disk_solver.h>
#include <softgrain/contact/disk_sweeps.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace softgrain::contact
{
namespace
{
/// Contacts below which the other threads would cost more than they do.
constexpr std::size_t contacts_for_threads = 4000;

void check_size(const std::size_t size, const std::size_t expected, const char *name)
{
  if (size != expected)
    throw InputError(std::string("disk contacts: ") + std::to_string(size) + " values of " + name + ", " +
                     std::to_string(expected) + " expected");
}

void check_finite(const std::vector<double> &values, const char *name)
{
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw ComputationError(std::string("disk contacts: ") + name + " " + std::to_string(i) +
                             " is not finite");
}

void check(const DiskSolverSettings &settings)
{
  if (!(settings.tolerance > 0.) || !(settings.wall_tolerance > 0.) ||
      !(settings.penetration_tolerance >= 0.))
    throw InputError("disk solver: the tolerances must be positive");
  if (!(settings.relaxation > 0. && settings.relaxation < 2.))
    throw InputError("disk solver: the relaxation must be between 0 and 2, not " +
                     std::to_string(settings.relaxation));
  if (settings.check_interval == 0)
    throw InputError("disk solver: the check interval must be at least 1");
}

void check(const DiskBodies &bodies, const DiskContacts &contacts)
{
  const std::size_t n_bodies = bodies.size(), n = contacts.size();
  check_size(bodies.inverse_mass.size(), n_bodies, "the inverse mass");
  check_finite(bodies.inverse_mass, "inverse mass");
  for (const auto &velocity : bodies.velocity)
    if (!std::isfinite(velocity[0] + velocity[1]))
      throw ComputationError("disk contacts: the velocity of body " +
                             std::to_string(&velocity - bodies.velocity.data()) + " is not finite");
  check_size(contacts.b.size(), n, "the second body");
  check_size(contacts.normal.size(), n, "the normal");
  check_size(contacts.gap_velocity.size(), n, "the gap velocity");
  check_size(contacts.impulse.size(), n, "the impulse");
  check_finite(contacts.gap_velocity, "gap velocity");
  check_finite(contacts.impulse, "impulse");
  for (std::size_t i = 0; i < n; ++i)
    if (contacts.a[i] >= n_bodies || contacts.b[i] >= n_bodies || contacts.a[i] == contacts.b[i])
      throw InputError("disk contacts: contact " + std::to_string(i) + " joins bodies " +
                       std::to_string(contacts.a[i]) + " and " + std::to_string(contacts.b[i]) + " of " +
                       std::to_string(n_bodies));
    else if (!std::isfinite(contacts.normal[i][0] + contacts.normal[i][1]))
      throw ComputationError("disk contacts: normal " + std::to_string(i) + " is not finite");
  if (bodies.rotate())
  {
    check_size(bodies.angular_velocity.size(), n_bodies, "the angular velocity");
    check_size(bodies.inverse_inertia.size(), n_bodies, "the inverse inertia");
    check_finite(bodies.angular_velocity, "angular velocity");
    check_finite(bodies.inverse_inertia, "inverse inertia");
    check_size(contacts.friction.size(), n, "the friction");
    check_size(contacts.arm_a.size(), n, "the first arm");
    check_size(contacts.arm_b.size(), n, "the second arm");
    check_size(contacts.tangential_impulse.size(), n, "the tangential impulse");
    check_finite(contacts.friction, "friction");
    check_finite(contacts.arm_a, "arm");
    check_finite(contacts.arm_b, "arm");
    check_finite(contacts.tangential_impulse, "tangential impulse");
  }
  check_size(contacts.rolling.size(), bodies.rotate() && !contacts.rolling.empty() ? n : 0,
             "the rolling resistance");
  check_size(contacts.rolling_impulse.size(), contacts.rolling.size(), "the rolling impulse");
  check_finite(contacts.rolling, "rolling resistance");
  check_finite(contacts.rolling_impulse, "rolling impulse");

  const auto &tiles = contacts.tile_start, &colours = contacts.colour_start;
  if (tiles.empty() || !std::is_sorted(tiles.begin(), tiles.end()) || tiles.front() != 0 || tiles.back() > n)
    throw InputError("disk contacts: the tiles are not an ordered division of the contacts");
  if (colours.empty() || !std::is_sorted(colours.begin(), colours.end()) || colours.front() != 0 ||
      colours.back() + 1 != tiles.size())
    throw InputError("disk contacts: the colours are not an ordered division of the tiles");
}

/// Estimates how wrong the impulses on the walls still are, from their last changes.
class WallBalance
{
public:
  /// Takes the impulses on the walls; returns the estimated error over the largest of them.
  double estimate(const std::vector<double> &impulses)
  {
    double change = 0., largest = 0.;
    for (std::size_t i = 0; i < impulses.size(); ++i)
    {
      largest = std::max(largest, std::abs(impulses[i]));
      if (!last.empty())
        change = std::max(change, std::abs(impulses[i] - last[i]));
    }
    const bool first = last.empty();
    last = impulses;
    if (largest == 0.)
      return 0.;
    if (first)
      return 1.;
    // Changes that fall by a factor r from one to the next add up to the last one times r / (1 - r).
    const double rate = last_change > 0. ? std::min(0.95, std::max(0.5, change / last_change)) : 0.95;
    last_change = change;
    return change * rate / (1. - rate) / largest;
  }

private:
  std::vector<double> last;
  double last_change = 0.;
};

template <unsigned int n>
DiskSolverReport solve(DiskBodies &bodies, DiskContacts &contacts, const DiskSolverSettings &settings)
{
  DiskSolverReport report;
  ThreadTeam team(contacts.size() < contacts_for_threads ? 1 : n_threads());
  DiskSweeps<n> sweeps(bodies, contacts, team);
  sweeps.set_free_velocities();
  const double speed = sweeps.measure().approach;
  const auto finish = [&]
  {
    sweeps.store_impulses(contacts);
    sweeps.store_velocities(bodies);
    return report;
  };
  if (speed == 0.) // nothing approaches: no impulses solve the problem exactly
  {
    sweeps.clear_impulses();
    report.converged = true;
    return finish();
  }
  sweeps.apply_impulses();

  WallBalance walls;
  std::vector<double> wall_impulses;
  const auto measure = [&]
  {
    const auto measured = sweeps.measure();
    report.residual = measured.natural_map / speed;
    report.approach = measured.approach;
    if (!std::isfinite(report.residual))
      throw ComputationError("disk contacts: an impulse is no longer finite after " +
                             std::to_string(report.sweeps) + " sweeps");
    report.converged =
        report.residual <= settings.tolerance && report.wall_change <= settings.wall_tolerance &&
        (settings.penetration_tolerance == 0. || report.approach <= settings.penetration_tolerance);
  };
  const auto estimate_walls = [&]
  {
    sweeps.wall_impulses(wall_impulses);
    report.wall_change = walls.estimate(wall_impulses);
  };
  estimate_walls();
  while (report.sweeps < settings.max_sweeps)
  {
    sweeps.sweep(settings.relaxation);
    ++report.sweeps;
    if (report.sweeps % settings.check_interval != 0 && report.sweeps < settings.max_sweeps)
      continue;
    estimate_walls();
    measure();
    if (report.converged)
    {
      // afresh from the impulses: sweeps collect rounding
      sweeps.set_free_velocities();
      sweeps.apply_impulses();
      measure();
      if (report.converged)
        break;
    }
  }
  if (!report.converged)
  {
    sweeps.set_free_velocities();
    sweeps.apply_impulses();
    measure();
  }
  return finish();
}
} // namespace

DiskSolverReport solve_disks(DiskBodies &bodies, DiskContacts &contacts, const DiskSolverSettings &settings)
{
  check(settings);
  check(bodies, contacts);
  if (!bodies.rotate())
    return solve<1>(bodies, contacts, settings);
  if (contacts.rolling.empty())
    return solve<2>(bodies, contacts, settings);
  return solve<3>(bodies, contacts, settings);
}
} // namespace softgrain::contact
