// SPDX-License-Identifier: LGPL-2.1-or-later
// Areas, extents and overlaps of bodies, with exact contact, holes, and polygons laid on each other.
#include <softgrain/geometry/shapes_2d.h>

#include <iostream>

int main()
{
  using namespace softgrain;
  using dealii::Point;
  const auto disk = [](const double x, const double y, const double radius, const double inner = 0)
  { return Disk2D(Point<2>(x, y), radius, inner); };
  const auto rectangle =
      [](const double x, const double y, const double w, const double h, const double angle = 0)
  { return Rectangle2D(Point<2>(x, y), Point<2>(w, h), angle); };
  const auto polygon = [](const std::vector<Point<2>> &vertices) { return Polygon2D(vertices); };
  const double tolerance = 1e-9;
  const auto clockwise = polygon({{0, 0}, {0, 1}, {1, 1}, {1, 0}});
  const auto corner = polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});

  std::cout << disk(0, 0, 2, 1).area() << ' ' << rectangle(1, 1, 2, 3, 0.3).area() << ' ' << clockwise.area()
            << ' ' << corner.area() << '\n';
  const auto box = rectangle(1, 1, 2, 2, std::acos(-1.) / 4).bounding_box();
  std::cout << box.first << ' ' << box.second << '\n';

  std::cout << "disks " << overlap(disk(0, 0, 1), disk(2, 0, 1), tolerance)
            << overlap(disk(0, 0, 1), disk(1.9999, 0, 1), tolerance)
            << overlap(disk(0, 0, 1), disk(0, 0, 1), tolerance)
            << overlap(disk(0, 0, 3, 1), disk(0, 0, 1), tolerance)
            << overlap(disk(0, 0, 1), disk(0.1, 0, 3, 1), tolerance) << '\n';
  std::cout << "disk and rectangle " << overlap(disk(0, 0, 1), rectangle(2, 0, 2, 2), tolerance)
            << overlap(rectangle(1.99, 0, 2, 2), disk(0, 0, 1), tolerance)
            << overlap(disk(0, 0, 1), rectangle(0, 0, 9, 9), tolerance)
            << overlap(disk(0, 0, 9), rectangle(0, 0, 1, 1), tolerance)
            << overlap(disk(0, 0, 9, 1), rectangle(0, 0, 1, 1), tolerance)
            << overlap(disk(1.8, 1.8, 1), rectangle(0, 0, 2, 2), tolerance) << '\n';
  std::cout << "polygons " << overlap(clockwise, rectangle(1.5, 0.5, 1, 1), tolerance)
            << overlap(clockwise, clockwise, tolerance)
            << overlap(corner, rectangle(1.5, 1.5, 1, 1), tolerance)
            << overlap(corner, rectangle(1.5, 1.5, 1, 1.01), tolerance)
            << overlap(corner, rectangle(1, 1, 9, 0.1), tolerance)
            << overlap(corner, rectangle(0.5, 0.5, 0.1, 0.1), tolerance) << '\n';
  std::cout << "crosses itself " << crosses_itself(corner.vertices)
            << crosses_itself({{0, 0}, {1, 1}, {1, 0}, {0, 1}}) << '\n';
}
