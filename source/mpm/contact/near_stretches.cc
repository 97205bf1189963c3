// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/near_stretches.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace softgrain::mpm
{
namespace
{
using Facing = std::vector<std::pair<unsigned int, unsigned int>>;

constexpr double pi = 3.14159265358979323846;
constexpr double opposed_within = pi / 3.; // [rad]
/// Above the 54.7 degrees by which the normals of an octant leave their mean.
constexpr double frame_within = 57. / 180. * pi; // [rad]
/// Of the sum of directions over their number: below it, they point all around.
constexpr double all_around = 0.2;

double angle_between(const double cosine)
{
  return std::acos(std::clamp(cosine, -1., 1.));
}

/// A unit vector turned towards another one, by @p by of the angle between them.
template <int dim>
dealii::Tensor<1, dim>
turned_towards(const dealii::Tensor<1, dim> &from, const dealii::Tensor<1, dim> &to, const double by)
{
  const dealii::Tensor<1, dim> across = to - (from * to) * from;
  const double norm = across.norm();
  if (norm == 0.)
    return from;
  const double angle = by * angle_between(from * to);
  return std::cos(angle) * from + std::sin(angle) / norm * across;
}

/// The direction from a sample to one that faces it, twice as long as a unit vector. A corner has all normals
/// of its cone: it turns the one it has towards the other sample, and of two corners both turn.
template <int dim>
dealii::Tensor<1, dim> direction_of(const typename SampledSurface<dim>::Sample &a,
                                    const typename SampledSurface<dim>::Sample &b)
{
  const double corners = a.corner + b.corner;
  if (corners == 0.)
    return a.normal - b.normal;
  const double angle = angle_between(-(a.normal * b.normal)), share = std::min(1., corners / angle) / corners;
  return turned_towards<dim>(a.normal, -b.normal, share * a.corner) -
         turned_towards<dim>(b.normal, -a.normal, share * b.corner);
}

/// For every sample of @p a the nearest of @p b that faces it, as (of a, of b).
/// @param ordered samples of @p b from left to right, those that come into question
template <int dim>
void add_nearest(const SampledSurface<dim> &a,
                 const std::vector<unsigned int> &of_a,
                 const SampledSurface<dim> &b,
                 const std::vector<unsigned int> &ordered,
                 const double radius,
                 const bool swapped,
                 const std::function<bool(unsigned int, unsigned int)> &may_face,
                 Facing &facing)
{
  for (const unsigned int i : of_a)
  {
    const auto &sample = a.samples[i];
    double nearest = radius, least_turned = pi;
    unsigned int best = b.samples.size();
    for (auto next = std::lower_bound(ordered.begin(), ordered.end(), sample.position[0] - radius,
                                      [&](const unsigned int j, const double x)
                                      { return b.samples[j].position[0] < x; });
         next != ordered.end() && b.samples[*next].position[0] <= sample.position[0] + radius; ++next)
    {
      const unsigned int j = *next;
      const auto &other = b.samples[j];
      const double distance = sample.position.distance(other.position), same = 1e-9 * b.spacing;
      if (distance > nearest + same)
        continue;
      const double turned = angle_between(-(sample.normal * other.normal));
      if (turned > opposed_within + sample.corner + other.corner)
        continue;
      // Both sides of a line are as near to a corner.
      if (best < b.samples.size() && distance >= nearest - same &&
          (turned > least_turned || (turned == least_turned && j > best)))
        continue;
      if (may_face && !(swapped ? may_face(j, i) : may_face(i, j)))
        continue;
      nearest = distance;
      least_turned = turned;
      best = j;
    }
    if (best < b.samples.size())
      facing.push_back(swapped ? std::make_pair(best, i) : std::make_pair(i, best));
  }
}

/// Box around samples.
template <int dim>
std::array<dealii::Point<dim>, 2> box_of(const SampledSurface<dim> &surface)
{
  std::array<dealii::Point<dim>, 2> box;
  for (unsigned int d = 0; d < dim; ++d)
  {
    box[0][d] = std::numeric_limits<double>::max();
    box[1][d] = -box[0][d];
  }
  for (const auto &sample : surface.samples)
    for (unsigned int d = 0; d < dim; ++d)
    {
      box[0][d] = std::min(box[0][d], sample.position[d]);
      box[1][d] = std::max(box[1][d], sample.position[d]);
    }
  return box;
}

/// Samples that are within @p radius of a box in every direction, from left to right.
template <int dim>
std::vector<unsigned int> near_box(const SampledSurface<dim> &surface,
                                   const std::array<dealii::Point<dim>, 2> &box,
                                   const double radius)
{
  std::vector<unsigned int> near;
  near.reserve(surface.samples.size());
  for (unsigned int i = 0; i < surface.samples.size(); ++i)
  {
    const dealii::Point<dim> &x = surface.samples[i].position;
    bool far = false;
    for (unsigned int d = 0; d < dim; ++d)
      far = far || x[d] < box[0][d] - radius || x[d] > box[1][d] + radius;
    if (!far)
      near.push_back(i);
  }
  // A stable sort would ask for memory.
  std::sort(near.begin(), near.end(),
            [&](const unsigned int i, const unsigned int j)
            {
              const double left = surface.samples[i].position[0], right = surface.samples[j].position[0];
              return left < right || (left == right && i < j);
            });
  return near;
}

/// Groups of things that have been joined.
class Groups
{
public:
  explicit Groups(const unsigned int n) : parent(n) { std::iota(parent.begin(), parent.end(), 0u); }
  unsigned int of(const unsigned int i) { return parent[i] == i ? i : parent[i] = of(parent[i]); }
  void join(const unsigned int i, const unsigned int j)
  {
    parent[std::max(of(i), of(j))] = std::min(of(i), of(j));
  }

private:
  std::vector<unsigned int> parent;
};

/// For each sample of a surface the pairs that it belongs to, one after the other.
class PairsOfSamples
{
public:
  /// @param of the sample of a pair of @p facing
  template <class SampleOf>
  PairsOfSamples(const unsigned int n_samples, const Facing &facing, const SampleOf &of)
      : first(n_samples + 1), pairs(facing.size())
  {
    for (const auto &pair : facing)
      ++first[of(pair) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<unsigned int> next(first.begin(), first.end() - 1);
    for (unsigned int k = 0; k < facing.size(); ++k)
      pairs[next[of(facing[k])]++] = k;
  }

  template <class Function>
  void for_both(const unsigned int i, const unsigned int j, const Function &function) const
  {
    for (unsigned int k = first[i]; k < first[i + 1]; ++k)
      for (unsigned int l = first[j]; l < first[j + 1]; ++l)
        function(pairs[k], pairs[l]);
  }

private:
  std::vector<unsigned int> first, pairs;
};

/// The pairs in connected parts: where samples of @p a are side by side and those that face them are near
/// each other on @p b, or the other way round.
template <int dim>
std::vector<Facing>
connected(const SampledSurface<dim> &a, const SampledSurface<dim> &b, const Facing &facing)
{
  Groups groups(facing.size());
  const double near = 2. * (a.spacing + b.spacing);
  const auto join = [&](const unsigned int k, const unsigned int l)
  {
    const auto &[a_k, b_k] = facing[k];
    const auto &[a_l, b_l] = facing[l];
    if (a.samples[a_k].position.distance(a.samples[a_l].position) <= near &&
        b.samples[b_k].position.distance(b.samples[b_l].position) <= near)
      groups.join(k, l);
  };
  const auto join_all = [&](const SampledSurface<dim> &surface, const PairsOfSamples &pairs)
  {
    for (unsigned int i = 0; i < surface.samples.size(); ++i)
      pairs.for_both(i, i, join);
    for (const auto &[i, j] : surface.neighbours)
      pairs.for_both(i, j, join);
  };
  join_all(a, PairsOfSamples(a.samples.size(), facing, [](const auto &pair) { return pair.first; }));
  join_all(b, PairsOfSamples(b.samples.size(), facing, [](const auto &pair) { return pair.second; }));
  std::map<unsigned int, Facing> parts;
  for (unsigned int k = 0; k < facing.size(); ++k)
    parts[groups.of(k)].push_back(facing[k]);
  std::vector<Facing> result;
  for (auto &[group, part] : parts)
    result.push_back(std::move(part));
  return result;
}

template <int dim>
NearStretch<dim> stretch_of(const SampledSurface<dim> &a, const SampledSurface<dim> &b, Facing facing)
{
  NearStretch<dim> stretch;
  dealii::Tensor<1, dim> sum, places;
  for (const auto &[i, j] : facing)
  {
    sum += direction_of<dim>(a.samples[i], b.samples[j]);
    places += (a.samples[i].position - dealii::Point<dim>()) + (b.samples[j].position - dealii::Point<dim>());
  }
  stretch.direction = sum.norm() > 0. ? sum / sum.norm() : a.samples[facing.front().first].normal;
  stretch.middle = dealii::Point<dim>(places / (2. * facing.size()));
  stretch.gap = std::numeric_limits<double>::max();
  for (const auto &[i, j] : facing)
    stretch.gap = std::min(stretch.gap, (b.samples[j].position - a.samples[i].position) * stretch.direction);
  stretch.facing = std::move(facing);
  return stretch;
}

/// Adds a stretch, in two parts where it turns too far.
template <int dim>
void add_parts(const SampledSurface<dim> &a,
               const SampledSurface<dim> &b,
               Facing facing,
               std::vector<NearStretch<dim>> &stretches)
{
  NearStretch<dim> whole = stretch_of(a, b, std::move(facing));
  const auto direction = [&](const std::pair<unsigned int, unsigned int> &pair)
  { return direction_of<dim>(a.samples[pair.first], b.samples[pair.second]); };
  dealii::Tensor<1, dim> sum, furthest;
  double widest = 0.;
  for (const auto &pair : whole.facing)
  {
    const dealii::Tensor<1, dim> way = direction(pair);
    const double turned = way.norm() > 0. ? angle_between(way * whole.direction / way.norm()) : 0.;
    sum += 0.5 / whole.facing.size() * way;
    if (turned > widest)
    {
      widest = turned;
      furthest = way;
    }
  }
  // Across the mean direction, towards the one that is turned furthest; all around, halves by an axis of
  // space, and these again, are their own mirror images.
  const bool closed = sum.norm() < all_around;
  dealii::Tensor<1, dim> side = furthest - (furthest * whole.direction) * whole.direction;
  if (closed)
  {
    side = 0.;
    side[0] = 1.;
  }
  Facing one, other;
  if (closed || widest > frame_within)
    for (const auto &pair : whole.facing)
      (direction(pair) * side > 0. ? one : other).push_back(pair);
  if (one.empty() || other.empty())
  {
    stretches.push_back(std::move(whole));
    return;
  }
  // A plane may part what hangs together elsewhere, and leave pieces that do not.
  for (const Facing *part : {&one, &other})
    for (Facing &piece : connected(a, b, *part))
      add_parts(a, b, std::move(piece), stretches);
}
} // namespace

template <int dim>
std::vector<NearStretch<dim>>
near_stretches(const SampledSurface<dim> &a,
               const SampledSurface<dim> &b,
               const double reach,
               const std::function<bool(unsigned int of_a, unsigned int of_b)> &may_face)
{
  // The sample that faces another one may lie to its side by as much as they are apart.
  const double radius = std::hypot(reach, 0.5 * (a.spacing + b.spacing));
  const std::vector<unsigned int> of_a = near_box(a, box_of(b), radius),
                                  of_b = near_box(b, box_of(a), radius);
  Facing facing;
  add_nearest(a, of_a, b, of_b, radius, false, may_face, facing);
  add_nearest(b, of_b, a, of_a, radius, true, may_face, facing);
  if (facing.empty())
    return {};
  std::sort(facing.begin(), facing.end());
  facing.erase(std::unique(facing.begin(), facing.end()), facing.end());
  std::vector<NearStretch<dim>> stretches;
  for (Facing &part : connected(a, b, facing))
    add_parts(a, b, std::move(part), stretches);
  return stretches;
}

template std::vector<NearStretch<2>> near_stretches(const SampledSurface<2> &,
                                                    const SampledSurface<2> &,
                                                    double,
                                                    const std::function<bool(unsigned int, unsigned int)> &);
template std::vector<NearStretch<3>> near_stretches(const SampledSurface<3> &,
                                                    const SampledSurface<3> &,
                                                    double,
                                                    const std::function<bool(unsigned int, unsigned int)> &);
} // namespace softgrain::mpm
