// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables of doc/results/contact-solvers.md: sweeps of each algorithm, times, and errors of the forces on
// walls. Arguments: a packing (first line `N width height`, then `x y radius aggregate`), and friction (below
// 0: none).
#include "../contact/packing.h"

#include <softgrain/base/parallel.h>
#include <softgrain/contact/disk_solver.h>
#include <softgrain/contact/disk_sweeps.h>

#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <iostream>

using namespace softgrain;
using contact::DiskAlgorithm;

namespace
{
constexpr double wall_speed = 0.002; // mean diameters per step

/// Disks at rest, walls that close in: all four prescribed, or held by a mass of their own and pushed.
DiskSystem scene(const Packing &packing, const SystemSettings &settings, const bool pushed)
{
  DiskSystem system = make_system(packing, settings);
  squeeze(system, packing, wall_speed, false);
  double mass = 0.;
  for (std::size_t i = 0; i < packing.size(); ++i)
    mass += 1. / system.bodies.inverse_mass[i];
  for (std::size_t wall = packing.size(); pushed && wall < system.bodies.size(); ++wall)
    system.bodies.inverse_mass[wall] = 100. / mass;
  return system;
}

std::vector<double> wall_impulses(const DiskSystem &system)
{
  const auto &contacts = system.contacts;
  std::vector<double> sums(4, 0.);
  for (std::size_t i = contacts.tile_start.back(); i < contacts.size(); ++i)
    sums[contacts.b[i] - (system.bodies.size() - 4)] += contacts.impulse[i];
  return sums;
}

double wall_error(const DiskSystem &system, const std::vector<double> &reference)
{
  const std::vector<double> sums = wall_impulses(system);
  double error = 0.;
  for (unsigned int wall = 0; wall < 4; ++wall)
    error = std::max(error, std::abs(sums[wall] - reference[wall]));
  return error / *std::max_element(reference.begin(), reference.end());
}

contact::DiskSolverSettings only_residual(const double tolerance)
{
  contact::DiskSolverSettings settings;
  settings.tolerance = tolerance;
  settings.wall_tolerance = 1e300;
  return settings;
}

void print_report(const contact::DiskSolverReport &report)
{
  std::cout << report.sweeps << (report.fell_back ? " (fell back)" : "") << (report.converged ? "" : "+");
}

void cold_start(const DiskSystem &system, const unsigned int max_sweeps)
{
  DiskSystem exact = system;
  auto settings = only_residual(1e-8);
  settings.max_sweeps = 2 * max_sweeps;
  const auto report = solve_disks(exact.bodies, exact.contacts, settings);
  const std::vector<double> reference = wall_impulses(exact);
  std::cout << "reference: residual " << report.residual << " after " << report.sweeps << " sweeps\n"
            << "algorithm | residual | sweeps | error of the wall forces | estimated\n";
  const struct
  {
    const char *name;
    DiskAlgorithm algorithm;
    double relaxation;
  } ways[] = {{"Gauss-Seidel", DiskAlgorithm::gauss_seidel, 1.},
              {"relaxation 1.6", DiskAlgorithm::gauss_seidel, 1.6},
              {"accelerated", DiskAlgorithm::accelerated, 1.}};
  for (const auto &way : ways)
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-6})
    {
      DiskSystem trial = system;
      auto one = only_residual(tolerance);
      one.algorithm = way.algorithm;
      one.relaxation = way.relaxation;
      one.max_sweeps = max_sweeps;
      const auto found = solve_disks(trial.bodies, trial.contacts, one);
      std::cout << way.name << " | " << tolerance << " | ";
      print_report(found);
      std::cout << " | " << wall_error(trial, reference) << " | " << found.wall_change << std::endl;
      if (!found.converged)
        break;
    }
}

/// The disks move with their velocities and the contacts follow; impulses are the start of the next step.
void advance(Packing &packing, DiskSystem &system, double (&walls)[4])
{
  auto &contacts = system.contacts;
  const std::size_t n = packing.size();
  for (std::size_t i = 0; i < n; ++i)
    for (unsigned int d = 0; d < 2; ++d)
      packing.centre[i][d] += system.bodies.velocity[i][d];
  for (unsigned int wall = 0; wall < 4; ++wall)
    walls[wall] += system.bodies.velocity[n + wall][wall / 2];
  for (std::size_t i = 0; i < contacts.size(); ++i)
  {
    const std::uint32_t a = contacts.a[i], b = contacts.b[i];
    double gap;
    if (b < n)
    {
      const double x = packing.centre[a][0] - packing.centre[b][0],
                   y = packing.centre[a][1] - packing.centre[b][1];
      const double distance = std::hypot(x, y);
      contacts.normal[i] = {{x / distance, y / distance}};
      gap = distance - packing.radius[a] - packing.radius[b];
    }
    else
      gap = std::abs(packing.centre[a][(b - n) / 2] - walls[b - n]) - packing.radius[a];
    contacts.gap_velocity[i] = std::max(0., gap);
  }
}

