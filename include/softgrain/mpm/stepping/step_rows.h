// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_step_rows_h
#define softgrain_mpm_stepping_step_rows_h

#include <softgrain/mpm/contact/overlap_judge.h>
#include <softgrain/mpm/stepping/step.h>

#include <vector>

namespace softgrain::mpm
{
/// Finds the contact rows of a step, where bodies are at its start.
void find_rows(const Problem &problem,
               const State &state,
               Workspace &work,
               const std::vector<WallMotion<2>> &motion,
               double dt);

/// What outlines say of a step with displacements @p increment: of all bodies, whoever owns them.
/// @param share 1: where bodies end, 0: where they begin
Verdict judge(const Problem &problem,
              const State &state,
              const Workspace &work,
              const std::vector<WallMotion<2>> &motion,
              double dt,
              const std::vector<Eigen::VectorXd> &increment,
              double share);

/// Gap of every row at the end of the step, to first order in the increments [m].
std::vector<double> end_gaps(const State &state,
                             const Workspace &work,
                             const std::vector<Eigen::VectorXd> &increment,
                             const std::vector<WallMotion<2>> &motion,
                             double dt);
} // namespace softgrain::mpm

#endif
