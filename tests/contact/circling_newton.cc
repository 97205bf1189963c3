// SPDX-License-Identifier: LGPL-2.1-or-later
// Problems with friction in which Newton's method repeats a few iterates: one contact neither sticks nor
// slides as the others are. A path solves the problem.
#include "disk_lattice.h"
#include "reference.h"

#include <softgrain/contact/active_set.h>
#include <softgrain/contact/residual.h>

#include <iostream>

using namespace softgrain::contact;

namespace
{
void draw(std::vector<double> &velocity, std::mt19937 &generator, const double size, const double mean)
{
  std::normal_distribution<double> normal;
  for (unsigned int k = 0; k < velocity.size(); ++k)
    velocity[k] += size * normal(generator) + (k % 2 == 0 ? mean : 0.);
}

struct Case
{
  double rigid, mu;
  unsigned int seed;
};
} // namespace

int main()
{
  for (const Case &here : {Case{1., 2., 149}, Case{1e4, 1., 205}, Case{1e4, 2., 66}})
  {
    BlockDelassus W = disk_lattice(5, 4, here.rigid);
    std::mt19937 generator(here.seed);
    Problem problem{2, std::vector<double>(2 * W.n_contacts()), std::vector<double>(W.n_contacts(), here.mu)};
    draw(problem.free_velocity, generator, 1., -0.2);
    SolverSettings settings;
    settings.algorithm = Algorithm::active_set;
    std::vector<double> start, velocities;
    solve(W, problem, settings, start, velocities);
    draw(problem.free_velocity, generator, 0.05, 0.); // a problem close by

    std::vector<double> P = start, w;
    const SolverReport report = solve(W, problem, settings, P, w);
    const double residual = natural_residual(problem, contact_compliance(W), P, w);
    std::cout << "rigid modes " << here.rigid << ", mu " << here.mu << ": solved " << report.converged
              << ", more than a dozen iterations " << (report.newton_iterations > 12) << "; residual "
              << verdict(residual <= settings.tolerance) << '\n';
  }
}
