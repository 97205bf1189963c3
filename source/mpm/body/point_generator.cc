// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/shape.h>
#include <softgrain/mpm/body/point_generator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
/// Edges of a boundary sorted by rows of parts, so that cutting one part looks at the boundary only when it
/// is near.
class BoundaryCutter
{
public:
  BoundaryCutter(std::vector<Polygon> outline, const double part_size)
      : loops(std::move(outline)), size(part_size)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      lower[d] = std::numeric_limits<double>::max();
      upper[d] = -lower[d];
    }
    for (const Polygon &loop : loops)
      for (const dealii::Point<2> &x : loop)
        for (unsigned int d = 0; d < 2; ++d)
        {
          lower[d] = std::min(lower[d], x[d]);
          upper[d] = std::max(upper[d], x[d]);
        }
  }

  /// Strips of the boundary between two heights: cutting every part of a row then starts from a short
  /// polygon.
  std::vector<Polygon> strip(const double y0, const double y1) const
  {
    std::vector<Polygon> result;
    for (const Polygon &loop : loops)
      result.push_back(
          clip_to_box(loop, dealii::Point<2>(lower[0] - size, y0), dealii::Point<2>(upper[0] + size, y1)));
    return result;
  }

  dealii::Point<2> lower, upper;

private:
  std::vector<Polygon> loops;
  double size;
};

/// Adds the points of all cells of one size, whose edge is @p part times the points per direction.
template <class IsWanted>
void add_points(const BodyDescription<2> &body,
                const Lattice<2> &lattice,
                const double part,
                const IsWanted &wanted,
                GeneratedPoints<2> &points)
{
  const BoundaryCutter boundary(body.shape->outline(part / 16.), part);
  int first[2], last[2];
  for (unsigned int d = 0; d < 2; ++d)
  {
    first[d] = static_cast<int>(std::floor((boundary.lower[d] - lattice.lower()[d]) / part));
    last[d] = static_cast<int>(std::floor((boundary.upper[d] - lattice.lower()[d]) / part));
  }
  for (int j = first[1]; j <= last[1]; ++j)
  {
    const double y0 = lattice.lower()[1] + j * part;
    const std::vector<Polygon> strip = boundary.strip(y0, y0 + part);
    for (int i = first[0]; i <= last[0]; ++i)
    {
      const double x0 = lattice.lower()[0] + i * part;
      if (!wanted(dealii::Point<2>(x0 + 0.5 * part, y0 + 0.5 * part)))
        continue;
      double area = 0.;
      dealii::Tensor<1, 2> moment;
      for (const Polygon &loop : strip)
      {
        // Holes run clockwise: their area counts negative.
        const auto [a, c] = area_and_centroid(
            clip_to_box(loop, dealii::Point<2>(x0, y0), dealii::Point<2>(x0 + part, y0 + part)));
        area += a;
        moment += a * (c - dealii::Point<2>());
      }
      // Slivers below this carry no more mass than rounding and would sit anywhere.
      if (area > 1e-9 * part * part)
      {
        points.position.push_back(dealii::Point<2>(moment / area));
        points.volume.push_back(area);
      }
    }
  }
}
} // namespace

GeneratedPoints<2> generate_points(const BodyDescription<2> &body,
                                   const Lattice<2> &lattice,
                                   const unsigned int per_direction,
                                   const CellLevels<2> *levels)
{
  GeneratedPoints<2> points;
  for (unsigned int l = 0; l <= (levels ? levels->highest() : 0); ++l)
    add_points(
        body, lattice, (1 << l) * lattice.cell_size() / per_direction,
        [&](const dealii::Point<2> &x)
        { return levels == nullptr || levels->level(lattice.cell_of(x)) == l; },
        points);
  // The polygon through points of a circle lacks a sliver: restore the exact area of the body.
  if (body.shape->round() && !points.volume.empty())
  {
    double sum = 0.;
    for (const double v : points.volume)
      sum += v;
    const double exact = body.shape->area();
    for (double &v : points.volume)
      v *= exact / sum;
  }
  return points;
}
} // namespace softgrain::mpm
