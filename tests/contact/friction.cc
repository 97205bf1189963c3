// SPDX-License-Identifier: LGPL-2.1-or-later
// Frictional problems of many contacts, checked by the conditions themselves: random bodies in the plane and
// in space, rigid modes, friction 0 against the frictionless solution, duplicate contacts, Newton against
// sweeps.
#include "disk_lattice.h"
#include "reference.h"

#include <softgrain/contact/active_set.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <iostream>

using namespace softgrain::contact;

namespace
{
Problem random_problem(const unsigned int n_contacts,
                       const unsigned int n_components,
                       const double mu,
                       const unsigned int seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Problem problem{n_components, {}, std::vector<double>(n_contacts, mu)};
  for (unsigned int i = 0; i < n_contacts * n_components; ++i)
    problem.free_velocity.push_back(normal(generator) - (i % n_components == 0 ? 0.5 : 0.));
  problem.free_velocity[0] = -1.;
  return problem;
}

SolverReport check(const std::string &title,
                   BlockDelassus &W,
                   const Problem &problem,
                   const SolverSettings &settings,
                   std::vector<double> &P)
{
  std::vector<double> w;
  const SolverReport report = solve(W, problem, settings, P, w);
  const double worst =
      worst_violation(problem, W.assemble(), P) / approach_speed(problem, contact_compliance(W));
  std::cout << title << ": converged " << verdict(report.converged) << ", conditions to 10 tolerances "
            << verdict(worst < 10. * settings.tolerance) << '\n';
  std::cerr << title << ": sweeps " << report.sweeps << " newton " << report.newton_iterations
            << " accelerated " << report.accelerated << " regularised " << report.regularised << " residual "
            << report.residual << " worst " << worst << '\n';
  return report;
}
} // namespace

