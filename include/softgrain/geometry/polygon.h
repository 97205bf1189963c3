// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_polygon_h
#define softgrain_geometry_polygon_h

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

/// Three or more vertices in each quarter of a circle, with edges of at most about @p spacing [m].
Polygon circle(const dealii::Point<2> &center, double radius, double spacing, bool clockwise);

/// The same polygon with edges of at most @p spacing [m]; its corners stay vertices.
Polygon subdivide(const Polygon &corners, double spacing);

/// Whether @p p lies in the polygon, whichever way round it runs.
bool is_inside(const dealii::Point<2> &p, const Polygon &polygon);

/// Distance to the nearest edge, from either side [m].
double distance_to_boundary(const dealii::Point<2> &p, const Polygon &polygon);

/// Whether two edges that are not neighbours meet.
bool crosses_itself(const Polygon &polygon);

/// Whether the polygons share more than a seam of width @p tolerance [m].
bool polygons_overlap(const Polygon &a, const Polygon &b, double tolerance);
} // namespace softgrain

#endif
