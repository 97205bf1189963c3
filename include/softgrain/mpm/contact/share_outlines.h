// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_share_outlines_h
#define softgrain_mpm_contact_share_outlines_h

#include <softgrain/mpm/contact/contact_tasks.h>

namespace softgrain::mpm
{
/**
 * @brief Outlines of all bodies, each moved by its owner, and the tasks of owned bodies. There are several
 * owners; all call it.
 *
 * Of a body of another owner the sketch is known, and where an owned body looks at it, the outline: nobody
 * else knows by which weights nodes of a body move its markers.
 */
MovedOutlines share_outlines(const BodyShare &share, const OutlineScene &scene);

/// Moves outlines where there is one owner, or where each has all that it needs.
MovedOutlines move_outlines(const OutlineScene &scene);
} // namespace softgrain::mpm

#endif
