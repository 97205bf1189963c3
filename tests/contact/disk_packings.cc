// SPDX-License-Identifier: LGPL-2.1-or-later
// Packings: frictionless ones against Newton's active set, frictional ones by the conditions themselves; the
// same bits for any number of threads; sweeps that the momentum saves.
#include "packing.h"
#include "reference.h"

#include <softgrain/base/parallel.h>
#include <softgrain/contact/active_set.h>
#include <softgrain/contact/disk_solver.h>
#include <softgrain/contact/mass_delassus.h>

#include <iostream>

using namespace softgrain;
using contact::DiskAlgorithm;

namespace
{
contact::DiskSolverSettings exact(const DiskAlgorithm algorithm, const double tolerance)
{
  contact::DiskSolverSettings settings;
  settings.algorithm = algorithm;
  settings.tolerance = tolerance;
  settings.max_sweeps = 200000;
  return settings;
}

/// Largest difference of the velocities from those that the active set method finds.
double difference(const DiskSystem &system, const DiskSystem &solved)
{
  const auto &bodies = system.bodies;
  const auto &contacts = system.contacts;
  std::vector<unsigned int> start = {0}, dofs;
  std::vector<double> weights, inverse_mass;
  contact::Problem problem;
  for (const double value : bodies.inverse_mass)
    inverse_mass.insert(inverse_mass.end(), 2, value);
  for (std::size_t i = 0; i < contacts.size(); ++i)
  {
    double q = contacts.gap_velocity[i];
    for (unsigned int d = 0; d < 2; ++d)
    {
      const double n = contacts.normal[i][d];
      dofs.push_back(2 * contacts.a[i] + d);
      weights.push_back(n);
      dofs.push_back(2 * contacts.b[i] + d);
      weights.push_back(-n);
      q += n * (bodies.velocity[contacts.a[i]][d] - bodies.velocity[contacts.b[i]][d]);
    }
    start.push_back(dofs.size());
    problem.free_velocity.push_back(q);
  }
  contact::MassDelassus W(1, start, dofs, weights, inverse_mass);
  contact::SolverSettings settings;
  settings.algorithm = contact::Algorithm::active_set;
  settings.tolerance = 1e-12;
  std::vector<double> P, w;
  if (!contact::solve(W, problem, settings, P, w).converged)
    return 1e300;
  double largest = 0.;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      largest = std::max(largest, std::abs(bodies.velocity[i][d] + W.velocities()[2 * i + d] -
                                           solved.bodies.velocity[i][d]));
  return largest;
}

/// Worst violation of any condition (m/s), from velocities built up here from the impulses.
double violation(const DiskSystem &system, const DiskSystem &solved)
{
  auto v = system.bodies.velocity;
  auto omega = system.bodies.angular_velocity;
  const auto &contacts = solved.contacts;
  const auto &m = system.bodies.inverse_mass, &j = system.bodies.inverse_inertia;
  const bool rolls = !contacts.rolling.empty();
  const auto is_wall = [&](const std::size_t i) { return i >= contacts.tile_start.back(); };
  for (std::size_t i = 0; i < contacts.size(); ++i)
  {
    const std::uint32_t a = contacts.a[i], b = contacts.b[i];
    const double n[2] = {contacts.normal[i][0], contacts.normal[i][1]}, t[2] = {-n[1], n[0]};
    const double P = contacts.impulse[i], T = contacts.tangential_impulse[i];
    for (unsigned int d = 0; d < 2; ++d)
    {
      v[a][d] += m[a] * (n[d] * P + t[d] * T);
      v[b][d] -= m[b] * (n[d] * P + (is_wall(i) ? 0. : t[d] * T));
    }
    const double R = rolls ? contacts.rolling_impulse[i] : 0.;
    omega[a] += j[a] * (R - contacts.arm_a[i] * T);
    omega[b] += j[b] * (-R - contacts.arm_b[i] * T);
  }
  double worst = 0.;
  const auto see = [&](const double x) { worst = std::max(worst, x); };
  // |x| <= bound, and x opposes w with all of it where w is not 0
  const auto see_bounded = [&](const double W, const double x, const double bound, const double w)
  {
    see(W * (std::abs(x) - bound));
    see(std::min(std::abs(w), W * std::abs(x + (w > 0. ? bound : -bound))));
  };
  for (std::size_t i = 0; i < contacts.size(); ++i)
  {
    const std::uint32_t a = contacts.a[i], b = contacts.b[i];
    const double n[2] = {contacts.normal[i][0], contacts.normal[i][1]}, t[2] = {-n[1], n[0]};
    double w = contacts.gap_velocity[i], slip = -contacts.arm_a[i] * omega[a] - contacts.arm_b[i] * omega[b];
    for (unsigned int d = 0; d < 2; ++d)
    {
      w += n[d] * (v[a][d] - v[b][d]);
      slip += t[d] * (v[a][d] - (is_wall(i) ? 0. : v[b][d]));
    }
    const double W = m[a] + m[b], P = contacts.impulse[i];
    see(-w);
    see(-W * P);
    see(std::min(std::abs(w), W * P));
    see_bounded(W, contacts.tangential_impulse[i], contacts.friction[i] * P, slip);
    if (rolls)
      see_bounded(j[a] + j[b], contacts.rolling_impulse[i], contacts.rolling[i] * P, omega[a] - omega[b]);
  }
  for (std::size_t i = 0; i < v.size(); ++i)
    see(std::hypot(v[i][0] - solved.bodies.velocity[i][0], v[i][1] - solved.bodies.velocity[i][1]));
  return worst;
}
} // namespace

