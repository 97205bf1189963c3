// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_interior_point_h
#define softgrain_contact_interior_point_h

#include <softgrain/contact/gauss_seidel.h>

#include <Eigen/SparseCore>

#include <vector>

namespace softgrain::contact
{
/**
 * @brief Interior points for contact with Coulomb friction in the plane, from nothing.
 *
 * In the plane Coulomb's law is a linear complementarity problem: per contact P_n, the tangential impulse as
 * β₊ - β₋ and the speed of slip λ,
 *
 *     0 <= P_n ⟂ w_n >= 0,  0 <= β₊ ⟂ w_t + λ >= 0,  0 <= β₋ ⟂ -w_t + λ >= 0,  0 <= λ ⟂ mu P_n - β₊ - β₋ >=
 * 0.
 *
 * A predictor and a corrector step (Mehrotra 1992) solve it with all products equal to a value that falls to
 * zero, so that no contact is open or closed before the others are known: this finds the balance of bodies
 * that nothing but contacts holds, where a Newton method that starts from a guess of the open ones does not.
 * The problem is not monotone, so the products may stop to fall. Every few steps frictional_newton() tries to
 * finish from the contacts that look closed.
 *
 * @param problem of two components
 * @param impulses in: those that may be closed although they part; best found, out
 * @return the residual natural_residual() of @p impulses; other arguments as newton_active_set()
 */
double interior_point(const Eigen::SparseMatrix<double, Eigen::RowMajor> &W,
                      const Problem &problem,
                      const std::vector<double> &compliance,
                      const SolverSettings &settings,
                      std::vector<double> &impulses,
                      SolverReport &report);
} // namespace softgrain::contact

#endif
