// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_frictional_newton_h
#define softgrain_contact_frictional_newton_h

#include <softgrain/contact/gauss_seidel.h>

#include <Eigen/SparseCore>

#include <vector>

namespace softgrain::contact
{
/**
 * @brief Semismooth Newton for contact with Coulomb friction (Alart and Curnier 1991), @p n = 2 or 3
 * components.
 *
 * With ρ = 1 / compliance a contact is open where P_n - ρ w_n <= 0, else it sticks where |P_t - ρ w_t| <= mu
 * (P_n - ρ w_n) and slips otherwise. Linearised: open P = 0; closed w_n = 0; stick w_t = 0; slip P_t = mu P_n
 * m with m = (P_t - ρ w_t) / |P_t - ρ w_t|, whose turning is linearised too in space. The matrix has W + ε D,
 * D = diag(compliance), in place of W, so that redundant rows leave it regular; the equations themselves are
 * exact. Steps are shortened until the natural map falls; it converges near the solution only, so the caller
 * keeps sweeps at hand.
 *
 * Bodies held by contacts alone answer an imbalance of the impulses to start from with velocities far above
 * those of the problem, and the classification above is then chance. With @p trust_impulses the first step
 * takes it from the impulses: open where there is none, slipping where they lie on the cone.
 *
 * Other arguments and result as newton_active_set().
 */
template <unsigned int n>
double frictional_newton(const Eigen::SparseMatrix<double, Eigen::RowMajor> &W,
                         const Problem &problem,
                         const std::vector<double> &compliance,
                         const SolverSettings &settings,
                         bool trust_impulses,
                         std::vector<double> &impulses,
                         SolverReport &report);
} // namespace softgrain::contact

#endif
