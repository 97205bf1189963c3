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
/**
 * @brief Hᵀ of one body: what a unit impulse in each of its contact components does to its nodes.
 *
 * A row whose place slides along the outline pushes at the nodes near its place, and at the body as a whole:
 * the second part is a direction times the masses of all nodes, so it is kept as that direction, and Hᵀ stays
 * sparse.
 */
template <int dim>
class BodyRows
{
public:
  /// @param of_body components that @p body takes part in: row * @p n_components + component
  void reinit(const Body<dim> &body,
              const std::vector<ContactRow<dim>> &rows,
              const std::vector<unsigned int> &of_body,
              unsigned int n_components);

  unsigned int n_dofs() const { return local.rows(); }
  /// H v.
  Eigen::VectorXd velocities(const Eigen::VectorXd &nodal) const;
  /// Adds Hᵀ P to @p nodal.
  void add_impulses(const Eigen::VectorXd &P, Eigen::VectorXd &nodal) const;
  /// W = H A⁻¹ Hᵀ with the matrix that @p solver has factorised.
  void condense(RankOneSolver &solver, Eigen::MatrixXd &W) const;
  /// Hᵀ with all its entries.
  LinearSolver::Rows full() const;

private:
  LinearSolver::Rows local; ///< Hᵀ near the places; two columns more when any row pushes at the whole body
  unsigned int n_rows = 0;
  Eigen::VectorXd mass_share; ///< of every node; empty when no row pushes at the whole body
  Eigen::Matrix<double, dim, Eigen::Dynamic> whole; ///< one column per row
};
} // namespace softgrain::mpm

#endif
