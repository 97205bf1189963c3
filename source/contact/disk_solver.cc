// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/exchange.h>
#include <softgrain/base/interruption.h>
#include <softgrain/base/parallel.h>
#include <softgrain/contact/disk_solver.h>
#include <softgrain/contact/disk_sweeps.h>
#include <softgrain/contact/momentum.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

namespace softgrain::contact
{
namespace
{
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

/// Vectors one by one; @p what they are, the number of the first that is not finite behind it.
template <std::size_t n>
void check_finite(const std::vector<std::array<double, n>> &vectors, const char *what)
{
  for (std::size_t i = 0; i < vectors.size(); ++i)
    if (!std::isfinite(std::accumulate(vectors[i].begin(), vectors[i].end(), 0.)))
      throw ComputationError(std::string("disk contacts: ") + what + " " + std::to_string(i) +
                             " is not finite");
}

void check(const DiskSolverSettings &settings)
{
  if (!(settings.tolerance > 0.) || !(settings.wall_tolerance > 0.) || !(settings.wall_floor >= 0.) ||
      !(settings.penetration_tolerance >= 0.))
    throw InputError("disk solver: the tolerances must be positive");
  if (!(settings.relaxation > 0. && settings.relaxation < 2.))
    throw InputError("disk solver: the relaxation must be between 0 and 2, not " +
                     std::to_string(settings.relaxation));
  if (settings.check_interval == 0)
    throw InputError("disk solver: the check interval must be at least 1");
}

template <int dim>
void check(const RoundBodies<dim> &bodies, const RoundContacts<dim> &contacts)
{
  const std::size_t n_bodies = bodies.size(), n = contacts.size();
  check_size(bodies.inverse_mass.size(), n_bodies, "the inverse mass");
  check_finite(bodies.inverse_mass, "inverse mass");
  check_finite(bodies.velocity, "the velocity of body");
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
  check_finite(contacts.normal, "normal");
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
    check_size(contacts.wall_slip.size(), contacts.wall_slip.empty() ? 0 : n, "the slip of walls");
    check_finite(contacts.wall_slip, "slip of a wall");
  }
  check_size(contacts.branch.size(), contacts.branch.empty() ? 0 : n, "the branch");
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

/// Velocity that is lost in the rounding of the fastest body's [m/s].
template <int dim>
double rounding_of(const RoundBodies<dim> &bodies)
{
  double fastest = 0.;
  for (const auto &velocity : bodies.velocity)
    for (const double component : velocity)
      fastest = std::max(fastest, std::abs(component));
  return 8. * std::numeric_limits<double>::epsilon() * fastest;
}

/// @p here is not negative.
double largest_of(const Exchange &exchange, double here)
{
  for (const std::vector<double> &other : exchange.of_all({here}))
    here = std::max(here, other[0]);
  return here;
}

/// Sweeps after which all tell each other of a request to stop.
constexpr unsigned int sweeps_between_words = 500;

/// Sweeps after which velocities are computed afresh.
constexpr unsigned int refresh_interval = 1000;

/**
 * Estimates how wrong the impulses on the walls still are: by the farthest that they have been from now in
 * the later half of the sweeps. Errors of sweeps fall like a power of their number before they fall faster,
 * and with the power -1 that is the error itself; under momentum they swing, and that is seen too.
 */
class WallBalance
{
public:
  explicit WallBalance(const double floor) : floor(floor) {}

  /// Takes the impulses on the walls; returns the estimated error over the largest of them, or the floor.
  double estimate(const std::vector<double> &impulses)
  {
    const std::size_t n = impulses.size(), last = n_estimates++;
    history.insert(history.end(), impulses.begin(), impulses.end());
    double largest = floor, error = 0.;
    for (const double impulse : impulses)
      largest = std::max(largest, std::abs(impulse));
    if (largest == 0.)
      return 0.;
    if (last == 0)
      return 1.;
    const std::size_t middle = last / 2, step = 1 + middle / 64; // enough to see it swing
    for (std::size_t i = middle; i < last; i += step)
      for (std::size_t wall = 0; wall < n; ++wall)
        error = std::max(error, std::abs(impulses[wall] - history[i * n + wall]));
    return error / largest;
  }

private:
  const double floor;          ///< [N s/m]
  std::vector<double> history; ///< of all walls, one estimate after the other
  std::size_t n_estimates = 0;
};

/// One call of solve_disks() or solve_balls().
template <unsigned int n, bool in_cell, int dim>
class DiskIteration
{
public:
  DiskIteration(RoundBodies<dim> &bodies,
                RoundContacts<dim> &contacts,
                const DiskSolverSettings &settings,
                const Exchange *const exchange,
                const DiskExchanges *const exchanges)
      : bodies(bodies)
      , contacts(contacts)
      , settings(settings)
      , team(contacts.size() < contacts_to_share ? 1 : n_threads())
      , exchange(exchange)
      , apart(exchanges != nullptr)
      , sweeps(bodies,
               contacts,
               team,
               !apart && contacts.size() < contacts_to_share ? nullptr : exchange,
               exchanges)
      , rounding(apart ? largest_of(*exchange, rounding_of(bodies)) : rounding_of(bodies))
      , momentum(n)
      , walls(settings.wall_floor)
      , accelerating(settings.algorithm == DiskAlgorithm::accelerated)
  {
  }

