// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/image_pairs.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
using Box = dealii::BoundingBox<2>;

Box moved(const Box &box, const dealii::Tensor<1, 2> &way)
{
  return Box({box.get_boundary_points().first + way, box.get_boundary_points().second + way});
}
} // namespace

std::vector<ImagePair> pairs_across(const std::vector<Box> &boxes, const PeriodicCell<2> &cell)
{
  std::vector<ImagePair> pairs;
  const auto tree = dealii::pack_rtree_of_indices(boxes);
  const auto bounds = tree.bounds();
  // Of an image and its opposite one is enough. Beside the nearest cells above there are two on each side,
  // because they stand to the side.
  const int above = cell.periodic[1] ? 1 : 0, beside = cell.periodic[0] ? 1 + above : 0;
  for (int up = 0; up <= above; ++up)
    for (int right = up == 0 ? 1 : -beside; right <= beside; ++right)
    {
      const PeriodicCell<2>::Image image = cell.from_reduced({{right, up}});
      for (unsigned int b = 0; b < boxes.size(); ++b)
      {
        const Box there = moved(boxes[b], cell.shift(image));
        if (!boost::geometry::intersects(there, bounds))
          continue;
        const std::size_t first = pairs.size();
        for (const std::size_t a :
             tree | boost::geometry::index::adaptors::queried(boost::geometry::index::intersects(there)))
          pairs.push_back({static_cast<unsigned int>(a), b, image});
        std::sort(pairs.begin() + first, pairs.end(),
                  [](const ImagePair &one, const ImagePair &other) { return one.a < other.a; });
      }
    }
  return pairs;
}
} // namespace softgrain::mpm
