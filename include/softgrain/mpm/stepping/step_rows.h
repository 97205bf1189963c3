// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_step_rows_h
#define softgrain_mpm_stepping_step_rows_h

#include <softgrain/mpm/contact/overlap_judge.h>
#include <softgrain/mpm/stepping/step.h>

#include <vector>

namespace softgrain::mpm
{
/// Finds the contact rows of a step.
/// @param increment displacement of the nodes over the step as far as it is known, null: by their
/// velocities
/// @param share     where in the step places and normals are taken
/// @param again     whether rows of this step are replaced; they hand their impulses on
/// @param start_gaps true_gaps().here at the start, null: gaps are drawn back from where rows are taken
void find_rows(const Problem &problem,
               const State &state,
               Workspace &work,
               const std::vector<WallMotion<2>> &motion,
               double dt,
               const std::vector<Eigen::VectorXd> *increment,
               double share,
               bool again,
               const GapsByRow *start_gaps = nullptr);

/// What true_gaps() finds.
struct FoundGaps
{
  GapsByRow here;     ///< of the rows that this rank finds, those of its bodies
  double deepest = 0; ///< overlap of any row of all ranks [m]
};

/// Gaps of rows at the start of a step with displacements @p increment (@p share = 0), or at its end (1).
FoundGaps true_gaps(const Problem &problem,
                    const State &state,
                    const Workspace &work,
                    const std::vector<WallMotion<2>> &motion,
                    double dt,
                    const std::vector<Eigen::VectorXd> &increment,
                    double share);

/// True gaps of the rows of all ranks, on all of them.
GapsByRow true_gaps_of_all(const Problem &problem,
                           const State &state,
                           const Workspace &work,
                           const std::vector<WallMotion<2>> &motion,
                           double dt,
                           const std::vector<Eigen::VectorXd> &increment,
                           double share);

/// What outlines say of a step with displacements @p increment: of the bodies of all ranks, on all of them.
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