/// Steps of a compaction; every tolerance starts from its own impulses, and the motion is the exact one.
void warm_start(Packing packing, DiskSystem system)
{
  const struct
  {
    DiskAlgorithm algorithm;
    double tolerance, wall_tolerance;
  } ways[] = {{DiskAlgorithm::gauss_seidel, 1e-3, 1e300}, {DiskAlgorithm::accelerated, 1e-2, 1e300},
              {DiskAlgorithm::accelerated, 1e-3, 1e300},  {DiskAlgorithm::accelerated, 1e-4, 1e300},
              {DiskAlgorithm::accelerated, 1e-2, 3e-2},   {DiskAlgorithm::accelerated, 1e-3, 3e-2},
              {DiskAlgorithm::accelerated, 1e-3, 1e-2}};
  constexpr unsigned int n_ways = sizeof(ways) / sizeof(ways[0]), n_steps = 12, first_counted = 4;
  std::vector<std::vector<double>> impulses(n_ways, system.contacts.impulse),
      tangential(n_ways, system.contacts.tangential_impulse);
  double walls[4] = {0., packing.width, 0., packing.height}, sweeps[n_ways] = {}, mean[n_ways] = {},
         worst[n_ways] = {}, estimated[n_ways] = {}, time[n_ways] = {};
  for (unsigned int step = 0; step < n_steps; ++step)
  {
    DiskSystem exact = system;
    auto settings = only_residual(1e-7);
    settings.max_sweeps = 4000;
    solve_disks(exact.bodies, exact.contacts, settings);
    const std::vector<double> reference = wall_impulses(exact);
    for (unsigned int way = 0; way < n_ways; ++way)
    {
      DiskSystem trial = system;
      trial.contacts.impulse = impulses[way];
      trial.contacts.tangential_impulse = tangential[way];
      settings.algorithm = ways[way].algorithm;
      settings.tolerance = ways[way].tolerance;
      settings.wall_tolerance = ways[way].wall_tolerance;
      settings.max_sweeps = 2000;
      const auto start = std::chrono::steady_clock::now();
      const auto report = solve_disks(trial.bodies, trial.contacts, settings);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      impulses[way] = trial.contacts.impulse;
      tangential[way] = trial.contacts.tangential_impulse;
      if (step < first_counted)
        continue;
      const double error = wall_error(trial, reference), share = 1. / (n_steps - first_counted);
      sweeps[way] += share * report.sweeps;
      mean[way] += share * error;
      worst[way] = std::max(worst[way], error);
      estimated[way] += share * report.wall_change;
      time[way] += share * seconds;
    }
    system = exact;
    advance(packing, system, walls);
  }
  std::cout << "algorithm | residual | wall tolerance | sweeps a step | wall error, mean | worst | estimated "
               "| ms a "
               "step\n";
  for (unsigned int way = 0; way < n_ways; ++way)
    std::cout << (ways[way].algorithm == DiskAlgorithm::accelerated ? "accelerated" : "Gauss-Seidel") << " | "
              << ways[way].tolerance << " | " << ways[way].wall_tolerance << " | " << sweeps[way] << " | "
              << mean[way] << " | " << worst[way] << " | " << estimated[way] << " | " << 1e3 * time[way]
              << '\n';
}

/// Shortest times of single loops, so that other programs on the machine matter little.
template <unsigned int n>
void times(const DiskSystem &system)
{
  std::cout << "threads | sweep | with momentum | residual | from the start, per call [ns per contact]\n";
  for (const unsigned int threads : {1, 2})
  {
    contact::ThreadTeam team(threads);
    contact::DiskSweeps<n> sweeps(system.bodies, system.contacts, team);
    sweeps.set_free_velocities();
    double shortest[4] = {1e9, 1e9, 1e9, 1e9};
    const auto measure = [&](double &time, const auto &work)
    {
      const auto start = std::chrono::steady_clock::now();
      work();
      const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
      time = std::min(time, 1e9 * duration.count() / system.contacts.size());
    };
    for (unsigned int i = 0; i < 400; ++i)
    {
      measure(shortest[0], [&] { sweeps.sweep(1.); });
      measure(shortest[1], [&] { sweeps.sweep_with_momentum(0.5); });
      measure(shortest[2], [&] { sweeps.measure(); });
    }
    set_n_threads(threads);
    auto settings = only_residual(1e-3);
    settings.max_sweeps = 0;
    for (unsigned int i = 0; i < 10; ++i)
    {
      DiskSystem trial = system;
      measure(shortest[3], [&] { solve_disks(trial.bodies, trial.contacts, settings); });
    }
    std::cout << threads << " | " << shortest[0] << " | " << shortest[1] << " | " << shortest[2] << " | "
              << shortest[3] << '\n';
  }
}
} // namespace

int main(int argc, char **argv)
{
  if (argc < 2)
  {
    std::cerr << "disk_solver PACKING [FRICTION]\n";
    return 2;
  }
  Packing packing = read_packing(argv[1]);
  sort_packing(packing);
  SystemSettings settings;
  settings.reach = 0.1;
  settings.friction = argc > 2 ? std::atof(argv[2]) : -1.;
  const bool friction = settings.friction >= 0.;
  std::cout << std::setprecision(3);
  for (const bool pushed : {true, false})
  {
    const DiskSystem system = scene(packing, settings, pushed);
    const unsigned int max_sweeps = friction ? 3000 : 5000;
    std::cout << "\n"
              << packing.size() << " disks, " << system.contacts.size() << " contacts, walls "
              << (pushed ? "pushed" : "at constant speed") << "\n\nCold start\n";
    cold_start(system, max_sweeps);
    std::cout << "\nCompaction, warm start\n";
    warm_start(packing, system);
  }
  std::cout << "\nTimes\n";
  const DiskSystem system = scene(packing, settings, true);
  if (friction)
    times<2>(system);
  else
    times<1>(system);
}
