// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_denser_rays_h
#define softgrain_mpm_contact_denser_rays_h

#include <softgrain/mpm/contact/contact_frame.h>
#include <softgrain/mpm/contact/overlap_judge.h>

#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Halves the spacing of rays where outlines lie in each other between them.
 *
 * Contact is a condition on whole surfaces, and rays ask for it at some places. Where a step ends with
 * surfaces in each other between these, the places it has missed are added, as exchange methods for
 * semi-infinite problems do (@cite hettich1993). A frame keeps its rays, and what they carry; new ones stand
 * between them from the next step on. A spacing is halved twice at most.
 * @param verdict   what is wrong with a step: the pairs that lie deepest in each other, all whose frames
 * change, so that a scene stays its own mirror image
 * @param n_walls   number from which on frames count obstacles
 * @param cell_size [m]
 * @param frames    those with which the next step begins
 */
void lay_denser_rays(const Verdict &verdict,
                     unsigned int n_walls,
                     double cell_size,
                     std::vector<ContactFrame<2>> &frames);
} // namespace softgrain::mpm

#endif
