// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_dynamics_report_h
#define softgrain_bpm_dynamics_report_h

#include <softgrain/bpm/overlap.h>
#include <softgrain/contact/disk_solver.h>
#include <softgrain/driving/named_sums.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace softgrain::bpm
{
/// What loads did in a step.
struct LoadReport
{
  double work = 0;              ///< [J/m]
  std::vector<double> of_loads; ///< of it, by all loads but the last [J/m]
  dealii::Tensor<1, 2> impulse; ///< [N s/m]
};

/// What one step did.
struct DynamicsReport
{
  contact::DiskSolverReport solver;
  dealii::Tensor<1, 2> wall_impulse; ///< from walls on primaries [N s/m]
  double contact_loss = 0;           ///< kinetic energy that contacts took beside adhesion [J/m]
  double adhesion_work = 0;          ///< done by adhesion [J/m]
  double wall_work = 0;   ///< done by walls of prescribed velocity, by loads of others, obstacles, cell [J/m]
  double cell_work = 0;   ///< of it, by a cell that deforms beside its sides: see CellMotion [J/m]
  double driven_work = 0; ///< done by what keeps driven bodies on their way [J/m]
  dealii::Tensor<1, 2> driven_impulse; ///< from driven bodies on others [N s/m]
  double damping_loss = 0;             ///< in the damping of walls [J/m]
  NamedSums losses;                    ///< beside these, see Balance::losses [J/m]
  NamedSums sums;                      ///< what the step adds to columns of the history, see Balance::sums
  LoadReport loads;
  double max_penetration = 0;        ///< after the step, and on the way to there [m]
  Overlap on_the_way;                ///< the deepest one between the ends of the step
  dealii::Tensor<1, 2> cell_impulse; ///< on the primaries, of a cell that deforms: see CellMotion [N s/m]
};
} // namespace softgrain::bpm

#endif