int main()
{
  for (const unsigned int n : {2, 3})
    for (const double mu : {0.1, 0.5, 1.})
      for (const Algorithm algorithm : {Algorithm::gauss_seidel, Algorithm::active_set})
      {
        BlockDelassus W = random_bodies(20, 3, n, 0., 100 + n);
        std::vector<double> P;
        SolverSettings settings;
        settings.tolerance = 1e-10;
        settings.algorithm = algorithm;
        check(std::to_string(n) + " components, mu " + std::to_string(mu) +
                  (algorithm == Algorithm::active_set ? ", active set" : ", sweeps"),
              W, random_problem(W.n_contacts(), n, mu, 200 + n), settings, P);
      }
  for (const double rigid : {1., 1e2, 1e4, 1e6})
    for (const double mu : {0.1, 0.5})
    {
      BlockDelassus W = disk_lattice(5, 4, rigid);
      std::vector<double> P;
      Problem problem = random_problem(W.n_contacts(), 2, mu, 400);
      for (unsigned int i = 0; i < W.n_contacts(); ++i)
      {
        problem.free_velocity[2 * i] = -1. + 0.5 * problem.free_velocity[2 * i]; // squeezed from all sides
        problem.free_velocity[2 * i + 1] *= 0.3;
      }
      const std::string title = "disks, rigid modes " + std::to_string(rigid) + ", mu " + std::to_string(mu);
      check(title, W, problem, {}, P);
      // From the solution of the step before: right about who touches, a little out of balance.
      std::mt19937 generator(500);
      std::uniform_real_distribution<double> about_one(0.999, 1.001);
      for (unsigned int i = 0; i < W.n_contacts(); ++i)
      {
        const double factor = about_one(generator);
        P[2 * i] *= factor;
        P[2 * i + 1] *= factor;
      }
      SolverSettings settings;
      settings.algorithm = Algorithm::active_set;
      const SolverReport report = check(title + ", warm", W, problem, settings, P);
      std::cout << "  no sweeps, few Newton iterations: "
                << verdict(report.sweeps == 0 && report.newton_iterations < 10) << '\n';
    }
  unsigned int failed[2] = {0, 0}, sweeps[2] = {0, 0}, newton = 0;
  for (unsigned int seed = 0; seed < 200; ++seed)
    for (const bool active_set : {false, true})
    {
      BlockDelassus W = random_bodies(2 + seed % 7, 2, 2 + seed % 2, seed % 3 == 0 ? 100. : 0., seed);
      const Problem problem = random_problem(W.n_contacts(), W.n_components(), 0.05 * (seed % 20), seed);
      SolverSettings settings;
      std::vector<double> P, w;
      settings.algorithm = active_set ? Algorithm::automatic : Algorithm::gauss_seidel;
      const auto report = solve(W, problem, settings, P, w);
      const double worst =
          worst_violation(problem, W.assemble(), P) / approach_speed(problem, contact_compliance(W));
      failed[active_set] += !report.converged || worst > 1e-7;
      sweeps[active_set] += report.sweeps;
      newton += report.newton_iterations;
      if (active_set && (!report.converged || worst > 1e-7))
        std::cerr << "seed " << seed << " res " << report.residual << " worst " << worst << " sweeps "
                  << report.sweeps << " newton " << report.newton_iterations << '\n';
    }
  std::cout << "200 random problems, failed by automatic: " << failed[1] << '\n';
  std::cerr << "sweeps only: failed " << failed[0] << ", sweeps " << sweeps[0] << "; automatic: sweeps "
            << sweeps[1] << " newton " << newton << '\n';

  // Without friction the tangents must not matter: same normal impulses as the frictionless solver's.
  {
    BlockDelassus W = random_bodies(10, 3, 2, 0., 7);
    const Problem problem = random_problem(W.n_contacts(), 2, 0., 8);
    std::vector<double> P, P_normal, w;
    SolverSettings settings;
    settings.tolerance = 1e-12;
    solve(W, problem, settings, P, w);
    const Eigen::MatrixXd matrix = W.assemble();
    BlockDelassus normal(W.n_contacts(), 1);
    Eigen::MatrixXd part(W.n_contacts(), W.n_contacts());
    std::vector<unsigned int> rows(W.n_contacts());
    std::iota(rows.begin(), rows.end(), 0);
    Problem frictionless{1, {}, {}};
    for (unsigned int i = 0; i < W.n_contacts(); ++i)
    {
      frictionless.free_velocity.push_back(problem.free_velocity[2 * i]);
      for (unsigned int j = 0; j < W.n_contacts(); ++j)
        part(i, j) = matrix(2 * i, 2 * j);
    }
    normal.add_block(rows, part);
    solve(normal, frictionless, settings, P_normal, w);
    double error = 0.;
    for (unsigned int i = 0; i < W.n_contacts(); ++i)
      error = std::max({error, std::abs(P[2 * i] - P_normal[i]), std::abs(P[2 * i + 1])});
    std::cout << "mu = 0 is frictionless to 1e-9: " << verdict(error < 1e-9) << '\n';
  }
  // Friction at some contacts only, and nothing approaches: no impulse, no residual.
  {
    BlockDelassus W = random_bodies(10, 2, 2, 0., 11);
    Problem problem = random_problem(W.n_contacts(), 2, 0.5, 13);
    for (unsigned int i = 0; i < W.n_contacts(); ++i)
    {
      problem.free_velocity[2 * i] = 1. + std::abs(problem.free_velocity[2 * i]);
      problem.free_velocity[2 * i + 1] *= i % 3;
      problem.friction[i] *= i % 2;
    }
    std::vector<double> P, w;
    const SolverReport report = solve(W, problem, SolverSettings(), P, w);
    std::cout << "all contacts open: converged " << verdict(report.converged && report.residual == 0.)
              << '\n';
  }
  // Every contact twice: W is singular, the sums of the impulses are those of the single contacts'
  // velocities.
  {
    BlockDelassus W = random_bodies(10, 2, 2, 0., 11), twice(2 * W.n_contacts(), 2);
    const Problem problem = random_problem(W.n_contacts(), 2, 0.4, 12);
    Problem doubled = problem;
    const Eigen::MatrixXd matrix = W.assemble();
    Eigen::MatrixXd copies(2 * matrix.rows(), 2 * matrix.rows());
    std::vector<unsigned int> rows(2 * matrix.rows());
    std::iota(rows.begin(), rows.end(), 0);
    copies << matrix, matrix, matrix, matrix;
    twice.add_block(rows, copies);
    doubled.free_velocity.insert(doubled.free_velocity.end(), problem.free_velocity.begin(),
                                 problem.free_velocity.end());
    doubled.friction.insert(doubled.friction.end(), problem.friction.begin(), problem.friction.end());
    for (const Algorithm algorithm : {Algorithm::gauss_seidel, Algorithm::active_set})
    {
      std::vector<double> P;
      SolverSettings settings;
      settings.algorithm = algorithm;
      check(algorithm == Algorithm::active_set ? "every contact twice, active set"
                                               : "every contact twice, sweeps",
            twice, doubled, settings, P);
    }
  }
}
