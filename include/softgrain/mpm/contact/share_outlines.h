// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_share_outlines_h
#define softgrain_mpm_contact_share_outlines_h

#include <softgrain/mpm/contact/contact_tasks.h>

namespace softgrain::mpm
{
/**
 * @brief Outlines of all bodies, each moved by its rank, and the tasks of this rank's bodies. There are
 * several ranks; all call it.
 *
 * Of a body of another rank the sketch is known, and where a body of this rank looks at it, the outline: a
 * rank does not know by which weights nodes of other ranks' bodies move their markers.
 */
MovedOutlines share_outlines(const BodyShare &share, const OutlineScene &scene);

/// Moves outlines where there is one rank, or where each has all that it needs.
MovedOutlines move_outlines(const OutlineScene &scene);
} // namespace softgrain::mpm

#endif
