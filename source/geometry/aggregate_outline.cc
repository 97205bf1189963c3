// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/aggregate_outline.h>

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
constexpr unsigned int none = static_cast<unsigned int>(-1);

/// A disk widened by the probe: the probe's centre stays outside of all of them and rolls along their union.
struct Disk
{
  dealii::Point<2> center;
  double radius;
};

/// The part of a disk's edge that another disk covers, as directions counted from 0 to 4 for a full turn.
struct Covered
{
  double begin, end;
  unsigned int by;
};

/// A part of a disk's edge that no other disk covers, counter-clockwise between two neighbours.
struct Arc
{
  unsigned int disk, from, to; ///< `from` is none on a disk that nobody touches
  double length;               ///< as in Covered
  Vector begin, end;           ///< unit directions from the centre
};

double cross(const Vector &a, const Vector &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// Grows with the angle of @p v from 0 to 4, without trigonometry.
double direction_number(const Vector &v)
{
  const double t = v[1] / (std::abs(v[0]) + std::abs(v[1]));
  return v[0] < 0. ? 2. - t : (v[1] < 0. ? 4. + t : t);
}

/// Unit direction from the centre of @p disk to where the edges of both cross: where @p other begins to cover
/// it going counter-clockwise (@p side = -1), or where it ends (+1).
Vector crossing(const Disk &disk, const Disk &other, const double side)
{
  const Vector d = other.center - disk.center;
  const double distance2 = d.norm_square();
  const double along =
      0.5 * (distance2 + (disk.radius - other.radius) * (disk.radius + other.radius)) / distance2;
  const double across = std::sqrt(std::max(0., disk.radius * disk.radius / distance2 - along * along));
  return Vector({along * d[0] - side * across * d[1], along * d[1] + side * across * d[0]}) / disk.radius;
}

/// All uncovered arcs of the union of @p disks.
std::vector<Arc> uncovered_arcs(const std::vector<Disk> &disks)
{
  const unsigned int n = disks.size();
  // Pairs that meet, by sweeping along the longer side of the aggregate.
  dealii::Point<2> lower = disks[0].center, upper = lower;
  double largest = 0.;
  for (const Disk &disk : disks)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      lower[d] = std::min(lower[d], disk.center[d]);
      upper[d] = std::max(upper[d], disk.center[d]);
    }
    largest = std::max(largest, disk.radius);
  }
  const unsigned int axis = upper[0] - lower[0] >= upper[1] - lower[1] ? 0 : 1;
  std::vector<unsigned int> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](const unsigned int i, const unsigned int j)
            { return disks[i].center[axis] < disks[j].center[axis]; });
  std::vector<std::pair<unsigned int, unsigned int>> pairs;
  std::vector<bool> hidden(n, false);
  for (unsigned int a = 0; a < n; ++a)
    for (unsigned int b = a + 1; b < n; ++b)
    {
      const Disk &i = disks[order[a]], &j = disks[order[b]];
      if (j.center[axis] - i.center[axis] >= i.radius + largest)
        break;
      const double distance2 = (j.center - i.center).norm_square(), sum = i.radius + j.radius;
      if (distance2 >= sum * sum)
        continue;
      const double difference = i.radius - j.radius;
      if (distance2 <= difference * difference * (1. + 1e-12))
        hidden[difference >= 0. ? order[b] : order[a]] = true;
      else
        pairs.emplace_back(order[a], order[b]);
    }
  const auto has_hidden = [&](const auto &pair) { return hidden[pair.first] || hidden[pair.second]; };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), has_hidden), pairs.end());
  std::vector<unsigned int> first(n + 1, 0);
  for (const auto &[i, j] : pairs)
  {
    ++first[i + 1];
    ++first[j + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Covered> covered(2 * pairs.size());
  std::vector<unsigned int> next(first.begin(), first.end() - 1);
  for (const auto &[i, j] : pairs)
    for (const auto &[disk, other] : {std::make_pair(i, j), std::make_pair(j, i)})
      covered[next[disk]++] = {direction_number(crossing(disks[disk], disks[other], -1.)),
                               direction_number(crossing(disks[disk], disks[other], 1.)), other};

  std::vector<Arc> arcs;
  for (unsigned int i = 0; i < n; ++i)
  {
    if (hidden[i])
      continue;
    const auto begin = covered.begin() + first[i], end = covered.begin() + first[i + 1];
    if (begin == end)
    {
      arcs.push_back({i, none, none, 4., Vector({1., 0.}), Vector({1., 0.})});
      continue;
    }
    const auto add = [&](const double length, const unsigned int from, const unsigned int to)
    {
      arcs.push_back(
          {i, from, to, length, crossing(disks[i], disks[from], 1.), crossing(disks[i], disks[to], -1.)});
    };
    std::sort(begin, end, [](const Covered &a, const Covered &b) { return a.begin < b.begin; });
    // How far the edge is covered so far, and by whom; what passes direction zero counts from the start.
    double reach = -1.;
    unsigned int by = none;
    for (auto part = begin; part != end; ++part)
      if (part->end < part->begin && part->end > reach)
        reach = part->end, by = part->by;
    const bool wraps = by != none;
    for (auto part = begin; part != end; ++part)
    {
      if (by != none && part->begin > reach)
        add(part->begin - reach, by, part->by);
      const double part_end = part->end < part->begin ? part->end + 4. : part->end;
      if (by == none || part_end > reach)
        reach = part_end, by = part->by;
    }
    if (!wraps)
      add(begin->begin + 4. - reach, by, begin->by);
  }
  return arcs;
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

  std::vector<std::pair<double, Polygon>> outer, inner;
  std::vector<bool> done(arcs.size(), false);
  for (unsigned int start = 0; start < arcs.size(); ++start)
  {
    if (done[start])
      continue;
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
      add_arc(polygon, centers[arc.disk], radii[arc.disk], arc.begin, angle);
      if (arc.from != none)
      {
        polygon.push_back(centers[arc.disk] + radii[arc.disk] * arc.end);
        add_bridge(polygon, arc, arcs[next[a]], disks, probe_radius);
      }
    }
    const double area = signed_area(polygon);
    if (area > 0.)
      outer.emplace_back(area, std::move(polygon));
    else if (holes && area < 0.)
      inner.emplace_back(area, std::move(polygon));
  }
  const auto larger = [](const auto &a, const auto &b) { return a.first > b.first; };
  std::stable_sort(outer.begin(), outer.end(), larger);
  // A hole belongs to the smallest outline around it: a fragment may lie in the hole of a larger one.
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
} // namespace softgrain
