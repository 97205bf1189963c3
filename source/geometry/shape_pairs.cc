// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/shape_pairs.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>

namespace softgrain
{
namespace
{
using Vector = dealii::Tensor<1, 2>;
using Box = dealii::BoundingBox<2>;

Box moved(const Box &box, const Vector &way)
{
  return Box({box.get_boundary_points().first + way, box.get_boundary_points().second + way});
}

/// Copies of the cell in which a neighbour of what lies in it may lie.
std::vector<PeriodicCell<2>::Image> neighbouring_images(const PeriodicCell<2> &cell)
{
  // The cells above may stand to the side.
  const int above = cell.periodic[1] ? 1 : 0, beside = cell.periodic[0] ? 1 + above : 0;
  std::vector<PeriodicCell<2>::Image> images;
  for (int up = -above; up <= above; ++up)
    for (int right = -beside; right <= beside; ++right)
      images.push_back(cell.from_reduced({{right, up}}));
  return images;
}
} // namespace

std::optional<std::pair<std::size_t, std::size_t>>
find_overlap(const std::vector<const Shape<2> *> &shapes, const PeriodicCell<2> &cell, const double touching)
{
  std::vector<Box> boxes; // of the shapes brought into the cell
  std::vector<Vector> folds;
  std::vector<double> sizes;
  for (const Shape<2> *const shape : shapes)
  {
    const Box box(shape->bounding_box());
    const auto &[lower, upper] = box.get_boundary_points();
    folds.push_back(cell.repeats() ? cell.shift(cell.image_of(lower + 0.5 * (upper - lower))) : Vector());
    boxes.push_back(moved(box, -folds.back()));
    sizes.push_back(lower.distance(upper));
  }
  const auto tree = dealii::pack_rtree_of_indices(boxes);
  const std::vector<PeriodicCell<2>::Image> images = neighbouring_images(cell);
  for (std::size_t a = 0; a < shapes.size(); ++a)
  {
    std::vector<std::pair<std::size_t, Vector>> near;
    for (const PeriodicCell<2>::Image &image : images)
    {
      const Vector way = cell.shift(image);
      for (const std::size_t b : tree | boost::geometry::index::adaptors::queried(
                                            boost::geometry::index::intersects(moved(boxes[a], -way))))
        if (b < a)
          near.emplace_back(b, way + folds[a] - folds[b]);
    }
    std::stable_sort(near.begin(), near.end(),
                     [](const auto &one, const auto &other) { return one.first < other.first; });
    for (const auto &[b, shift] : near)
      if (overlap_when_moved(*shapes[a], *shapes[b], shift, touching * std::max(sizes[a], sizes[b])))
        return std::make_pair(b, a);
  }
  return std::nullopt;
}
} // namespace softgrain
