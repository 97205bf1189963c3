// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_body_geometry_h
#define softgrain_scene_body_geometry_h

#include <softgrain/geometry/polygon.h>
#include <softgrain/scene/scene.h>

#include <utility>
#include <vector>

namespace softgrain
{
/// Corners of a rectangle or polygon, counter-clockwise; none for a disk.
std::vector<dealii::Point<2>> corners(const BodyDescription<2> &body);

/**
 * @brief Boundary of a body at rest as closed polylines with edges of at most @p spacing [m].
 *
 * The outer boundary comes first, counter-clockwise; a hole follows, clockwise, so that the solid lies to the
 * left of every edge. Vertices of disks lie on the circle; corners are always vertices.
 */
std::vector<Polygon> make_outline(const BodyDescription<2> &body, double spacing);

/// Area of the body at the start, without its hole [m^2].
double area(const BodyDescription<2> &body);

/// Lower left and upper right corner of the box around the body.
std::pair<dealii::Point<2>, dealii::Point<2>> bounding_box(const BodyDescription<2> &body);

/// Least and greatest signed distance of the body's points from a plane, along its unit normal [m].
std::pair<double, double> distances_from_plane(const BodyDescription<2> &body,
                                               const dealii::Point<2> &point,
                                               const dealii::Tensor<1, 2> &normal);

/// Whether the bodies share more than a seam of width @p tolerance [m]; a body in the hole of a ring does
/// not.
bool overlap(const BodyDescription<2> &a, const BodyDescription<2> &b, double tolerance);

/// Distance of @p p to the boundary of @p body at rest, positive inside [m].
double depth_inside(const BodyDescription<2> &body, const dealii::Point<2> &p);
} // namespace softgrain

#endif
