// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_step_state_h
#define softgrain_mpm_body_step_state_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <vector>

namespace softgrain::mpm
{
/// What one step works on at the points of a body; sized once per grid, overwritten by every trial.
template <int dim>
struct StepState
{
  std::vector<dealii::Tensor<2, dim>>
      grid_gradient;                             ///< I + grad U, from the grid's configuration to the trial
  std::vector<dealii::Tensor<2, dim>> gradient;  ///< F of the trial
  std::vector<dealii::Tensor<2, dim>> increment; ///< displacement gradient over the step
  std::vector<double> volume;                    ///< that multiplies the stress: at rest, or (3.17) [m^dim]
  std::vector<dealii::SymmetricTensor<2, dim>> stress;  ///< [Pa]
  std::vector<dealii::SymmetricTensor<4, dim>> tangent; ///< [Pa]
  std::vector<double> energy, out_of_plane_stress;      ///< of measures only: per rest volume [J/m^dim], [Pa]
  std::vector<double> dissipation;                      ///< of laws with history, per rest volume [J/m^dim]
  std::vector<double> supply;               ///< of active laws: energy brought in, per rest volume [J/m^dim]
  std::vector<double> history_old, history; ///< rows of Law::n_history() values, start and end of the step
  Eigen::VectorXd nodal, nodal_increment;   ///< scratch, all nodes
  std::vector<double> of_cells;             ///< scratch, dim per node of every cell
};
} // namespace softgrain::mpm

#endif
