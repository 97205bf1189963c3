// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/ball_dynamics.h>
#include <softgrain/bpm/dynamics.h>
#include <softgrain/bpm/settling.h>

#include <cmath>
#include <sstream>
#include <vector>

namespace softgrain::bpm
{
namespace
{
/// What moves primaries.
template <int dim>
struct MotionOf;
template <>
struct MotionOf<2> : Dynamics
{
  explicit MotionOf(Primaries disks,
                    const std::shared_ptr<const Attraction> &attraction,
                    const DynamicsSettings &settings)
      : Dynamics(std::move(disks), {attraction}, {}, settings)
  {
    detect(no_walls);
  }
  void go(const double dt) { step(dt, no_walls, {}); }
  Primaries &primaries() { return disks(); }
  double mean_diameter() const { return disks().mean_diameter(); }
  double kinetic_energy() const { return sums().kinetic; }
  double penetration() const { return present().penetration(); }
  std::vector<Wall<2>> no_walls;
};
template <>
struct MotionOf<3> : BallDynamics
{
  explicit MotionOf(Balls balls,
                    const std::shared_ptr<const Attraction> &attraction,
                    const DynamicsSettings &settings)
      : BallDynamics(std::move(balls), {attraction}, settings)
  {
    detect(no_walls);
  }
  void go(const double dt) { step(dt, no_walls, {}); }
  Balls &primaries() { return balls(); }
  double kinetic_energy() const { return sums().kinetic; }
  double penetration() const { return present().penetration(); }
  Walls no_walls;
};

template <int dim>
RoundPrimaries<dim> primaries_of(const Aggregate<dim> &aggregate, const double density)
{
  RoundPrimaries<dim> disks;
  disks.position = aggregate.position;
  disks.radius = aggregate.radius;
  disks.velocity.assign(aggregate.size(), {});
  disks.body.assign(aggregate.size(), 0);
  for (const double r : aggregate.radius)
    disks.mass.push_back(size_of_primary<dim>(r) * density);
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
/// Where thin arms of a shape still tremble.
constexpr Protocol gentle = {0.0125, 2e-8, 1e-5, 1e-5, 20000};
/// Primaries at rest have moved by now, if anything moves them.
constexpr unsigned int fewest = 20;

/// @return the kinetic energy at the end, over that of rest; not above 1: at rest
template <int dim>
double relax(Aggregate<dim> &aggregate,
             const double density,
             const std::shared_ptr<const Attraction> &attraction,
             const Protocol &protocol)
{
  // How the run is to be solved does not matter here, so that one aggregate serves many runs.
  DynamicsSettings settings;
  settings.solver.tolerance = protocol.tolerance;
  settings.solver_penetration = protocol.overlap;
  MotionOf<dim> dynamics(primaries_of(aggregate, density), attraction, settings);
  const double force = attraction->contact_force(), a0 = dynamics.mean_diameter();
  const double dt = protocol.step * attraction_time<dim>(a0, density, force);
  const double rest = protocol.kinetic * force * a0 * aggregate.size();
  double before = 0., now = 0.;
  for (unsigned int step = 0; step < protocol.most; ++step)
  {
    dynamics.go(dt);
    now = dynamics.kinetic_energy();
    if (step > fewest && now < rest)
      break;
    const bool past_maximum = now < before;
    before = past_maximum ? 0. : now;
    if (past_maximum)
      dynamics.primaries().velocity.assign(aggregate.size(), {});
  }
  aggregate.position = dynamics.primaries().position;
  return now / rest;
}

/// Overlap that stays, and error of the contact solution of the last steps [mean diameters, dimensionless].
constexpr double last_overlap = 1e-10, last_tolerance = 1e-8;
/// One is enough unless primaries turn about each other on their way.
constexpr unsigned int most_last_steps = 10;

/// Pushes out what primaries overlap and closes what is open. A run would else do the first against the
/// attraction, so that contact would give energy.
template <int dim>
void touch(Aggregate<dim> &aggregate,
           const double density,
           const std::shared_ptr<const Attraction> &attraction)
{
  DynamicsSettings settings;
  settings.solver.tolerance = last_tolerance;
  settings.solver_penetration = 0.5 * last_overlap;
  MotionOf<dim> dynamics(primaries_of(aggregate, density), attraction, settings);
  const double a0 = dynamics.mean_diameter(),
               dt = whole.step * attraction_time<dim>(a0, density, attraction->contact_force());
  for (unsigned int step = 0; step < most_last_steps; ++step)
  {
    dynamics.go(dt);
    dynamics.primaries().velocity.assign(aggregate.size(), {});
    if (dynamics.penetration() <= last_overlap * a0)
      break;
  }
  aggregate.position = dynamics.primaries().position;
}
} // namespace

void draw_together(Aggregate<3> &aggregate, const double factor)
{
  constexpr unsigned int n_steps = 100;
  constexpr double dt = 1.;
  DynamicsSettings settings;
  settings.solver.tolerance = rough.tolerance;
  settings.solver_penetration = rough.overlap;
  settings.look_ahead = 1.5 * dt;
  MotionOf<3> motion(primaries_of(aggregate, 1.), nullptr, settings);
  Balls &balls = motion.primaries();
  const double rate = (1. - std::pow(factor, -1. / n_steps)) / dt;
  for (unsigned int step = 0; step < n_steps; ++step)
  {
    for (std::size_t i = 0; i < balls.size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        balls.velocity[i][d] = -rate * balls.position[i][d];
    motion.go(dt);
  }
  aggregate.position = balls.position;
}

template <int dim>
void settle(Aggregate<dim> &aggregate,
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
  double left = 0.;
  for (const Protocol &protocol : {whole, careful, gentle})
  {
    left = relax(aggregate, density, attraction, protocol);
    if (left <= 1.)
    {
      touch(aggregate, density, attraction);
      return;
    }
  }
  std::ostringstream message;
  message << "the primaries of body '" << name << "' do not come to rest: after " << gentle.most
          << " steps their kinetic energy is " << left << " times that of rest";
  throw ComputationError(message.str());
}

template void
settle(Aggregate<2> &, const std::string &, double, const std::shared_ptr<const Attraction> &, Settling);
template void
settle(Aggregate<3> &, const std::string &, double, const std::shared_ptr<const Attraction> &, Settling);
} // namespace softgrain::bpm
