// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Dynamics that looks back on a step: rows know the places at its ends alone, and what moves far
// may have gone through something in between.
#include <softgrain/bpm/dynamics.h>

#include <algorithm>
#include <cmath>

namespace softgrain::bpm
{
using Vector = dealii::Tensor<1, 2>;

namespace
{
/// A way over the smallest diameter. Two disks that both move no farther, and do not overlap at the ends of a
/// step, overlap by at most 0.02 diameters in between.
constexpr double short_way = 0.2;

/// The way of a disk in a step.
struct Moved
{
  std::array<double, 2> from, way; ///< [m]
  double radius;                   ///< [m]
  std::uint32_t body;
  bool free;

  double lower(const unsigned int d) const { return from[d] + std::min(0., way[d]) - radius; }
  double upper(const unsigned int d) const { return from[d] + std::max(0., way[d]) + radius; }
};

/// The deeper of two.
void note(const Overlap &other, Overlap &deepest)
{
  if (other.depth > deepest.depth)
    deepest = other;
}

/// How deep two disks have been in each other between the ends of their ways.
Overlap overlap_between(const Moved &a, const Moved &b)
{
  if (!a.free && !b.free)
    return {};
  if (a.lower(1) > b.upper(1) || b.lower(1) > a.upper(1))
    return {};
  const std::array<double, 2> x = {a.from[0] - b.from[0], a.from[1] - b.from[1]},
                              u = {a.way[0] - b.way[0], a.way[1] - b.way[1]};
  const double square = u[0] * u[0] + u[1] * u[1];
  const double nearest = -(x[0] * u[0] + x[1] * u[1]);
  if (nearest <= 0. || nearest >= square)
    return {};
  const double share = nearest / square;
  return {a.radius + b.radius - std::hypot(x[0] + share * u[0], x[1] + share * u[1]), a.body,
          Overlap::With::body, b.body, dealii::Point<2>(a.from[0], a.from[1])};
}

/// Deepest overlap of all pairs on their way. Seen from their mean motion few disks are fast, and only pairs
/// with one of them are looked at.
Overlap deepest_of(std::vector<Moved> &all, const double limit)
{
  std::array<double, 2> mean{};
  for (const Moved &one : all)
    for (unsigned int d = 0; d < 2; ++d)
      mean[d] += one.way[d] / all.size();
  std::vector<Moved> fast, slow;
  double widest = 0.;
  for (Moved &one : all)
  {
    for (unsigned int d = 0; d < 2; ++d)
      one.way[d] -= mean[d];
    if (std::hypot(one.way[0], one.way[1]) > limit)
      fast.push_back(one);
    else
    {
      slow.push_back(one);
      widest = std::max(widest, one.upper(0) - one.lower(0));
    }
  }
  if (fast.empty())
    return {};
  const auto by_place = [](const Moved &a, const Moved &b) { return a.lower(0) < b.lower(0); };
  std::sort(fast.begin(), fast.end(), by_place);
  std::sort(slow.begin(), slow.end(), by_place);
  Overlap deepest;
  for (std::size_t i = 0; i < fast.size(); ++i)
  {
    for (std::size_t j = i + 1; j < fast.size() && fast[j].lower(0) <= fast[i].upper(0); ++j)
      note(overlap_between(fast[i], fast[j]), deepest);
    auto other = std::lower_bound(slow.begin(), slow.end(), fast[i].lower(0) - widest,
                                  [](const Moved &one, const double x) { return one.lower(0) < x; });
    for (; other != slow.end() && other->lower(0) <= fast[i].upper(0); ++other)
      note(overlap_between(fast[i], *other), deepest);
  }
  return deepest;
}
} // namespace

Overlap Dynamics::deepest_overlap(const bool bodies_apart) const
{
  const std::size_t n = primaries.size(), first_at_obstacle = rows.size() - obstacle_rows.size();
  Overlap found;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    if (-gap[row] <= found.depth)
      continue;
    const std::uint32_t a = rows.a[row], b = rows.b[row];
    if (bodies_apart && b < n && primaries.body[a] == primaries.body[b])
      continue;
    found = {-gap[row], primaries.body[a], Overlap::With::body, 0,
             dealii::Point<2>(primaries.position[a][0], primaries.position[a][1])};
    if (b < n)
      found.other = primaries.body[b];
    else if (row < first_at_obstacle)
    {
      found.with = Overlap::With::wall;
      found.other = b - n;
    }
    else
    {
      found.with = Overlap::With::obstacle;
      found.other = obstacle_rows[row - first_at_obstacle].obstacle;
    }
  }
  return deepest_of_all_ranks(found);
}

