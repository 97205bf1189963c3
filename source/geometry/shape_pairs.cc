// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/shape_pairs.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>

namespace softgrain
{
namespace
{
template <int dim>
dealii::BoundingBox<dim> moved(const dealii::BoundingBox<dim> &box, const dealii::Tensor<1, dim> &way)
{
  return dealii::BoundingBox<dim>(
      {box.get_boundary_points().first + way, box.get_boundary_points().second + way});
}
} // namespace

bool overlap_when_moved(const Shape<3> &a,
                        const Shape<3> &b,
                        const dealii::Tensor<1, 3> &shift,
                        const double /*tolerance*/)
{
  return overlap(a, b, shift) > 0.;
}

template <int dim>
std::optional<std::pair<std::size_t, std::size_t>> find_overlap(const std::vector<const Shape<dim> *> &shapes,
                                                                const PeriodicCell<dim> &cell,
                                                                const double touching)
{
  using Vector = dealii::Tensor<1, dim>;
  using Box = dealii::BoundingBox<dim>;
  std::vector<Box> boxes; // of the shapes brought into the cell
  std::vector<Vector> folds;
  std::vector<double> sizes;
  for (const Shape<dim> *const shape : shapes)
  {
    const Box box(shape->bounding_box());
    const auto &[lower, upper] = box.get_boundary_points();
    folds.push_back(cell.repeats() ? cell.shift(cell.image_of(lower + 0.5 * (upper - lower))) : Vector());
    boxes.push_back(moved(box, -folds.back()));
    sizes.push_back(lower.distance(upper));
  }
  const auto tree = dealii::pack_rtree_of_indices(boxes);
  const auto images = cell.neighbours();
  for (std::size_t a = 0; a < shapes.size(); ++a)
  {
    std::vector<std::pair<std::size_t, Vector>> near;
    for (const auto &image : images)
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

template std::optional<std::pair<std::size_t, std::size_t>>
find_overlap(const std::vector<const Shape<2> *> &, const PeriodicCell<2> &, double);
template std::optional<std::pair<std::size_t, std::size_t>>
find_overlap(const std::vector<const Shape<3> *> &, const PeriodicCell<3> &, double);
} // namespace softgrain
