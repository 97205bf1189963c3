// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_row_ends_h
#define softgrain_mpm_contact_row_ends_h

#include <softgrain/mpm/contact/seekers.h>

#include <functional>

namespace softgrain::mpm
{
/// Share of the boundary around a seeker that faces what has @p normal: at a corner one side looks elsewhere
/// and does not adhere.
double facing_share(const MovedBoundary &own, const Seeker &seeker, const dealii::Tensor<1, 2> &normal);

/**
 * Gives a row that adheres how much further apart the surfaces are at its two ends, half-way to the
 * neighbours of its seeker; so it pulls with the part of its length that is within range. A side of a corner
 * that looks elsewhere counts as the other one.
 * @param gap_at of a place of the outline, where in the step the row was found [m]
 */
void add_lift(const MovedBoundary &own,
              const Seeker &seeker,
              const std::function<double(const MovedBoundary::Place &)> &gap_at,
              ContactRow<2> &row);
} // namespace softgrain::mpm

#endif
