// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/aggregate_outline.h>
#include <softgrain/geometry/uncovered_arcs.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

namespace softgrain
{
namespace
{
using Polygon = std::vector<dealii::Point<2>>;
using Vector = dealii::Tensor<1, 2>;

constexpr double full_turn = 2. * M_PI;
constexpr double largest_step = M_PI / 8.;
constexpr unsigned int none = UncoveredArc::none;

/// A disk widened by the probe: the probe's centre stays outside of all of them and rolls along their union.
using Disk = DiskOfUnion;
using Arc = UncoveredArc;

double cross(const Vector &a, const Vector &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// The arc that goes on where an arc ends, for every arc.
std::vector<unsigned int> linked(const std::vector<Arc> &arcs, const std::vector<Disk> &disks)
{
  const unsigned int n = arcs.size();
  std::vector<unsigned int> next(n, none), first(disks.size() + 1, 0);
  std::vector<bool> taken(n, false);
  for (const Arc &arc : arcs) // they come in the order of disks
    ++first[arc.disk + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<unsigned int> loose;
  for (unsigned int a = 0; a < n; ++a)
  {
    if (arcs[a].to == none)
    {
      next[a] = a;
      taken[a] = true;
      continue;
    }
    for (unsigned int b = first[arcs[a].to]; b < first[arcs[a].to + 1] && next[a] == none; ++b)
      if (arcs[b].from == arcs[a].disk && !taken[b])
      {
        next[a] = b;
        taken[b] = true;
      }
    if (next[a] == none)
      loose.push_back(a);
  }
  // Where three edges pass through one point, as in a lattice, rounding may see different neighbours from two
  // sides. There are as many beginnings as ends, and those that belong together are at one place.
  std::vector<unsigned int> free;
  for (unsigned int b = 0; b < n; ++b)
    if (!taken[b])
      free.push_back(b);
  const auto place = [&](const unsigned int disk, const Vector &direction)
  { return disks[disk].center + disks[disk].radius * direction; };
  for (const unsigned int a : loose)
  {
    const dealii::Point<2> end = place(arcs[a].disk, arcs[a].end);
    const auto nearest = std::min_element(free.begin(), free.end(),
                                          [&](const unsigned int b, const unsigned int c)
                                          {
                                            return (place(arcs[b].disk, arcs[b].begin) - end).norm_square() <
                                                   (place(arcs[c].disk, arcs[c].begin) - end).norm_square();
                                          });
    next[a] = *nearest;
    free.erase(nearest);
  }
  return next;
}

/// Adds an arc but its end. Its inner vertices are a little outside, so that the polyline encloses with the
/// centre the same area as the arc.
void add_arc(Polygon &polygon,
             const dealii::Point<2> &center,
             const double radius,
             const Vector &from,
             const double angle)
{
  polygon.push_back(center + radius * from);
  const double size = std::abs(angle);
  if (size < 1e-2) // an arc this short is straight to 1e-7 of the disk's area
    return;
  const int n = std::max(2, static_cast<int>(std::ceil(size / largest_step - 1e-9)));
  const double step = size / n;
  // r^2 size = 2 r R sin(step) + (n - 2) R^2 sin(step) for the distance R of inner vertices.
  const double scaled = size / std::sin(step);
  const double distance = radius * scaled / (1. + std::sqrt(1. + (n - 2) * scaled));
  for (int k = 1; k < n; ++k)
  {
    const double c = std::cos(k * angle / n), s = std::sin(k * angle / n);
    polygon.push_back(center + distance * Vector({c * from[0] - s * from[1], s * from[0] + c * from[1]}));
  }
}

/// The probe's edge from disk @p a to disk @p b that it rests on, clockwise about its centre, without its
/// end.
void add_bridge(
    Polygon &polygon, const Arc &a, const Arc &b, const std::vector<Disk> &disks, const double probe_radius)
{
  const Disk &i = disks[a.disk], &j = disks[b.disk];
  const dealii::Point<2> probe = i.center + i.radius * a.end;
  const Vector from = -a.end, to = -b.begin;
  // Rounding may turn an arc of no length into one of a full turn.
  const auto clockwise = [](const Vector &u, const Vector &v)
  {
    const double angle = std::atan2(cross(v, u), u * v);
    return angle < -1e-6 ? angle + full_turn : std::max(0., angle);
  };
  // A probe between two disks far apart pokes through the line between their centres; what is behind that
  // line belongs to the probe on the other side.
  const Vector line = j.center - i.center;
  const double length = line.norm();
  if (length > 0.)
  {
    const Vector along = line / length;
    const double foot = (probe - i.center) * along, height = std::abs(cross(along, probe - i.center));
    if (height < 1.03 * probe_radius && foot > 0. && foot < length)
    {
      const double half = std::sqrt(std::max(0., (probe_radius - height) * (probe_radius + height)));
      const Vector down = i.center + foot * along - probe;
      const Vector cut_a = (down - half * along) / (down - half * along).norm();
      const Vector cut_b = (down + half * along) / (down + half * along).norm();
      add_arc(polygon, probe, probe_radius, from, -clockwise(from, cut_a));
      polygon.push_back(probe + probe_radius * cut_a);
      add_arc(polygon, probe, probe_radius, cut_b, -clockwise(cut_b, to));
      return;
    }
  }
  add_arc(polygon, probe, probe_radius, from, -clockwise(from, to));
}

double signed_area(const Polygon &polygon)
{
  double twice = 0.;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  return 0.5 * twice;
}

bool is_inside(const Polygon &polygon, const dealii::Point<2> &point)
{
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
    if ((a[1] > 0.) != (b[1] > 0.) && (cross(a, b) > 0.) == (b[1] > a[1]))
      inside = !inside;
  }
  return inside;
}

/// The closed line of the arcs from @p start on.
Polygon traced(const unsigned int start,
               const std::vector<Arc> &arcs,
               const std::vector<unsigned int> &next,
               const std::vector<Disk> &disks,
               const std::vector<double> &radii,
               const double probe_radius,
               std::vector<bool> &done)
{
  Polygon polygon;
  for (unsigned int a = start; !done[a]; a = next[a])
  {
    done[a] = true;
    const Arc &arc = arcs[a];
    double angle = full_turn;
    if (arc.from != none)
    {
      angle = std::atan2(cross(arc.begin, arc.end), arc.begin * arc.end);
      if (angle < 0.)
        angle = arc.length < 1e-6 ? 0. : angle + full_turn;
    }
    const dealii::Point<2> &center = disks[arc.disk].center;
    const double radius = radii[arc.disk];
    add_arc(polygon, center, radius, arc.begin, angle);
    if (arc.from != none)
    {
      polygon.push_back(center + radius * arc.end);
      add_bridge(polygon, arc, arcs[next[a]], disks, probe_radius);
    }
  }
  return polygon;
}

using AreaAndLine = std::pair<double, Polygon>;

/// Outlines, the largest first, each before its holes. A hole belongs to the smallest outline around it: a
/// fragment may lie in the hole of a larger one.
std::vector<Polygon> with_holes(std::vector<AreaAndLine> &outer, std::vector<AreaAndLine> &inner)
{
  const auto larger = [](const auto &a, const auto &b) { return a.first > b.first; };
  std::stable_sort(outer.begin(), outer.end(), larger);
  std::vector<std::vector<Polygon>> holes_of(outer.size());
  for (auto &hole : inner)
    for (std::size_t o = outer.size(); o-- > 0;)
      if (is_inside(outer[o].second, hole.second[0]))
      {
        holes_of[o].push_back(std::move(hole.second));
        break;
      }
  std::vector<Polygon> result;
  for (std::size_t o = 0; o < outer.size(); ++o)
  {
    result.push_back(std::move(outer[o].second));
    std::move(holes_of[o].begin(), holes_of[o].end(), std::back_inserter(result));
  }
  return result;
}
} // namespace

std::vector<Polygon> aggregate_outline(const std::vector<dealii::Point<2>> &centers,
                                       const std::vector<double> &radii,
                                       const double probe_radius,
                                       const bool holes)
{
  AssertDimension(centers.size(), radii.size());
  Assert(probe_radius > 0., dealii::ExcMessage("The probe needs a positive radius."));
  std::vector<Disk> disks(centers.size());
  for (std::size_t i = 0; i < disks.size(); ++i)
  {
    disks[i] = {centers[i], radii[i] + probe_radius};
    if (!std::isfinite(centers[i][0] + centers[i][1] + radii[i]))
      throw ComputationError("outline of an aggregate: place or radius of its disk " + std::to_string(i) +
                             " is not finite; a smaller time step may help");
  }
  if (disks.empty())
    return {};
  const std::vector<Arc> arcs = uncovered_arcs(disks);
  const std::vector<unsigned int> next = linked(arcs, disks);

  std::vector<AreaAndLine> outer, inner;
  std::vector<bool> done(arcs.size(), false);
  for (unsigned int start = 0; start < arcs.size(); ++start)
  {
    if (done[start])
      continue;
    Polygon polygon = traced(start, arcs, next, disks, radii, probe_radius, done);
    const double area = signed_area(polygon);
    if (area > 0.)
      outer.emplace_back(area, std::move(polygon));
    else if (holes && area < 0.)
      inner.emplace_back(area, std::move(polygon));
  }
  return with_holes(outer, inner);
}
} // namespace softgrain
