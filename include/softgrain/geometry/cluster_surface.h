// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_cluster_surface_h
#define softgrain_geometry_cluster_surface_h

#include <softgrain/geometry/solid.h>

#include <vector>

namespace softgrain
{
/**
 * @brief Surface of a cluster of balls, as it is seen from @p center.
 *
 * A ray from there ends where it leaves the last ball that has grown by @p reach, less @p reach: what lies
 * between neighbouring balls is closed as by a ball of about that radius that rolls over them. The vertices
 * lie on rays in fixed directions, those of a geodesic sphere. A cluster whose outside bends back behind
 * itself is filled there, which aggregate_outline() in the plane does not do.
 *
 * @param center a place in the middle [m] @param centers,radii of the balls [m] @param reach [m]
 * @param directions a geodesic sphere about the origin, see cluster_directions()
 */
TriangulatedSurface cluster_surface(const dealii::Point<3> &center,
                                    const std::vector<dealii::Point<3>> &centers,
                                    const std::vector<double> &radii,
                                    double reach,
                                    const TriangulatedSurface &directions);

/// Directions for cluster_surface(), some @p per_ball for every ball at the surface of @p n_balls.
TriangulatedSurface cluster_directions(double n_balls, double per_ball);

/// Volume within a closed surface [m^3].
double enclosed_volume(const TriangulatedSurface &surface);
} // namespace softgrain

#endif
