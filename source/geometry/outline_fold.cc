// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/outline_overlap.h>
#include <softgrain/geometry/turning.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain
{
namespace
{
using Place = Outline::Place;
using Vector = dealii::Tensor<1, 2>;

constexpr double before_it = 1e-3; ///< where a vertex looks for material [edges]

double cross(const Vector &a, const Vector &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

Vector outward(const Vector &edge)
{
  return Vector({edge[1], -edge[0]});
}

/// How often the edge goes around a place.
int winding(const Outline &outline, const Place &x)
{
  int number = 0;
  outline.for_edges(
      [&](const Place &a, const Place &b)
      {
        if ((a[1] <= x[1]) == (b[1] <= x[1]))
          return;
        const bool left = cross(b - a, x - a) > 0.;
        if (b[1] > a[1] && left)
          ++number;
        else if (b[1] <= a[1] && !left)
          --number;
      });
  return number;
}

/// Of every vertex, the way to it along its loop from where that begins [m].
std::vector<double> ways_along(const Outline &outline)
{
  std::vector<double> along(outline.vertices.size(), 0.);
  for (std::size_t l = 0; l + 1 < outline.loop_start.size(); ++l)
    for (unsigned int v = outline.loop_start[l] + 1; v < outline.loop_start[l + 1]; ++v)
      along[v] = along[v - 1] + outline.vertices[v].distance(outline.vertices[v - 1]);
  return along;
}

/// Length of loop @p l [m].
double along_all(const Outline &outline, const std::vector<double> &along, const std::size_t l)
{
  const unsigned int last = outline.loop_start[l + 1] - 1;
  return along[last] + outline.vertices[last].distance(outline.vertices[outline.loop_start[l]]);
}

/// From a vertex to the nearest edge of any loop that faces @p normal; nothing where that is nearer than
/// @p least_way along its own loop [m].
double distance_to_facing(const Outline &outline,
                          const unsigned int vertex,
                          const std::vector<double> &along,
                          const Vector &normal,
                          const double least_way)
{
  const Place &x = outline.vertices[vertex];
  double nearest = std::numeric_limits<double>::max(), way = nearest;
  for (std::size_t l = 0; l + 1 < outline.loop_start.size(); ++l)
  {
    const unsigned int begin = outline.loop_start[l], end = outline.loop_start[l + 1];
    for (unsigned int v = begin; v < end; ++v)
    {
      const Place &a = outline.vertices[v];
      const Vector edge = outline.vertices[v + 1 == end ? begin : v + 1] - a;
      if (outward(edge) * normal >= 0.)
        continue;
      const double share = std::clamp((x - a) * edge / edge.norm_square(), 0., 1.);
      const double distance = x.distance(a + share * edge);
      if (distance >= nearest)
        continue;
      nearest = distance;
      const double apart = std::abs(along[v] + share * edge.norm() - along[vertex]);
      way =
          vertex < begin || vertex >= end ? least_way : std::min(apart, along_all(outline, along, l) - apart);
    }
  }
  return way < least_way || way == std::numeric_limits<double>::max() ? 0. : nearest;
}
} // namespace

Intrusion deepest_fold(const Outline &outline, const double least_way)
{
  Intrusion deepest;
  std::vector<double> along;
  for (std::size_t l = 0; l + 1 < outline.loop_start.size(); ++l)
  {
    const unsigned int begin = outline.loop_start[l], end = outline.loop_start[l + 1];
    const unsigned int n = end - begin;
    const auto edge = [&](const unsigned int k)
    { return outline.vertices[begin + (k + 1) % n] - outline.vertices[begin + k % n]; };
    if (!may_meet_itself(n,
                         [&](const unsigned int k)
                         {
                           const Vector before = edge(k), after = edge(k + 1);
                           return std::atan2(cross(before, after), before * after);
                         }))
      continue;
    if (along.empty())
      along = ways_along(outline);
    for (unsigned int v = begin; v < end; ++v)
    {
      const Place &x = outline.vertices[v];
      const Vector before = edge(v - begin + n - 1), after = edge(v - begin);
      const Vector normal = outward(before) / before.norm() + outward(after) / after.norm();
      const double length = normal.norm();
      // At the tip of a needle the normals of both edges cancel: their mean tells no side.
      if (length < 0.5 || winding(outline, x + before_it * after.norm() / length * normal) == 0)
        continue;
      deepest.take({distance_to_facing(outline, v, along, normal, least_way), x});
    }
  }
  return deepest;
}
} // namespace softgrain
