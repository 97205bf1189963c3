// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/image_pairs.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>

namespace softgrain::mpm
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

template <int dim>
std::vector<ImagePair<dim>> pairs_across(const std::vector<dealii::BoundingBox<dim>> &boxes,
                                         const PeriodicCell<dim> &cell)
{
  std::vector<ImagePair<dim>> pairs;
  const auto tree = dealii::pack_rtree_of_indices(boxes);
  const auto bounds = tree.bounds();
  const auto images = cell.neighbours();
  // Of an image and its opposite one is enough: those behind the cell itself.
  for (std::size_t i = images.size() / 2 + 1; i < images.size(); ++i)
    for (unsigned int b = 0; b < boxes.size(); ++b)
    {
      const dealii::BoundingBox<dim> there = moved(boxes[b], cell.shift(images[i]));
      if (!boost::geometry::intersects(there, bounds))
        continue;
      const std::size_t first = pairs.size();
      for (const std::size_t a :
           tree | boost::geometry::index::adaptors::queried(boost::geometry::index::intersects(there)))
        pairs.push_back({static_cast<unsigned int>(a), b, images[i]});
      std::sort(pairs.begin() + first, pairs.end(),
                [](const ImagePair<dim> &one, const ImagePair<dim> &other) { return one.a < other.a; });
    }
  return pairs;
}

template std::vector<ImagePair<2>> pairs_across(const std::vector<dealii::BoundingBox<2>> &,
                                                const PeriodicCell<2> &);
template std::vector<ImagePair<3>> pairs_across(const std::vector<dealii::BoundingBox<3>> &,
                                                const PeriodicCell<3> &);
} // namespace softgrain::mpm
