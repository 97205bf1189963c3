// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_path_following_h
#define softgrain_contact_path_following_h

#include <softgrain/contact/gauss_seidel.h>

#include <Eigen/SparseCore>

#include <vector>

namespace softgrain::contact
{
/**
 * @brief Contact with Coulomb friction in the plane by following the path from a problem that is solved.
 *
 * In the plane Coulomb's law is a linear complementarity problem: each contact is open, sticks, or slides to
 * one of two sides, and in between all is linear. Impulses that are given solve a problem with another free
 * velocity q₀. As q(t) = q₀ + t (q - q₀) goes to q, the solution goes along straight pieces; where one ends a
 * single contact changes its state. Where the change turns the path back, t falls for a while: this is how
 * the method gets past states that have no neighbour with a larger t, at which Newton's method, interior
 * points and sweeps stay. It is Lemke's method (1965; for friction Stewart and Trinkle 1996, Anitescu and
 * Potra 1997) with any start.
 *
 * From no impulses, with all contacts parting in q₀, the path cannot come back to its start. Up to mu = 1 it
 * ended at a solution wherever it was tried, but it is long (2000 to 50 000 exchanges for 500 closed
 * contacts). From impulses of a problem close by it takes 50 to 500, or is a closed loop. So two paths from
 * the impulses, with different q₀, come first, and the path from nothing is left when it gets too long.
 * Exchanges are counted as Newton iterations in @p report.
 *
 * @param problem of two components
 * @param impulses start in; out best found, if any path came to its end
 * @return the residual natural_residual() of @p impulses, infinity when no path came to its end; other
 * arguments as newton_active_set()
 */
double follow_path(const Eigen::SparseMatrix<double, Eigen::RowMajor> &W,
                   const Problem &problem,
                   const std::vector<double> &compliance,
                   const SolverSettings &settings,
                   std::vector<double> &impulses,
                   SolverReport &report);
} // namespace softgrain::contact

#endif
