// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_body_rows_h
#define softgrain_mpm_contact_body_rows_h

#include <softgrain/linear/rank_one_solver.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/contact/contact_rows.h>

#include <Eigen/Core>

#include <vector>

namespace softgrain::mpm
{
/// Hᵀ of one body: what a unit impulse in each of its contact components does to its nodes.
template <int dim>
class BodyRows
{
public:
  /// @param of_body components that @p body takes part in: row * @p n_components + component
  void reinit(const Body<dim> &body,
              const std::vector<ContactRow<dim>> &rows,
              const std::vector<unsigned int> &of_body,
              unsigned int n_components);

  unsigned int n_dofs() const { return matrix.rows(); }
  /// H v.
  Eigen::VectorXd velocities(const Eigen::VectorXd &nodal) const { return matrix.transpose() * nodal; }
  /// Adds Hᵀ P to @p nodal.
  void add_impulses(const Eigen::VectorXd &P, Eigen::VectorXd &nodal) const { nodal += matrix * P; }
  /// W = H A⁻¹ Hᵀ with the matrix that @p solver has factorised.
  void condense(RankOneSolver &solver, Eigen::MatrixXd &W) const { solver.condense(matrix, W); }
  const LinearSolver::Rows &transposed() const { return matrix; }

private:
  LinearSolver::Rows matrix; ///< Hᵀ
};
} // namespace softgrain::mpm

#endif
