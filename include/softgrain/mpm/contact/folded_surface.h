// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_folded_surface_h
#define softgrain_mpm_contact_folded_surface_h

#include <softgrain/mpm/contact/near_stretches.h>

#include <vector>

namespace softgrain::mpm
{
/// Whether an outline may meet itself: somewhere along it the normal turns backwards by so much that two
/// places face each other, as in a crease, a hook or a hole, or it turns forwards by more than once around,
/// as where two parts have come through each other. It says nothing of how near they are.
bool is_folded(const SampledSurface<2> &surface);

/**
 * @brief Stretches in which an outline is near itself, across what is not its material.
 *
 * Two places of one loop face each other as those of two bodies do. They must be further from each other
 * along the loop than across, and each of them must lie before the other, not behind it through the material.
 * Of both ways to name a pair the one is taken whose first place comes first along the outline.
 */
std::vector<NearStretch<2>> stretches_of_fold(const SampledSurface<2> &surface, double reach);
} // namespace softgrain::mpm

#endif