Overlap Dynamics::deepest_of_all_ranks(const Overlap &here) const
{
  if (!share)
    return here;
  Overlap found;
  for (const std::vector<double> &n :
       share->exchange.of_all({here.depth, static_cast<double>(here.body), static_cast<double>(here.with),
                               static_cast<double>(here.other), here.place[0], here.place[1]}))
    note({n[0], static_cast<std::uint32_t>(n[1]), static_cast<Overlap::With>(static_cast<int>(n[2])),
          static_cast<std::uint32_t>(n[3]), dealii::Point<2>(n[4], n[5])},
         found);
  return found;
}

Overlap Dynamics::deepest_on_the_way(const double dt) const
{
  double farthest = 0.;
  for (std::size_t i = 0; i < n_own(); ++i)
    farthest = std::max(farthest, dt * std::hypot(primaries.velocity[i][0], primaries.velocity[i][1]));
  if (share)
    for (const std::vector<double> &other : share->exchange.of_all({farthest}))
      farthest = std::max(farthest, other[0]);
  const double limit = short_way * smallest;
  Overlap deepest;
  if (farthest > limit)
    deepest = share ? deepest_of_ranks(dt, limit) : deepest_of_disks(dt, limit);
  if (obstacles != nullptr)
    note(deepest_in_obstacles(dt), deepest);
  return deepest;
}

Overlap Dynamics::deepest_of_disks(const double dt, const double limit) const
{
  std::vector<Moved> all(primaries.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const std::array<double, 2> &x = primaries.position[i], &v = primaries.velocity[i];
    all[i] = {{x[0] - dt * v[0], x[1] - dt * v[1]},
              {dt * v[0], dt * v[1]},
              primaries.radius[i],
              primaries.body[i],
              inverse_mass[i] > 0.};
  }
  const Overlap found = deepest_of(all, limit);
  if (!cell)
    return found;
  // Pairs across the sides of a cell are not looked at: there no disk may go far. The ways are relative now.
  for (const Moved &one : all)
    if (std::hypot(one.way[0], one.way[1]) > limit)
      return {smallest, one.body, Overlap::With::body, one.body, dealii::Point<2>(one.from[0], one.from[1])};
  return found;
}

Overlap Dynamics::deepest_of_ranks(const double dt, const double limit) const
{
  std::vector<double> free(primaries.size());
  for (std::size_t i = 0; i < free.size(); ++i)
    free[i] = inverse_mass[i] > 0. ? 1. : 0.;
  const std::vector<double> bodies_here(primaries.body.begin(), primaries.body.end());
  // The first one looks at all, in the order that they have where one owns all.
  const std::vector<double> x = share->at_first(primaries.position.data()->data(), 2, primaries),
                            v = share->at_first(primaries.velocity.data()->data(), 2, primaries),
                            r = share->at_first(primaries.radius.data(), 1, primaries),
                            f = share->at_first(free.data(), 1, primaries),
                            b = share->at_first(bodies_here.data(), 1, primaries);
  Overlap deepest;
  if (share->exchange.first())
  {
    std::vector<Moved> all(r.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = {{x[2 * i] - dt * v[2 * i], x[2 * i + 1] - dt * v[2 * i + 1]},
                {dt * v[2 * i], dt * v[2 * i + 1]},
                r[i],
                static_cast<std::uint32_t>(b[i]),
                f[i] > 0.};
    deepest = deepest_of(all, limit);
  }
  return deepest_of_all_ranks(deepest);
}

Overlap Dynamics::deepest_in_obstacles(const double dt) const
{
  Overlap deepest;
  for (std::size_t o = 0; o < obstacles->size(); ++o)
  {
    const ObstacleMotion<2> &way = (*obstacles)[o].way;
    const double own_way = feet->farthest_way(o);
    for (std::size_t i = 0; i < primaries.size(); ++i)
    {
      const std::array<double, 2> &x = primaries.position[i], &v = primaries.velocity[i];
      // As short_way, of a disk and a line.
      const double r = primaries.radius[i], apart = 2. * short_way * r;
      if (inverse_mass[i] == 0. || dt * std::hypot(v[0], v[1]) + own_way <= apart)
        continue;
      const dealii::Point<2> from = way.start.drawn({x[0] - dt * v[0], x[1] - dt * v[1]});
      const Vector gone = way.end.drawn({x[0], x[1]}) - from;
      const double length = gone.norm();
      if (feet->distance(o, from, length + r) > length + r)
        continue;
      const auto n = static_cast<std::size_t>(std::ceil(length / apart));
      for (std::size_t k = 1; k < n; ++k)
        note({r - feet->distance(o, from + (1. * k / n) * gone, r), primaries.body[i],
              Overlap::With::obstacle, static_cast<std::uint32_t>(o), dealii::Point<2>(x[0], x[1])},
             deepest);
    }
  }
  return deepest;
}
} // namespace softgrain::bpm