  DiskSolverReport run()
  {
    std::optional<Exchange::OwnWork> own;
    if (sweeps.shared() && !apart) // else the caller sees to that
      own.emplace(*exchange);
    sweeps.set_free_velocities();
    speed = sweeps.measure().approach;
    if (speed <= rounding) // nothing approaches: no impulses solve the problem exactly
    {
      sweeps.clear_impulses();
      report.converged = true;
    }
    else
    {
      sweeps.apply_impulses();
      sweeps.wall_impulses(wall_impulses);
      report.wall_change = walls.estimate(wall_impulses);
      while (report.sweeps < settings.max_sweeps && !report.converged)
      {
        // Those who sweep all contacts do not meet otherwise.
        if (exchange != nullptr && !sweeps.shared() && report.sweeps % sweeps_between_words == 0)
          exchange->share({});
        stop_if_interrupted();
        sweep();
        if (report.sweeps % settings.check_interval == 0 || report.sweeps == settings.max_sweeps)
          check();
      }
      if (!report.converged)
        refresh();
    }
    // Then what is left is rounding, and no part of a speed of approach that is little more.
    if (report.converged && report.residual > settings.tolerance)
      report.residual = 0.;
    sweeps.store_impulses(contacts);
    sweeps.store_velocities(bodies);
    return report;
  }

private:
  void sweep()
  {
    ++report.sweeps;
    ++sweeps_since_refresh;
    if (!accelerating)
      sweeps.sweep(settings.relaxation);
    // Without friction the sweeps descend a convex function, and the sum says when the momentum does not.
    else if (sweeps.sweep_with_momentum(momentum.next()) > 0. && n == 1)
    {
      momentum.restart();
      ++report.restarts;
    }
  }

  void check()
  {
    sweeps.wall_impulses(wall_impulses);
    report.wall_change = walls.estimate(wall_impulses);
    measure();
    if (report.converged || sweeps_since_refresh >= refresh_interval)
    {
      refresh();
      momentum.restart();
    }
    if (!accelerating || report.converged)
      return;
    const Momentum::Verdict verdict = momentum.judge(report.residual);
    if (verdict == Momentum::Verdict::give_up)
      fall_back();
    else if (verdict == Momentum::Verdict::restarted)
      ++report.restarts;
    else if (report.residual < 0.5 * saved)
    {
      saved = report.residual;
      sweeps.save_impulses();
    }
  }

  void fall_back()
  {
    accelerating = false;
    report.fell_back = true;
    sweeps.restore_impulses();
    refresh();
  }

  /// Velocities afresh from the impulses: sweeps collect rounding, and momentum multiplies it.
  void refresh()
  {
    sweeps_since_refresh = 0;
    sweeps.set_free_velocities();
    sweeps.apply_impulses();
    measure();
  }

  void measure()
  {
    const auto measured = sweeps.measure();
    report.residual = measured.natural_map / speed;
    report.approach = measured.approach;
    if (!std::isfinite(report.residual) && !accelerating)
      throw ComputationError("disk contacts: an impulse is no longer finite after " +
                             std::to_string(report.sweeps) + " sweeps");
    report.converged =
        (report.residual <= settings.tolerance || measured.natural_map <= rounding) &&
        report.wall_change <= settings.wall_tolerance &&
        (settings.penetration_tolerance == 0. || report.approach <= settings.penetration_tolerance);
  }

  RoundBodies<dim> &bodies;
  RoundContacts<dim> &contacts;
  const DiskSolverSettings &settings;
  ThreadTeam team;
  const Exchange *const exchange; ///< null: this process is alone
  const bool apart;               ///< each has its own contacts alone
  DiskSweeps<n, in_cell, dim> sweeps;
  const double rounding;
  Momentum momentum;
  WallBalance walls;
  std::vector<double> wall_impulses;
  DiskSolverReport report;
  bool accelerating;
  double speed = 0.;
  unsigned int sweeps_since_refresh = 0;
  double saved = std::numeric_limits<double>::max();
};

template <bool in_cell>
DiskSolverReport iterate(DiskBodies &bodies,
                         DiskContacts &contacts,
                         const DiskSolverSettings &settings,
                         const Exchange *const exchange,
                         const DiskExchanges *const exchanges)
{
  if (exchanges != nullptr ? !exchanges->rotate : !bodies.rotate())
    return DiskIteration<1, in_cell, 2>(bodies, contacts, settings, exchange, exchanges).run();
  if (contacts.rolling.empty())
    return DiskIteration<2, in_cell, 2>(bodies, contacts, settings, exchange, exchanges).run();
  return DiskIteration<3, in_cell, 2>(bodies, contacts, settings, exchange, exchanges).run();
}
} // namespace

DiskSolverReport solve_disks(DiskBodies &bodies,
                             DiskContacts &contacts,
                             const DiskSolverSettings &settings,
                             const Exchange *exchange,
                             const DiskExchanges *const exchanges)
{
  check(settings);
  if (exchanges == nullptr)
    check(bodies, contacts);
  else // what one finds ends it for all
    exchange->together([&]() { check(bodies, contacts); });
  if (exchange != nullptr && exchange->alone())
    exchange = nullptr;
  return contacts.branch.empty() ? iterate<false>(bodies, contacts, settings, exchange, exchanges)
                                 : iterate<true>(bodies, contacts, settings, exchange, exchanges);
}

DiskSolverReport solve_balls(BallBodies &bodies, BallContacts &contacts, const DiskSolverSettings &settings)
{
  check(settings);
  check(bodies, contacts);
  if (!contacts.rolling.empty() || !contacts.branch.empty())
    throw InputError("balls: neither rolling resistance nor a cell that deforms is there in space");
  return bodies.rotate() ? DiskIteration<4, false, 3>(bodies, contacts, settings, nullptr, nullptr).run()
                         : DiskIteration<1, false, 3>(bodies, contacts, settings, nullptr, nullptr).run();
}
} // namespace softgrain::contact