int main()
{
  for (const unsigned int n : {3, 12, 40})
  {
    const Packing packing = lattice_packing(n, n);
    SystemSettings settings;
    settings.reach = 0.3;
    const DiskSystem system = random_system(packing, settings, n);
    for (const DiskAlgorithm algorithm : {DiskAlgorithm::gauss_seidel, DiskAlgorithm::accelerated})
    {
      DiskSystem solved = system;
      const auto report = solve_disks(solved.bodies, solved.contacts, exact(algorithm, 1e-12));
      const double error = difference(system, solved);
      std::cout << n * n << " disks, " << (algorithm == DiskAlgorithm::accelerated ? "momentum" : "plain")
                << ": converged " << verdict(report.converged) << ", fell back " << verdict(report.fell_back)
                << ", velocities as the active set's to 1e-10 " << verdict(error < 1e-10) << '\n';
      std::cerr << n << ": contacts " << system.contacts.size() << " sweeps " << report.sweeps << " restarts "
                << report.restarts << " error " << error << '\n';
    }
  }
  for (const double friction : {0., 0.1, 0.5})
    for (const double rolling : {-1., 0., 0.05})
      for (const DiskAlgorithm algorithm : {DiskAlgorithm::gauss_seidel, DiskAlgorithm::accelerated})
      {
        SystemSettings settings;
        settings.reach = 0.3;
        settings.friction = friction;
        settings.rolling = rolling;
        const DiskSystem system = random_system(lattice_packing(12, 12), settings, 7);
        DiskSystem solved = system;
        const auto report = solve_disks(solved.bodies, solved.contacts, exact(algorithm, 1e-10));
        const double worst = violation(system, solved);
        std::cout << "friction " << friction << ", rolling " << rolling << ", "
                  << (algorithm == DiskAlgorithm::accelerated ? "momentum" : "plain") << ": converged "
                  << verdict(report.converged) << ", conditions to 1e-9 " << verdict(worst < 1e-9) << '\n';
        std::cerr << "sweeps " << report.sweeps << " fell back " << report.fell_back << " worst " << worst
                  << '\n';
      }
  for (const double friction : {-1., 0.3})
  {
    SystemSettings settings;
    settings.reach = 0.3;
    settings.friction = friction;
    settings.rolling = friction > 0. ? 0.02 : -1.;
    const DiskSystem system = random_system(lattice_packing(60, 60), settings, 3);
    bool same = true;
    DiskSystem first;
    for (const unsigned int threads : {1, 2, 3, 4, 7})
    {
      set_n_threads(threads);
      DiskSystem solved = system;
      solve_disks(solved.bodies, solved.contacts, exact(DiskAlgorithm::accelerated, 1e-4));
      if (threads == 1)
        first = solved;
      same = same && solved.bodies.velocity == first.bodies.velocity &&
             solved.bodies.angular_velocity == first.bodies.angular_velocity &&
             solved.contacts.impulse == first.contacts.impulse &&
             solved.contacts.tangential_impulse == first.contacts.tangential_impulse &&
             solved.contacts.rolling_impulse == first.contacts.rolling_impulse;
    }
    std::cout << "friction " << friction << ", 3600 disks: the same bits with 1, 2, 3, 4, 7 threads "
              << verdict(same) << '\n';

    unsigned int sweeps[3] = {0, 0, 0};
    for (unsigned int way = 0; way < 3; ++way)
    {
      DiskSystem solved = way == 2 ? first : system;
      if (way == 2)
        solved.bodies = system.bodies;
      sweeps[way] =
          solve_disks(solved.bodies, solved.contacts,
                      exact(way == 0 ? DiskAlgorithm::gauss_seidel : DiskAlgorithm::accelerated, 1e-4))
              .sweeps;
    }
    std::cout << "  momentum needs less than half of the sweeps " << verdict(2 * sweeps[1] < sweeps[0])
              << ", a start from the solution at most twenty " << verdict(sweeps[2] <= 20) << '\n';
    std::cerr << "sweeps plain, momentum, warm: " << sweeps[0] << ' ' << sweeps[1] << ' ' << sweeps[2]
              << '\n';
  }
}
