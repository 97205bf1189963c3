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
/// What is told of rows, beside what all of them have; what is not stays as it is in a row by itself.
struct RowParts
{
  bool weights = false; ///< of nodes, on all ranks; else the rank of a partner finds those of its own body
  bool subgrid = false; ///< what the grid misses
  bool adhesion = false;
  bool obstacles = false;
  bool cell = false; ///< where something repeats
};

/// Makes of the rows that @p find puts into @p rows, on every rank for its own bodies, those of all bodies,
/// on all ranks: in the order of the bodies that look, as one rank finds them. There are several ranks. Where
/// the gap was found is known of own rows.
void share_rows(const BodyShare &share,
                const std::vector<Body<2>> &bodies,
                const std::function<void()> &find,
                const RowParts &told,
                std::vector<ContactRow<2>> &rows);

/// Shares rows where only their gaps matter.
GapsByRow share_gaps_where_found(const BodyShare &share,
                                 std::size_t n_bodies,
                                 const std::function<void()> &find,
                                 const std::vector<ContactRow<2>> &rows);
} // namespace softgrain::mpm

#endif
