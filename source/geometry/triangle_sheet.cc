// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/triangle_sheet.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <vector>

namespace softgrain
{
namespace
{
using Vector = dealii::Tensor<1, 3>;
using Point = dealii::Point<3>;

/// The place of a triangle that is nearest to a place, and what it lies on.
struct OnTriangle
{
  Point place;
  Vector edge; ///< that it lies on, any length; 0: on none
  bool at_corner = false;
};

OnTriangle on_edge(const Point &a, const Vector &edge, const double share)
{
  OnTriangle result;
  result.place = a + std::clamp(share, 0., 1.) * edge;
  result.at_corner = share <= 0. || share >= 1.;
  result.edge = edge;
  return result;
}

OnTriangle nearest_on(const Point &a, const Point &b, const Point &c, const Point &x)
{
  const Vector ab = b - a, ac = c - a, normal = dealii::cross_product_3d(ab, ac), ax = x - a;
  const double area = normal.norm_square(), of_b = dealii::cross_product_3d(ax, ac) * normal / area,
               of_c = dealii::cross_product_3d(ab, ax) * normal / area, of_a = 1. - of_b - of_c;
  if (of_a >= 0. && of_b >= 0. && of_c >= 0.)
  {
    OnTriangle inside;
    inside.place = a + of_b * ab + of_c * ac;
    return inside;
  }
  OnTriangle best;
  double nearest = -1.;
  for (const auto &[from, to] : {std::make_pair(a, b), std::make_pair(b, c), std::make_pair(c, a)})
  {
    const Vector edge = to - from;
    const OnTriangle candidate = on_edge(from, edge, (x - from) * edge / edge.norm_square());
    const double distance = x.distance_square(candidate.place);
    if (nearest < 0. || distance < nearest)
    {
      nearest = distance;
      best = candidate;
    }
  }
  return best;
}
} // namespace

struct TriangleSheet::Tree
{
  explicit Tree(const std::vector<dealii::BoundingBox<3>> &list)
      : boxes(list), tree(dealii::pack_rtree_of_indices(boxes))
  {
  }
  const std::vector<dealii::BoundingBox<3>> boxes;
  const decltype(dealii::pack_rtree_of_indices(boxes)) tree;
};

TriangleSheet::TriangleSheet(TriangulatedSurface triangles, const double thickness)
    : RigidSurface(thickness, triangles.vertices)
    , sheet(std::move(triangles))
    , tree(
          [this]()
          {
            std::vector<dealii::BoundingBox<3>> boxes;
            for (const auto &[a, b, c] : sheet.triangles)
              boxes.emplace_back(std::vector<Point>{sheet.vertices[a], sheet.vertices[b], sheet.vertices[c]});
            return std::make_unique<const Tree>(boxes);
          }())
{
}

TriangleSheet::~TriangleSheet() = default;

std::optional<RigidSurface::Foot> TriangleSheet::foot(const Point &x, const double within) const
{
  Vector reach;
  for (unsigned int d = 0; d < 3; ++d)
    reach[d] = within;
  const dealii::BoundingBox<3> around({Point(x - reach), Point(x + reach)});
  std::vector<unsigned int> near;
  tree->tree.query(boost::geometry::index::intersects(around), std::back_inserter(near));
  std::sort(near.begin(), near.end()); // so that of equals the first counts
  double nearest = within;
  OnTriangle best;
  bool any = false;
  for (const unsigned int t : near)
  {
    const auto &[a, b, c] = sheet.triangles[t];
    const OnTriangle candidate = nearest_on(sheet.vertices[a], sheet.vertices[b], sheet.vertices[c], x);
    if (const double distance = x.distance(candidate.place); any ? distance < nearest : distance <= nearest)
    {
      nearest = distance;
      best = candidate;
      any = true;
    }
  }
  if (!any || !(nearest > 0.))
    return std::nullopt;
  Foot result;
  result.place = best.place;
  result.distance = nearest;
  result.normal = (x - best.place) / nearest;
  const bool flat = best.edge.norm_square() == 0.;
  result.along = flat || best.at_corner ? any_tangent(result.normal) : best.edge / best.edge.norm();
  result.bend = {{best.at_corner ? 1. / radius : 0., flat ? 0. : 1. / radius}};
  return result;
}
} // namespace softgrain
