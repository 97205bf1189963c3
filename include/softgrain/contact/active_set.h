// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_active_set_h
#define softgrain_contact_active_set_h

#include <softgrain/contact/gauss_seidel.h>

#include <Eigen/SparseCore>

#include <map>
#include <string>

namespace softgrain::contact
{
/// The ways of solve() by the names that parameter files and saved problems use.
const std::map<std::string, Algorithm> &algorithms();

/**
 * @brief Newton on the active set, from @p impulses on; no sweeps.
 *
 * Frictionless: the convex programme min ½ PᵀWP + qᵀP, P >= 0, by block principal pivoting (Júdice and Pires
 * 1994, with the safeguard of Kim and Park 2011) on proximal subproblems W + ε D, D = diag(W), centred at the
 * last iterate, so that redundant rows are harmless; if pivoting does not end, by descent steps on the face
 * that lower the objective monotonically. Friction: semismooth Newton on the equations of Alart and Curnier
 * (1991), with line search on the natural map, from the active set that @p impulses show. @p impulses is
 * replaced only by something with a smaller residual.
 *
 * @param W the Delassus matrix as the operators' assemble() gives it
 * @param problem q and mu
 * @param compliance as contact_compliance() gives it
 * @param settings tolerance and the limit of iterations
 * @param impulses start in, best found out
 * @param report its Newton counters are increased
 * @return the residual natural_residual() of @p impulses
 */
double newton_active_set(const Eigen::SparseMatrix<double, Eigen::RowMajor> &W,
                         const Problem &problem,
                         const std::vector<double> &compliance,
                         const SolverSettings &settings,
                         std::vector<double> &impulses,
                         SolverReport &report);

/**
 * @brief Solves a contact problem: sweeps of gauss_seidel(), Newton where they get nowhere, sweeps to polish.
 *
 * Bodies held by nothing but contacts have a compliance W = W_elastic + c 1 1ᵀ with c much larger than
 * W_elastic, and sweeps need thousands of rounds to find its balance; Newton needs a few systems of the size
 * of the active contacts. Where Newton fails with friction, a path leads to the solution in the
 * plane (follow_path()); in space Newton starts once more from the solution without friction, which is always
 * found, and the friction coefficients are raised to their values as fast as it follows.
 * Algorithm::active_set makes no sweeps where there are impulses to start from. Parameters, exceptions and
 * result as gauss_seidel().
 */
template <class Operator>
SolverReport solve(Operator &op,
                   const Problem &problem,
                   const SolverSettings &settings,
                   std::vector<double> &impulses,
                   std::vector<double> &velocities);
} // namespace softgrain::contact

#endif
