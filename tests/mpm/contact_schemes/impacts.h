// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_contact_schemes_impacts_h
#define softgrain_tests_mpm_contact_schemes_impacts_h

// The impacts that schemes are compared on. Units: length and wave speed of the (shorter) bar, density 1.
#include "exact_bar.h"
#include "measures.h"
#include "schemes.h"

#include <string>

namespace softgrain::schemes
{
constexpr double impact_speed = 1e-3;
constexpr int n_cells = 100;
constexpr unsigned int n_phases = 10;

/// Root of the mean square of u less the exact displacement, over the nodes of a bar of length 1.
inline double error_of(const Eigen::VectorXd &u, const ExactBar &exact, const double t)
{
  double sum = 0.;
  for (int i = 0; i < u.size(); ++i)
  {
    const double difference = u[i] - exact.displacement(i / double(u.size() - 1), t);
    sum += difference * difference;
  }
  return std::sqrt(sum / u.size());
}

/// A bar without load meets a wall at a @p phase of the second step, and leaves it after 2 L/c.
inline ImpactMeasures
bar_meets_wall(const std::string &scheme, const Mass mass, const double cfl, const double phase)
{
  const double dt = cfl / n_cells, start = (1. + phase) * dt;
  const Fall fall{1., 1., 1., start * impact_speed, impact_speed, 0.};
  const ElasticSystem system = bar_and_wall(n_cells, 1., 1., 1., mass, fall.gap);
  const double energy = 0.5 * impact_speed * impact_speed, end = start + 1.5 * fall.round_trip();
  const ExactBar exact(fall, end + dt);
  ImpactMeasures measures({start, start + fall.round_trip(), impact_speed, energy, impact_speed});
  const auto method = make_scheme(scheme, system, dt, cfl);
  Motion motion{Eigen::VectorXd::Zero(n_cells + 1), Eigen::VectorXd::Constant(n_cells + 1, -impact_speed)};
  for (unsigned int n = 0; n * dt < end; ++n)
  {
    const double impulse = method->step(motion), t = (n + 1) * dt;
    measures.look(n * dt, t, impulse, system.energy(motion.u, motion.v), system.gap_at(motion.u),
                  error_of(motion.u, exact, t));
  }
  measures.restitution = (system.mass * motion.v).sum() / impact_speed;
  return measures;
}

/// A bar meets one of twice its length at rest. It gives all its momentum away in 2 L/c and stays; the
/// pressure is half of that of a wall. @p restitution is the speed of the longer bar less that of the shorter
/// one: exactly the ratio of lengths.
inline ImpactMeasures
bar_meets_bar(const std::string &scheme, const Mass mass, const double cfl, const double phase)
{
  const double dt = cfl / n_cells, start = (1. + phase) * dt;
  const ElasticSystem system = two_bars(n_cells, 1., mass, start * impact_speed);
  ImpactMeasures measures(
      {start, start + 2., 0.5 * impact_speed, 0.5 * impact_speed * impact_speed, 0.5 * impact_speed});
  const auto method = make_scheme(scheme, system, dt, cfl);
  Motion motion{Eigen::VectorXd::Zero(3 * n_cells + 2), Eigen::VectorXd::Zero(3 * n_cells + 2)};
  motion.v.head(n_cells + 1).setConstant(impact_speed);
  // The wave in the longer bar comes back at 4 and opens the gap for good.
  for (unsigned int n = 0; n * dt < start + 3.8; ++n)
  {
    const double impulse = method->step(motion);
    measures.look(n * dt, (n + 1) * dt, impulse, system.energy(motion.u, motion.v), system.gap_at(motion.u),
                  0.);
  }
  const Eigen::VectorXd momentum = system.mass * motion.v;
  measures.restitution =
      (0.5 * momentum.tail(2 * n_cells + 1).sum() - momentum.head(n_cells + 1).sum()) / impact_speed;
  return measures;
}

/// A bar falls on a wall and bounces.
struct Bounces
{
  double gained = 0.;       ///< energy, at most, over that of the fall
  double kept = 0.;         ///< the same at the end; exactly 0
  double penetration = 0.;  ///< over the height of the fall
  double displacement = 0.; ///< error, largest r.m.s. up to the end, over the height
};

/// E = 900, density 1, length 10, height 5, g = 10: the fall takes 1 s, contact 2/3 s.
inline Bounces bouncing_bar(const std::string &scheme, const Mass mass, const double cfl, const double end)
{
  const Fall fall{10., 900., 1., 5., 0., 10.};
  const double dt = cfl * fall.length / n_cells / fall.wave_speed(),
               energy = fall.gap * fall.gravity * fall.length;
  ElasticSystem system = bar_and_wall(n_cells, fall.length, fall.modulus, fall.density, mass, fall.gap);
  system.load = -fall.gravity * (system.mass * Eigen::VectorXd::Ones(n_cells + 1));
  const ExactBar exact(fall, end + dt);
  const auto method = make_scheme(scheme, system, dt, cfl);
  Motion motion{Eigen::VectorXd::Zero(n_cells + 1), Eigen::VectorXd::Zero(n_cells + 1)};
  Bounces bounces;
  for (unsigned int n = 0; (n + 1) * dt < end * (1. + 1e-12); ++n)
  {
    method->step(motion);
    const double t = (n + 1) * dt;
    bounces.kept = system.energy(motion.u, motion.v) / energy;
    bounces.gained = std::max(bounces.gained, bounces.kept);
    bounces.penetration = std::max(bounces.penetration, -system.gap_at(motion.u) / fall.gap);
    double sum = 0.;
    for (int i = 0; i <= n_cells; ++i)
    {
      const double difference = motion.u[i] - exact.displacement(fall.length * i / n_cells, t);
      sum += difference * difference / (n_cells + 1);
    }
    bounces.displacement = std::max(bounces.displacement, std::sqrt(sum) / fall.gap);
  }
  return bounces;
}
} // namespace softgrain::schemes

#endif
