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
  bool free;

  double lower(const unsigned int d) const { return from[d] + std::min(0., way[d]) - radius; }
  double upper(const unsigned int d) const { return from[d] + std::max(0., way[d]) + radius; }
};

/// How deep two disks have been in each other between the ends of their ways [m].
double overlap_between(const Moved &a, const Moved &b)
{
  if (!a.free && !b.free)
    return 0.;
  if (a.lower(1) > b.upper(1) || b.lower(1) > a.upper(1))
    return 0.;
  const std::array<double, 2> x = {a.from[0] - b.from[0], a.from[1] - b.from[1]},
                              u = {a.way[0] - b.way[0], a.way[1] - b.way[1]};
  const double square = u[0] * u[0] + u[1] * u[1];
  const double nearest = -(x[0] * u[0] + x[1] * u[1]);
  if (nearest <= 0. || nearest >= square)
    return 0.;
  const double share = nearest / square;
  return std::max(0., a.radius + b.radius - std::hypot(x[0] + share * u[0], x[1] + share * u[1]));
}

/// Deepest overlap of all pairs on their way. Seen from their mean motion few disks are fast, and only pairs
/// with one of them are looked at.
double deepest_of(std::vector<Moved> &all, const double limit)
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
    return 0.;
  const auto by_place = [](const Moved &a, const Moved &b) { return a.lower(0) < b.lower(0); };
  std::sort(fast.begin(), fast.end(), by_place);
  std::sort(slow.begin(), slow.end(), by_place);
  double deepest = 0.;
  for (std::size_t i = 0; i < fast.size(); ++i)
  {
    for (std::size_t j = i + 1; j < fast.size() && fast[j].lower(0) <= fast[i].upper(0); ++j)
      deepest = std::max(deepest, overlap_between(fast[i], fast[j]));
    auto other = std::lower_bound(slow.begin(), slow.end(), fast[i].lower(0) - widest,
                                  [](const Moved &one, const double x) { return one.lower(0) < x; });
    for (; other != slow.end() && other->lower(0) <= fast[i].upper(0); ++other)
      deepest = std::max(deepest, overlap_between(fast[i], *other));
  }
  return deepest;
}
} // namespace

double Dynamics::deepest_on_the_way(const double dt) const
{
  double farthest = 0.;
  for (std::size_t i = 0; i < n_own(); ++i)
    farthest = std::max(farthest, dt * std::hypot(primaries.velocity[i][0], primaries.velocity[i][1]));
  if (share)
    for (const std::vector<double> &other : share->of_ranks().of_all({farthest}))
      farthest = std::max(farthest, other[0]);
  const double limit = short_way * smallest;
  double deepest = 0.;
  if (farthest > limit)
    deepest = share ? deepest_of_ranks(dt, limit) : deepest_of_disks(dt, limit);
  if (obstacles != nullptr)
    deepest = std::max(deepest, deepest_in_obstacles(dt));
  return deepest;
}

double Dynamics::deepest_of_disks(const double dt, const double limit) const
{
  std::vector<Moved> all(primaries.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const std::array<double, 2> &x = primaries.position[i], &v = primaries.velocity[i];
    all[i] = {{x[0] - dt * v[0], x[1] - dt * v[1]},
              {dt * v[0], dt * v[1]},
              primaries.radius[i],
              inverse_mass[i] > 0.};
  }
  const double found = deepest_of(all, limit);
  if (!cell)
    return found;
  // Pairs across the sides of a cell are not looked at: there no disk may go far. The ways are relative now.
  for (const Moved &one : all)
    if (std::hypot(one.way[0], one.way[1]) > limit)
      return smallest;
  return found;
}

double Dynamics::deepest_of_ranks(const double dt, const double limit) const
{
  std::vector<double> free(primaries.size());
  for (std::size_t i = 0; i < free.size(); ++i)
    free[i] = inverse_mass[i] > 0. ? 1. : 0.;
  // The first rank looks at all, in the order that they have without ranks.
  const std::vector<double> x = share->at_first(primaries.position.data()->data(), 2, primaries),
                            v = share->at_first(primaries.velocity.data()->data(), 2, primaries),
                            r = share->at_first(primaries.radius.data(), 1, primaries),
                            f = share->at_first(free.data(), 1, primaries);
  double deepest = 0.;
  if (share->of_ranks().first())
  {
    std::vector<Moved> all(r.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = {{x[2 * i] - dt * v[2 * i], x[2 * i + 1] - dt * v[2 * i + 1]},
                {dt * v[2 * i], dt * v[2 * i + 1]},
                r[i],
                f[i] > 0.};
    deepest = deepest_of(all, limit);
  }
  for (const std::vector<double> &other : share->of_ranks().of_all({deepest}))
    deepest = std::max(deepest, other[0]);
  return deepest;
}

double Dynamics::deepest_in_obstacles(const double dt) const
{
  double deepest = 0.;
  for (std::size_t o = 0; o < obstacles->size(); ++o)
  {
    const ObstacleMotion &way = (*obstacles)[o].way;
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
        deepest = std::max(deepest, r - feet->distance(o, from + (1. * k / n) * gone, r));
    }
  }
  return deepest;
}
} // namespace softgrain::bpm
