// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_nodal_resistance_h
#define softgrain_mpm_stepping_nodal_resistance_h

#include <softgrain/linear/system_matrix.h>

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

namespace softgrain::mpm
{
/**
 * @brief What resists the motion of the nodes of a body in a step without inertia.
 *
 * A calm step resists by the mass of nodes, as inertia does: what is stretched evenly stays so nearly. What a
 * step resists beyond that resists all nodes alike. Nodes at a rim or a corner that hold little matter would
 * hardly notice it otherwise, however much it is, and contact moves them as strongly as others. Masses count
 * as positive also where functions and extensions make them negative.
 */
template <int dim>
class NodalResistance
{
public:
  NodalResistance() = default;
  /**
   * @param mass of the nodes [kg m^(dim-3)]
   * @param share StepPlan::regularisation, or what it has risen to
   * @param whole what resists a motion of the body as a whole with a share of one [N s^2/m m^(dim-3)]
   */
  NodalResistance(const Eigen::VectorXd &mass, double share, double whole);

  /// Takes from the impulse that is missing what resists the velocities @p v.
  void subtract(const Eigen::VectorXd &v, Eigen::VectorXd &missing) const;
  void add_to(SystemMatrix &matrix) const { matrix.add_mass<dim>(of_node, 1.); }
  /// Becomes @p factor times as large: also in the impulse that is missing for @p v, and in the matrix, if
  /// one is given.
  void rise(double factor, const Eigen::VectorXd &v, Eigen::VectorXd &missing, SystemMatrix *matrix);

  /// Sum of the amounts of what resists the motion @p u of each node.
  double amounts(const Eigen::VectorXd &u) const;
  /// Sum of these as vectors: what resists the body as a whole.
  dealii::Tensor<1, dim> sum(const Eigen::VectorXd &u) const;
  /// Sum of what resists each node times its way: twice the work of a resistance that grows along @p u.
  double times_way(const Eigen::VectorXd &u) const;

private:
  Eigen::VectorXd at(double share) const;

  Eigen::VectorXd by_mass; ///< with a share of one
  double alike = 0.;       ///< the same of every node
  double share = 0.;
  Eigen::VectorXd of_node; ///< with the share that it has
};
} // namespace softgrain::mpm

#endif
