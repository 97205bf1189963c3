// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_told_rays_h
#define softgrain_mpm_contact_told_rays_h

#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/contact/frame_state.h>

#include <functional>
#include <vector>

namespace softgrain::mpm
{
/// Looks along the rays of frames that are prepared for it: every rank does so at its bodies, and learns from
/// the others what they have found at theirs. @param look calls FrameState::look() of a frame
template <int dim>
void look_and_tell(const BodyShare &share,
                   std::vector<FrameState<dim>> &frames,
                   const std::function<void(unsigned int f)> &look);
} // namespace softgrain::mpm

#endif
