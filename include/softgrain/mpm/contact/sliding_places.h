// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_sliding_places_h
#define softgrain_mpm_contact_sliding_places_h

#include <softgrain/mpm/contact/moved_boundary.h>

#include <memory>

namespace softgrain::mpm
{
/// The slide of the places of a body that look along @p direction from its centre; null where its outline @p
/// own is folded. @param partner what is at the end of it, round like this one, or null for a wall
std::shared_ptr<const PlaceSlide<2>> slide_of_places(const MovedBoundary &own,
                                                     const MovedBoundary::Vector &direction,
                                                     const MovedBoundary *partner);

/// Gives a row without friction the slope of its gap, and takes what that has done so far off the gap at the
/// start of the step. @param at where the row touches, on the outline of its body @param slide may be null
void add_slope(const ContactScene<2> &scene,
               const MovedBoundary::Place &at,
               const std::shared_ptr<const PlaceSlide<2>> &slide,
               ContactRow<2> &row);
} // namespace softgrain::mpm

#endif
