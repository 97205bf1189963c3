// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_folded_surface_h
#define softgrain_mpm_contact_folded_surface_h

#include <softgrain/mpm/contact/near_stretches.h>

#include <vector>

namespace softgrain::mpm
{
/// Whether a loop of an outline may meet itself, see may_meet_itself(). It says nothing of how near its parts
/// are to each other.
bool is_folded(const SampledSurface<2> &surface);

/**
 * @brief Stretches in which an outline is near itself, across what is not its material.
 *
 * Two places of one loop face each other as those of two bodies do. They must be further from each other
 * along the loop than in a straight line, and each must lie on the outer side of the other: what is on both
 * sides of a thin strip does not meet. A pair is listed once, with the place that comes first along the
 * outline first.
 */
std::vector<NearStretch<2>> stretches_of_fold(const SampledSurface<2> &surface, double reach);
} // namespace softgrain::mpm

#endif
