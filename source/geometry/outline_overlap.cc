// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/outline_overlap.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain
{
namespace
{
using Place = Outline::Place;
using Vector = dealii::Tensor<1, 2>;

struct Edge
{
  Place begin, end;
};

/// What two outlines may share: the box that both of their boxes hold, and in it a strip across the way from
/// one to the other, which is narrow where they touch.
struct Shared
{
  Shared(const Outline &a, const Outline &b)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      lower[d] = std::max(a.lower[d], b.lower[d]);
      upper[d] = std::min(a.upper[d], b.upper[d]);
      across[d] = (b.lower[d] + b.upper[d]) - (a.lower[d] + a.upper[d]);
    }
    if (lower[0] > upper[0] || lower[1] > upper[1])
      return;
    first = std::numeric_limits<double>::max();
    last = std::numeric_limits<double>::lowest();
    for (const Place &x : b.vertices)
      first = std::min(first, along(x));
    for (const Place &x : a.vertices)
      last = std::max(last, along(x));
  }

  bool empty() const { return first > last; }
  bool holds(const Place &x) const
  {
    return x[0] >= lower[0] && x[0] <= upper[0] && x[1] >= lower[1] && x[1] <= upper[1] &&
           along(x) >= first && along(x) <= last;
  }
  /// Whether an edge may reach into it.
  bool meets(const Place &a, const Place &b) const
  {
    for (unsigned int d = 0; d < 2; ++d)
      if (std::max(a[d], b[d]) < lower[d] || std::min(a[d], b[d]) > upper[d])
        return false;
    return std::max(along(a), along(b)) >= first && std::min(along(a), along(b)) <= last;
  }

private:
  double along(const Place &x) const { return across[0] * x[0] + across[1] * x[1]; }

  Place lower, upper;
  Vector across;
  double first = 0., last = -1.;
};

/// Whether a ray from @p x to the right crosses this edge.
bool crosses(const Place &x, const Place &a, const Place &b)
{
  return (a[1] > x[1]) != (b[1] > x[1]) && x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
}

double distance_square(const Place &x, const Place &a, const Place &b)
{
  const Vector edge = b - a, way = x - a;
  const double square = edge.norm_square();
  const double share = square > 0. ? std::clamp(way * edge / square, 0., 1.) : 0.;
  return (way - share * edge).norm_square();
}

double cross(const Vector &a, const Vector &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// Adds the share of @p edge at which it meets @p other.
void add_crossing(const Edge &edge, const Edge &other, std::vector<double> &shares)
{
  for (unsigned int d = 0; d < 2; ++d)
    if (std::max(edge.begin[d], edge.end[d]) < std::min(other.begin[d], other.end[d]) ||
        std::max(other.begin[d], other.end[d]) < std::min(edge.begin[d], edge.end[d]))
      return;
  const Vector along = edge.end - edge.begin, across = other.end - other.begin,
               way = other.begin - edge.begin;
  const double area = cross(along, across);
  if (area == 0.)
    return;
  const double share = cross(way, across) / area, of_other = cross(way, along) / area;
  if (share >= 0. && share <= 1. && of_other >= 0. && of_other <= 1.)
    shares.push_back(share);
}

/// Intrusion of the vertices of @p one in @p other.
Intrusion vertices_inside(const Outline &one, const Outline &other, const Shared &shared)
{
  Intrusion deepest;
  for (const Place &x : one.vertices)
    if (shared.holds(x) && other.encloses(x))
      deepest.take({other.distance(x), x});
  return deepest;
}

std::vector<Edge> edges_near(const Outline &outline, const Shared &shared)
{
  std::vector<Edge> edges;
  outline.for_edges(
      [&](const Place &begin, const Place &end)
      {
        if (shared.meets(begin, end))
          edges.push_back({begin, end});
      });
  return edges;
}

/// Intrusion of what lies between two places where edges cross others, in the outline of the others.
Intrusion
stretches_inside(const std::vector<Edge> &edges, const std::vector<Edge> &others, const Outline &outline)
{
  Intrusion deepest;
  std::vector<double> shares;
  for (const Edge &edge : edges)
  {
    shares.clear();
    for (const Edge &across : others)
      add_crossing(edge, across, shares);
    if (shares.empty())
      continue;
    shares.insert(shares.end(), {0., 1.});
    std::sort(shares.begin(), shares.end());
    for (std::size_t i = 0; i + 1 < shares.size(); ++i)
    {
      const Place middle = edge.begin + 0.5 * (shares[i] + shares[i + 1]) * (edge.end - edge.begin);
      if (outline.encloses(middle))
        deepest.take({outline.distance(middle), middle});
    }
  }
  return deepest;
}
} // namespace

bool Outline::encloses(const Place &x) const
{
  bool inside = false;
  for_edges([&](const Place &begin, const Place &end) { inside ^= crosses(x, begin, end); });
  return inside;
}

double Outline::distance(const Place &x) const
{
  double square = std::numeric_limits<double>::max();
  for_edges([&](const Place &begin, const Place &end)
            { square = std::min(square, distance_square(x, begin, end)); });
  return std::sqrt(square);
}

Intrusion deepest_intrusion(const Outline &a, const Outline &b)
{
  const Shared shared(a, b);
  if (shared.empty())
    return {};
  Intrusion deepest = vertices_inside(a, b, shared);
  deepest.take(vertices_inside(b, a, shared));
  if (deepest.depth > 0.)
    return deepest;
  const std::vector<Edge> of_a = edges_near(a, shared), of_b = edges_near(b, shared);
  deepest = stretches_inside(of_a, of_b, b);
  deepest.take(stretches_inside(of_b, of_a, a));
  return deepest;
}

Intrusion deepest_beyond(const Outline &outline, const Place &point, const Vector &normal)
{
  const Place corner(normal[0] > 0. ? outline.lower[0] : outline.upper[0],
                     normal[1] > 0. ? outline.lower[1] : outline.upper[1]);
  Intrusion deepest;
  if ((corner - point) * normal >= 0.)
    return deepest;
  for (const Place &x : outline.vertices)
    deepest.take({(point - x) * normal, x});
  return deepest;
}

Intrusion deepest_within(const Outline &outline, const Polygon &line, const double spacing)
{
  Intrusion deepest;
  const auto in_box = [&](const Place &x)
  {
    return x[0] > outline.lower[0] && x[0] < outline.upper[0] && x[1] > outline.lower[1] &&
           x[1] < outline.upper[1];
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    // The share of the edge that lies in the box.
    const Vector edge = line[i + 1] - line[i];
    double first = 0., last = 1.;
    for (unsigned int d = 0; d < 2; ++d)
    {
      if (edge[d] == 0.)
      {
        if (line[i][d] <= outline.lower[d] || line[i][d] >= outline.upper[d])
          last = -1.;
        continue;
      }
      const double s = (outline.lower[d] - line[i][d]) / edge[d],
                   t = (outline.upper[d] - line[i][d]) / edge[d];
      first = std::max(first, std::min(s, t));
      last = std::min(last, std::max(s, t));
    }
    if (first > last)
      continue;
    const unsigned int n =
        1 + static_cast<unsigned int>(std::min(1e5, (last - first) * edge.norm() / spacing));
    for (unsigned int k = 0; k <= n; ++k)
    {
      const Place x = line[i] + (first + (last - first) * k / n) * edge;
      if (in_box(x) && outline.encloses(x))
        deepest.take({outline.distance(x), x});
    }
  }
  return deepest;
}
} // namespace softgrain
