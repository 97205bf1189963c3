// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_frictionless_newton_h
#define softgrain_contact_frictionless_newton_h

#include <softgrain/contact/gauss_seidel.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace softgrain::contact
{
/**
 * @brief The convex programme of frictionless contact, min φ(P) = ½ PᵀWP + qᵀP with P >= 0, W only
 * semi-definite.
 *
 * Outer iteration: proximal point, P⁺ = argmin φ(P) + ½ ε (P - P_k)ᵀ D (P - P_k), D = diag(W), which is
 * strictly convex and has the solutions of the programme as its fixed points. Inner: block principal pivoting
 * (Júdice and Pires 1994; safeguard of Kim and Park 2011). When pivoting does not end or the outer iteration
 * stalls: sweeps, and Newton steps on the face of the closed contacts with backtracking on φ, which never
 * increase φ.
 */
class FrictionlessNewton
{
public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// The arguments must outlive the object; they are those of newton_active_set().
  FrictionlessNewton(const Matrix &W,
                     const Problem &problem,
                     const std::vector<double> &compliance,
                     const SolverSettings &settings);

  /// Improves @p impulses and returns their residual; counts its work in @p report.
  double solve(std::vector<double> &impulses, SolverReport &report) const;

private:
  /// One proximal step from @p P by pivoting; false when it did not end or the system was singular.
  bool pivot(double epsilon, Eigen::VectorXd &P, SolverReport &report) const;

  /// Sweeps and one Newton step on the face; never increases φ.
  void descend(double epsilon, Eigen::VectorXd &P, SolverReport &report) const;

  /// Solves (W + ε D) x = b on the rows in @p active.
  bool solve_active(const std::vector<unsigned int> &active,
                    double epsilon,
                    const Eigen::VectorXd &right_hand_side,
                    Eigen::VectorXd &solution) const;

  double residual(const Eigen::VectorXd &P) const;

  const Matrix &W;
  const Problem &problem;
  const std::vector<double> &compliance;
  const SolverSettings &settings;
  Eigen::VectorXd q;
  Eigen::VectorXd diagonal;
  double speed;
};
} // namespace softgrain::contact

#endif
