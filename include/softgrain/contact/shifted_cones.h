// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_shifted_cones_h
#define softgrain_contact_shifted_cones_h

#include <softgrain/contact/gauss_seidel.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief Solves a problem with cohesive impulses c by a @p solver that knows Coulomb's cone at the origin
 * alone.
 *
 * P + c obeys Signorini and Coulomb with q - W c in place of q, so nothing is approximated: tolerance and
 * residual are those of that problem, whose approach speed counts what cohesion pulls together.
 * @param op as for gauss_seidel(), and so are @p impulses and @p velocities
 * @param solver called with the problem for P + c, its first guess and the velocities to fill
 */
template <class Operator, class Solver>
SolverReport solve_with_shifted_cones(Operator &op,
                                      const Problem &problem,
                                      std::vector<double> &impulses,
                                      std::vector<double> &velocities,
                                      const Solver &solver)
{
  problem.check();
  const unsigned int n = problem.n_components;
  Problem shifted{n, {}, problem.friction, problem.colors};
  std::vector<double> pull(problem.free_velocity.size(), 0.);
  for (unsigned int i = 0; i < problem.n_contacts(); ++i)
    pull[i * n] = -problem.cohesion[i];
  compute_velocities(op, problem, pull, shifted.free_velocity);
  // Where no impulse changes anything there is none, cohesion or not.
  const std::vector<double> compliance = contact_compliance(op);
  for (unsigned int i = 0; i < compliance.size(); ++i)
    if (!(compliance[i] > 0.))
      pull[i * n] = 0.;
  impulses.resize(pull.size(), 0.);
  for (unsigned int i = 0; i < problem.n_contacts(); ++i)
  {
    impulses[i * n] -= pull[i * n];
    if (impulses[i * n] < 0.) // it was held by more
      std::fill_n(&impulses[i * n], n, 0.);
  }
  const SolverReport report = solver(shifted, impulses, velocities);
  for (unsigned int i = 0; i < problem.n_contacts(); ++i)
    impulses[i * n] += pull[i * n];
  return report;
}
} // namespace softgrain::contact

#endif
