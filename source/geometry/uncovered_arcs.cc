// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/uncovered_arcs.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace softgrain
{
namespace
{
using Vector = dealii::Tensor<1, 2>;

constexpr unsigned int none = UncoveredArc::none;

/// The part of a disk's edge that another disk covers, as directions counted from 0 to 4 for a full turn.
struct Covered
{
  double begin, end;
  unsigned int by;
};

/// Grows with the angle of @p v from 0 to 4, without trigonometry.
double direction_number(const Vector &v)
{
  const double t = v[1] / (std::abs(v[0]) + std::abs(v[1]));
  return v[0] < 0. ? 2. - t : (v[1] < 0. ? 4. + t : t);
}

/// Unit direction from the centre of @p disk to where the edges of both cross: where @p other begins to cover
/// it going counter-clockwise (@p side = -1), or where it ends (+1).
Vector crossing(const DiskOfUnion &disk, const DiskOfUnion &other, const double side)
{
  const Vector d = other.center - disk.center;
  const double distance2 = d.norm_square();
  const double along =
      0.5 * (distance2 + (disk.radius - other.radius) * (disk.radius + other.radius)) / distance2;
  const double across = std::sqrt(std::max(0., disk.radius * disk.radius / distance2 - along * along));
  return Vector({along * d[0] - side * across * d[1], along * d[1] + side * across * d[0]}) / disk.radius;
}

/// Disks whose edges cross, and those that lie in another one.
struct Meetings
{
  std::vector<std::pair<unsigned int, unsigned int>> pairs;
  std::vector<bool> hidden;
};

/// Sweeps along the longer side of the aggregate.
Meetings meetings(const std::vector<DiskOfUnion> &disks)
{
  const unsigned int n = disks.size();
  dealii::Point<2> lower = disks[0].center, upper = lower;
  double largest = 0.;
  for (const DiskOfUnion &disk : disks)
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
  Meetings met{{}, std::vector<bool>(n, false)};
  for (unsigned int a = 0; a < n; ++a)
    for (unsigned int b = a + 1; b < n; ++b)
    {
      const DiskOfUnion &i = disks[order[a]], &j = disks[order[b]];
      if (j.center[axis] - i.center[axis] >= i.radius + largest)
        break;
      const double distance2 = (j.center - i.center).norm_square(), sum = i.radius + j.radius;
      if (distance2 >= sum * sum)
        continue;
      const double difference = i.radius - j.radius;
      if (distance2 <= difference * difference * (1. + 1e-12))
        met.hidden[difference >= 0. ? order[b] : order[a]] = true;
      else
        met.pairs.emplace_back(order[a], order[b]);
    }
  const auto has_hidden = [&](const auto &pair) { return met.hidden[pair.first] || met.hidden[pair.second]; };
  met.pairs.erase(std::remove_if(met.pairs.begin(), met.pairs.end(), has_hidden), met.pairs.end());
  return met;
}

/// Adds the uncovered arcs of disk @p i, which others cover from @p begin to @p end.
void add_uncovered_arcs(const std::vector<DiskOfUnion> &disks,
                        const unsigned int i,
                        const std::vector<Covered>::iterator begin,
                        const std::vector<Covered>::iterator end,
                        std::vector<UncoveredArc> &arcs)
{
  if (begin == end)
  {
    arcs.push_back({i, none, none, 4., Vector({1., 0.}), Vector({1., 0.})});
    return;
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
} // namespace

std::vector<UncoveredArc> uncovered_arcs(const std::vector<DiskOfUnion> &disks)
{
  const unsigned int n = disks.size();
  const Meetings met = meetings(disks);
  std::vector<unsigned int> first(n + 1, 0);
  for (const auto &[i, j] : met.pairs)
  {
    ++first[i + 1];
    ++first[j + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Covered> covered(2 * met.pairs.size());
  std::vector<unsigned int> next(first.begin(), first.end() - 1);
  for (const auto &[i, j] : met.pairs)
    for (const auto &[disk, other] : {std::make_pair(i, j), std::make_pair(j, i)})
      covered[next[disk]++] = {direction_number(crossing(disks[disk], disks[other], -1.)),
                               direction_number(crossing(disks[disk], disks[other], 1.)), other};
  std::vector<UncoveredArc> arcs;
  for (unsigned int i = 0; i < n; ++i)
    if (!met.hidden[i])
      add_uncovered_arcs(disks, i, covered.begin() + first[i], covered.begin() + first[i + 1], arcs);
  return arcs;
}
} // namespace softgrain
