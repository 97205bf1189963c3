// SPDX-License-Identifier: LGPL-2.1-or-later
// Loops that a step runs through again and again ask for no memory: sweeps over contacts, stresses, forces,
// stiffness and factors of a body. A step of bonded primaries, and one of a body, ask as often however many
// primaries or points there are.
#include "../contact/packing.h"
#include "../contact/reference.h"
#include "../mpm/scene_of.h"
#include "count_allocations.h"

#include <softgrain/base/parallel.h>
#include <softgrain/contact/disk_solver.h>
#include <softgrain/contact/gauss_seidel.h>
#include <softgrain/linear/banded_solver.h>
#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/stepping/stiffness.h>
#include <softgrain/mpm/stepping/stress.h>

#include <iostream>

using namespace softgrain;

namespace
{
constexpr unsigned int few = 100, many = 1100;

/// One contact after the other, or by colours; with momentum or without.
void sweeps(const unsigned int n_components, const bool coloured, const contact::Algorithm algorithm)
{
  constexpr unsigned int n = 60;
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd H(n * n_components, 40); // of lower rank: sweeps go on for long
  for (unsigned int i = 0; i < H.rows(); ++i)
    for (unsigned int j = 0; j < H.cols(); ++j)
      H(i, j) = normal(generator);
  contact::Problem problem;
  problem.n_components = n_components;
  problem.friction.assign(n_components > 1 ? n : 0, 0.3);
  for (unsigned int i = 0; i < n * n_components; ++i)
    problem.free_velocity.push_back(normal(generator) - 0.5);
  for (unsigned int i = 0; coloured && i < n; ++i)
    problem.colors.push_back({{i, i + 1}});
  const auto made = [&](const unsigned int n_sweeps)
  {
    contact::BlockDelassus W(n, n_components);
    std::vector<unsigned int> rows(n * n_components);
    std::iota(rows.begin(), rows.end(), 0);
    W.add_block(rows, H * H.transpose());
    contact::SolverSettings settings;
    settings.tolerance = 1e-300;
    settings.algorithm = algorithm;
    settings.max_sweeps = n_sweeps;
    std::vector<double> P, w;
    unsigned int done = 0;
    const unsigned long asked =
        allocations_of([&] { done = contact::gauss_seidel(W, problem, settings, P, w).sweeps; });
    return std::make_pair(done, asked);
  };
  const auto first = made(few), second = made(many);
  std::cout << "contact sweeps, components " << n_components << (coloured ? ", coloured" : "")
            << (algorithm == contact::Algorithm::gauss_seidel ? "" : ", momentum") << ": "
            << second.first - first.first << " more ask " << second.second - first.second << " times\n";
}

/// @param friction below 0: without rotations
void disk_sweeps(const double friction, const double rolling)
{
  const auto made = [&](const unsigned int n_sweeps)
  {
    const ::Packing packing = lattice_packing(30, 30);
    DiskSystem system = make_system(packing, {1., 0.02, 1., friction, rolling});
    std::mt19937 generator(5);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < packing.size(); ++i)
      system.bodies.velocity[i] = {{normal(generator), normal(generator)}};
    contact::DiskSolverSettings settings;
    settings.algorithm = contact::DiskAlgorithm::gauss_seidel; // slow: it does not end before
    settings.tolerance = 1e-300;
    settings.max_sweeps = n_sweeps;
    unsigned int done = 0;
    const unsigned long asked =
        allocations_of([&] { done = contact::solve_disks(system.bodies, system.contacts, settings).sweeps; });
    return std::make_pair(done, asked);
  };
  // What walls felt is kept for a while: the list of that grows now and then.
  const auto first = made(50), second = made(250);
  std::cout << "disk sweeps, components "
            << (friction < 0.  ? 1
                : rolling < 0. ? 2
                               : 3)
            << ": " << (second.first > first.first ? "more" : "as many") << " sweeps ask "
            << below(10., static_cast<double>(second.second - first.second)) << " times more\n";
}

void loops_of_a_body(const std::string &f_bar)
{
  const auto model = shipped_scene("verification/four_plates.prm",
                                   {"Material points/F-bar=" + f_bar, "Mesh/Cell size=6e-4"});
  const mpm::Body<2> &body = model->bodies()[0];
  mpm::StepState<2> at;
  SystemMatrix matrix;
  lay_out_stiffness(body.field, matrix, false);
  BandedSolver solver;
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(body.field.n_dofs());
  Eigen::VectorXd force, mass = body.nodes.mass;
  std::map<std::string, unsigned long> asked;
  for (unsigned int round = 0; round < 3; ++round) // the first lays out
  {
    asked["stress"] = allocations_of([&] { mpm::evaluate_stress(body, u, u, {0., true, 0.}, at); });
    asked["forces"] = allocations_of([&] { mpm::internal_force(body, at, force); });
    matrix.set_zero();
    asked["stiffness"] = allocations_of([&] { mpm::add_stiffness(body, at, 1., matrix); });
    matrix.add_mass<2>(mass, 1.);
    asked["factors"] = allocations_of([&] { solver.factorize(matrix); });
  }
  std::cout << "one body, F-bar " << f_bar << ":";
  for (const auto &[what, n] : asked)
    std::cout << ' ' << what << ' ' << n;
  std::cout << '\n';
}

/// Allocations of one of the steps after the first ones, the fewest: lists of neighbours are made now and
/// then.
unsigned long of_step(Model<2> &model)
{
  unsigned long least = std::numeric_limits<unsigned long>::max();
  for (unsigned int step = 0; step < 30; ++step)
  {
    const unsigned long asked = allocations_of([&] { model.advance(1.); });
    least = step < 10 ? least : std::min(least, asked);
  }
  return least;
}

std::unique_ptr<Model<2>> scene(const std::string &file, std::vector<std::string> changes)
{
  changes.insert(changes.end(), {"Output directory=results", "Threads=1"});
  return Input(SOFTGRAIN_SOURCE_DIR "/parameters/" + file, changes).create_model();
}

void steps(const std::string &name,
           const std::string &file,
           const std::vector<std::string> &coarse,
           const std::vector<std::string> &fine)
{
  const auto small = scene(file, coarse), large = scene(file, fine);
  const unsigned long of_small = of_step(*small), of_large = of_step(*large);
  std::cerr << name << ": " << small->n_points() << " points " << of_small << ", " << large->n_points()
            << " points " << of_large << '\n';
  std::cout << name << ": " << (large->n_points() > 3 * small->n_points() ? "more" : "as many")
            << " points, allocations of a step " << below(150., static_cast<double>(of_small)) << ", more "
            << below(10., static_cast<double>(of_large) - static_cast<double>(of_small)) << '\n';
}
} // namespace

int main()
{
  set_n_threads(1);
  for (const unsigned int n_components : {1u, 2u})
    for (const bool coloured : {false, true})
      for (const auto algorithm : {contact::Algorithm::gauss_seidel, contact::Algorithm::automatic})
        sweeps(n_components, coloured, algorithm);
  disk_sweeps(-1., -1.);
  disk_sweeps(0.3, -1.);
  disk_sweeps(0.3, 0.1);
  loops_of_a_body("off");
  loops_of_a_body("on");
  steps("bonded primaries", "gallery/one_grain_bpm.prm", {"Primaries/Number per body=60"},
        {"Primaries/Number per body=240"});
  steps("one body", "verification/bar_period.prm", {"Mesh/Cell size=2e-2"}, {"Mesh/Cell size=1e-2"});
}
