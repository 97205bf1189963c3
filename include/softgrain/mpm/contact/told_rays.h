// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_told_rays_h
#define softgrain_mpm_contact_told_rays_h

#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/contact/frame_state.h>

#include <Eigen/Core>

#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Lets rays of frames meet surfaces after the bodies have moved by @p way in the step: every owner
 * looks at its bodies, and learns from the others what they have found at theirs.
 *
 * @param force        of all rays [N/m^(3-dim)]
 * @param displacement of all bodies where rays meet them, since the grid was laid [m]
 * @param way          of all bodies over the step [m]
 * @param path, within see FrameState::prepare() [m]
 */
template <int dim>
void meet_frames(const BodyShare &share,
                 const FrameScene<dim> &scene,
                 const std::vector<std::vector<double>> &force,
                 const std::vector<Eigen::VectorXd> &displacement,
                 const std::vector<Eigen::VectorXd> &way,
                 double path,
                 double within,
                 std::vector<FrameState<dim>> &frames);
} // namespace softgrain::mpm

#endif
