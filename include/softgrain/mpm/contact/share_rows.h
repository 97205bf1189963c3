// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_share_rows_h
#define softgrain_mpm_contact_share_rows_h

#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/contact/contact_rows.h>
#include <softgrain/mpm/contact/moved_boundary.h>

#include <functional>
#include <vector>

namespace softgrain::mpm
{
/// Boundaries of all bodies, each moved by its rank; of those of other ranks, sketches. There are several
/// ranks.
std::vector<MovedBoundary> share_boundaries(const BodyShare &share, const ContactScene<2> &scene);

/// Makes of the rows that @p find puts into @p rows, on every rank for its own bodies, those of all bodies,
/// on all ranks: in the order of the bodies that look, as one rank finds them. There are several ranks.
/// @param weights_everywhere all ranks have the weights of nodes in a row, else those of the two bodies
void share_rows(const BodyShare &share,
                std::size_t n_bodies,
                const std::function<void()> &find,
                bool weights_everywhere,
                std::vector<ContactRow<2>> &rows);

/// The same where only the gaps matter.
GapsByRow share_gaps_where_found(const BodyShare &share,
                                 std::size_t n_bodies,
                                 const std::function<void()> &find,
                                 const std::vector<ContactRow<2>> &rows);
} // namespace softgrain::mpm

#endif
