// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_judge_step_h
#define softgrain_mpm_stepping_judge_step_h

#include <softgrain/mpm/contact/overlap_judge.h>
#include <softgrain/mpm/stepping/step.h>

#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Judges a step that has been found, before it is accepted, by outlines alone.
 *
 * No body may end deeper in another, in a wall or in an obstacle than `Contact/Largest penetration` and than
 * it was. Where two move against each other by more than a quarter of the width of the narrower one, places
 * on the way are looked at, too, so that nothing passes between two states that are judged. Contact rows are
 * not asked.
 * @param increment displacements of the nodes over the step [m]
 * @param outcome   is told the true depth, and with which share of the step to try again
 * @param told      becomes what was found, if it is given
 * @return why the step may not be accepted: names, place and depth; empty when it may
 */
std::string judge_step(const Problem &problem,
                       const State &state,
                       const Workspace &work,
                       const std::vector<WallMotion<2>> &motion,
                       double dt,
                       const std::vector<Eigen::VectorXd> &increment,
                       StepOutcome &outcome,
                       Verdict *told = nullptr);
} // namespace softgrain::mpm

#endif
