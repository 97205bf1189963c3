// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_outline_loads_h
#define softgrain_analysis_outline_loads_h

#include <softgrain/analysis/snapshot.h>

#include <vector>

namespace softgrain
{
/// What contact does at a vertex of an outline.
struct OutlineLoad
{
  double length = 0.;   ///< half of both sides at the vertex [m]
  double pressure = 0.; ///< [Pa], negative where contact pulls
  double traction = 0.; ///< [Pa], positive where it pulls the body on counter-clockwise
};

/**
 * @brief Pressure and traction of contact at the vertices of the outlines of a body, ring by ring.
 *
 * It is that of contact_profile(), and sums of pressure times length are what contact presses, exactly. Both
 * bodies of a contact have it, each on its own outline. A ring that ends where it began has one entry less
 * than points.
 */
std::vector<std::vector<std::vector<OutlineLoad>>> loads_on_outlines(const Snapshot<2> &snapshot);
} // namespace softgrain

#endif
