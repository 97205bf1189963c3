// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_workspace_h
#define softgrain_mpm_model_workspace_h

#include <softgrain/geometry/outline_surface.h>
#include <softgrain/linear/rank_one_solver.h>
#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/body/step_state.h>
#include <softgrain/mpm/contact/contact_system.h>

#include <deal.II/base/tensor.h>
#include <deal.II/base/timer.h>

#include <memory>
#include <vector>

namespace softgrain::mpm
{
/// What steps work with and every step fills anew: nothing of it is part of a result.
struct Workspace
{
  BodyShare share;                                     ///< who works on which body
  std::vector<StepState<2>> trial;                     ///< one per body; filled by its owner
  std::vector<dealii::Tensor<1, 2>> drive;             ///< of driven bodies in the step, one per body [m/s]
  std::vector<SystemMatrix> matrices;                  ///< one per owned body, implicit schemes
  std::vector<std::unique_ptr<RankOneSolver>> solvers; ///< likewise
  ContactSystem<2> contact;                            ///< rows found, and the problem that they pose
  std::vector<OutlineSurface> outlines;                ///< of the bodies, for rays
  std::vector<dealii::Tensor<1, 2>> load;              ///< on every body, as the last step had it [N/m]
  dealii::TimerOutput *timer = nullptr;
};
} // namespace softgrain::mpm

#endif
