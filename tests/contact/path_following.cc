// SPDX-License-Identifier: LGPL-2.1-or-later
// Paths to the solution of frictional problems, checked by the conditions of contact themselves: from
// nothing, from the solution of a problem close by.
#include "disk_lattice.h"
#include "reference.h"

#include <softgrain/contact/path_following.h>
#include <softgrain/contact/residual.h>

#include <iostream>

using namespace softgrain::contact;

namespace
{
/// Squeezed a little, with free ways to the side.
Problem problem_of(const BlockDelassus &W, const double mu, const unsigned int seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Problem problem{2, {}, std::vector<double>(W.n_contacts(), mu)};
  for (unsigned int i = 0; i < W.n_contacts(); ++i)
  {
    problem.free_velocity.push_back(normal(generator) - 0.2);
    problem.free_velocity.push_back(normal(generator));
  }
  return problem;
}

bool solved(BlockDelassus &W, const Problem &problem, std::vector<double> &P, unsigned int &exchanges)
{
  W.begin(P);
  SolverReport report;
  const auto compliance = contact_compliance(W);
  const double residual = follow_path(W.assemble(), problem, compliance, SolverSettings(), P, report);
  exchanges += report.newton_iterations;
  return residual < 1e-8 &&
         worst_violation(problem, W.assemble(), P) < 1e-7 * approach_speed(problem, compliance);
}
} // namespace

int main()
{
  constexpr unsigned int n_problems = 10;
  for (const double rigid : {1., 1e4})
    for (const double mu : {0.5, 1.})
    {
      unsigned int from_nothing = 0, from_close = 0, long_way = 0, short_way = 0;
      for (unsigned int seed = 0; seed < n_problems; ++seed)
      {
        BlockDelassus W = disk_lattice(5, 4, rigid);
        Problem problem = problem_of(W, mu, seed);
        std::vector<double> P(2 * W.n_contacts(), 0.);
        from_nothing += solved(W, problem, P, long_way);
        std::mt19937 generator(seed);
        std::normal_distribution<double> normal;
        for (double &q : problem.free_velocity)
          q += 0.01 * normal(generator);
        from_close += solved(W, problem, P, short_way);
      }
      std::cout << "rigid modes " << rigid << ", mu " << mu << ": of " << n_problems
                << " solved from nothing " << from_nothing << ", from close by " << from_close
                << ", close by is shorter " << verdict(2 * short_way < long_way) << '\n';
      std::cerr << "exchanges " << long_way << ' ' << short_way << '\n';
    }
}
