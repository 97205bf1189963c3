// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_share_rows_h
#define softgrain_mpm_contact_share_rows_h

#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/contact/contact_rows.h>

#include <vector>

namespace softgrain::mpm
{
/// Makes of the rows that every rank has found for its own bodies those of all bodies, on all ranks: in the
/// order of the bodies that look, as one rank finds them. Rows of bodies of other ranks are dropped first.
void share_rows(const BodyShare &share, std::size_t n_bodies, std::vector<ContactRow<2>> &rows);

/// The same of several ranks where only the gaps matter.
GapsByRow
share_gaps_where_found(const BodyShare &share, std::size_t n_bodies, const std::vector<ContactRow<2>> &rows);
} // namespace softgrain::mpm

#endif
