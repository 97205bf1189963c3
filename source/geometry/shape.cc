// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/shape.h>
#include <softgrain/geometry/shape_pairs.h>
#include <softgrain/geometry/shapes_2d.h>

#include <algorithm>
#include <limits>
#include <ostream>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::Shape<2>)

namespace softgrain
{
namespace
{
/// Edges that a fine outline has, about.
constexpr double fine = 1000.;

/// An outline that stands for a shape that has no better description.
std::vector<Polygon> fine_outline(const Shape<2> &shape)
{
  // Any first outline says how large the shape is.
  const std::vector<Polygon> coarse = shape.outline(std::numeric_limits<double>::max());
  double length = 0.;
  for (std::size_t i = 0; i < coarse[0].size(); ++i)
    length += coarse[0][i].distance(coarse[0][(i + 1) % coarse[0].size()]);
  return shape.outline(length / fine);
}

bool disks_overlap(const Disk2D &a, const Disk2D &b, const double tolerance)
{
  const double distance = a.center.distance(b.center);
  return distance < a.radius + b.radius - tolerance && distance + b.radius > a.inner_radius + tolerance &&
         distance + a.radius > b.inner_radius + tolerance;
}

bool disk_overlaps_polygon(const Disk2D &disk, const Polygon &polygon, const double tolerance)
{
  const bool near = distance_to_boundary(disk.center, polygon) < disk.radius - tolerance;
  if (!near && !is_inside(disk.center, polygon))
    return false;
  return std::any_of(polygon.begin(), polygon.end(),
                     [&](const dealii::Point<2> &p)
                     { return p.distance(disk.center) > disk.inner_radius + tolerance; });
}
} // namespace

double Shape<2>::area() const
{
  double sum = 0.;
  for (const Polygon &loop : fine_outline(*this))
    sum += signed_area(loop);
  return sum;
}

std::pair<double, double> Shape<2>::distances_from_plane(const Place &point,
                                                         const dealii::Tensor<1, 2> &normal) const
{
  std::pair<double, double> range(std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest());
  for (const Place &corner : corners())
  {
    const double distance = (corner - point) * normal;
    range = {std::min(range.first, distance), std::max(range.second, distance)};
  }
  return range;
}

double Shape<2>::depth(const Place &p) const
{
  double distance = std::numeric_limits<double>::max();
  bool inside = false;
  for (const Polygon &loop : fine_outline(*this))
  {
    distance = std::min(distance, distance_to_boundary(p, loop));
    inside = inside != is_inside(p, loop);
  }
  return inside ? distance : -distance;
}

Polygon Shape<2>::corners() const
{
  return fine_outline(*this).front();
}

void Shape<2>::describe(std::ostream &out, const Place &center) const
{
  for (const Place &corner : corners())
    out << corner - center << ';';
}

std::vector<double> Shape<2>::numbers() const
{
  std::vector<double> result;
  for (const Place &corner : corners())
    result.insert(result.end(), {corner[0], corner[1]});
  return result;
}

std::pair<Shape<2>::Place, Shape<2>::Place> Shape<2>::bounding_box() const
{
  const auto x = distances_from_plane(Place(), Place(1, 0)), y = distances_from_plane(Place(), Place(0, 1));
  return {{x.first, y.first}, {x.second, y.second}};
}

double Shape<2>::size() const
{
  const auto box = bounding_box();
  return box.first.distance(box.second);
}

bool overlap(const Shape<2> &a, const Shape<2> &b, const double tolerance)
{
  return overlap_when_moved(a, b, dealii::Tensor<1, 2>(), tolerance);
}

bool overlap_when_moved(const Shape<2> &a,
                        const Shape<2> &b,
                        const dealii::Tensor<1, 2> &shift,
                        const double tolerance)
{
  const auto box_a = a.bounding_box(), box_b = b.bounding_box();
  for (unsigned int d = 0; d < 2; ++d)
    if (box_a.second[d] < box_b.first[d] + shift[d] + tolerance ||
        box_b.second[d] + shift[d] < box_a.first[d] + tolerance)
      return false;
  const auto *const disk_a = dynamic_cast<const Disk2D *>(&a), *const disk_b =
                                                                   dynamic_cast<const Disk2D *>(&b);
  const auto moved_disk = [&]() -> Disk2D {
    return {disk_b->center + shift, disk_b->radius, disk_b->inner_radius};
  };
  if (disk_a != nullptr && disk_b != nullptr)
    return disks_overlap(*disk_a, moved_disk(), tolerance);
  if (disk_b != nullptr)
    return disk_overlaps_polygon(moved_disk(), a.corners(), tolerance);
  Polygon corners = b.corners();
  for (dealii::Point<2> &corner : corners)
    corner += shift;
  if (disk_a != nullptr)
    return disk_overlaps_polygon(*disk_a, corners, tolerance);
  return polygons_overlap(a.corners(), corners, tolerance);
}
} // namespace softgrain
