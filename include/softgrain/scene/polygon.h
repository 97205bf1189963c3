// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_polygon_h
#define softgrain_scene_polygon_h

#include <softgrain/scene/scene.h>

#include <deal.II/base/point.h>

#include <utility>
#include <vector>

namespace softgrain
{
/// A closed polyline; the edge from the last vertex to the first is implied.
using Polygon = std::vector<dealii::Point<2>>;

/// Signed area, positive when counter-clockwise [m^2].
double signed_area(const Polygon &polygon);

/// Signed area and centroid; the centroid of an area below rounding is the mean of the vertices.
std::pair<double, dealii::Point<2>> area_and_centroid(const Polygon &polygon);

/// The part of @p polygon inside the box [@p lower, @p upper] (Sutherland and Hodgman 1974).
Polygon clip_to_box(const Polygon &polygon, const dealii::Point<2> &lower, const dealii::Point<2> &upper);

/**
 * @brief Boundary of a body at rest as closed polylines with edges of at most @p spacing [m].
 *
 * The outer boundary comes first, counter-clockwise; a hole follows, clockwise, so that the solid lies to the
 * left of every edge. Vertices of disks lie on the circle; corners are always vertices.
 */
std::vector<Polygon> make_outline(const BodyDescription<2> &body, double spacing);
} // namespace softgrain

#endif
