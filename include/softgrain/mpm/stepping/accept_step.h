// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_accept_step_h
#define softgrain_mpm_stepping_accept_step_h

#include <softgrain/mpm/contact/contact_kinks.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/step.h>

#include <vector>

namespace softgrain::mpm
{
/// A step that has been found: nodal vectors of every body, and how walls moved.
struct FoundStep
{
  const StepPlan &plan;
  const std::vector<WallMotion<2>> &motion;
  std::vector<Eigen::VectorXd> &velocity;        ///< at the end; exchanged for those at the start [m/s]
  std::vector<Eigen::VectorXd> &internal_force;  ///< at the end; likewise [N]
  const std::vector<Eigen::VectorXd> &increment; ///< displacement over the step [m]
  const std::vector<Eigen::VectorXd> &rate;      ///< mean velocity, with which impulses do their work [m/s]
  const std::vector<Eigen::VectorXd> &external;  ///< loads, empty where there are none [N]
  LoadTimes loads = {};                          ///< when they were taken
  NamedSums losses = {};                         ///< of the step, see Balance::losses
  NamedSums sums = {};                           ///< what it adds to columns, see Balance::sums
  std::vector<dealii::Tensor<1, 2>> resistance = {}; ///< as State::resistance
  ContactKinks kinks = {};                           ///< without inertia
  double dents = 0;                                  ///< energy in what the grid misses of them [J/m]
  double adhesion_work = 0;                          ///< likewise without inertia [J/m]
  /// It leads from balance to balance: forces change steadily, and their work is that of the mean of both
  /// ends.
  bool balanced = false;
};

/**
 * @brief Writes a step into the state: nodes, points, boundaries, walls, balances, contacts. Nothing else
 * commits a step, so a state is that at the end of a step or that at its start.
 */
void accept_step(const Problem &problem, State &state, Workspace &work, FoundStep &step);
} // namespace softgrain::mpm

#endif
