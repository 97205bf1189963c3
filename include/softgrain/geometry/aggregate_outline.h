// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_aggregate_outline_h
#define softgrain_geometry_aggregate_outline_h

#include <deal.II/base/point.h>

#include <vector>

namespace softgrain
{
/**
 * @brief Outline of an aggregate of disks: what a probe disk that rolls around it from outside cannot reach.
 *
 * Where the probe touches one disk the outline is that disk's edge, where it rests on two it is the probe's.
 * This is the alpha shape of the disks, with 1/alpha the radius of the probe @cite edelsbrunner1983, dressed
 * with their edges; in chemistry, the solvent-excluded surface. Arcs become polylines that enclose the area
 * of the arcs exactly, with steps of at most 22.5 degrees, so that vertices lie up to 2.7 % of a radius off
 * the edge.
 *
 * Polylines do not cross each other or themselves; the edge from the last vertex to the first is implied.
 * Outer outlines are counter-clockwise, one for every fragment, the largest first; fragments between which
 * the probe cannot pass are one. With @p holes, each is followed by the outlines, clockwise, of the voids
 * inside that have room for the probe; otherwise voids inside count as part of the aggregate.
 *
 * @param centers,radii of the disks, in any order [m]; radii within a factor of three of each other
 * @param probe_radius positive; about the radius of a primary, so that the voids of a packing stay closed [m]
 * @param holes whether voids inside are outlined
 * @throw ComputationError when a number is not finite
 */
std::vector<std::vector<dealii::Point<2>>> aggregate_outline(const std::vector<dealii::Point<2>> &centers,
                                                             const std::vector<double> &radii,
                                                             double probe_radius,
                                                             bool holes = false);
} // namespace softgrain

#endif
