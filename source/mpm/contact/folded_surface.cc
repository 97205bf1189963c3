// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/turning.h>
#include <softgrain/mpm/contact/folded_surface.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double longer_along = 1.3;    ///< way along the outline over the distance across, at least
constexpr double shortest_along = 2.;   ///< way along the outline [spacings]
constexpr double deepest_overlap = 0.5; ///< of places that face each other [spacings]

/// A loop of samples, which follow each other in the list.
struct Loop
{
  unsigned int begin, end;
};

std::vector<Loop> loops_of(const SampledSurface<2> &surface)
{
  std::vector<Loop> loops;
  for (const auto &[i, j] : surface.neighbours)
    if (j <= i) // from the last to the first
      loops.push_back({j, i + 1});
  return loops;
}

/// Angle by which the normal turns from one sample to another, anticlockwise [rad].
double turning(const SampledSurface<2>::Sample &from, const SampledSurface<2>::Sample &to)
{
  return std::atan2(from.normal[0] * to.normal[1] - from.normal[1] * to.normal[0], from.normal * to.normal);
}
} // namespace

bool is_folded(const SampledSurface<2> &surface)
{
  const std::vector<Loop> loops = loops_of(surface);
  return std::any_of(loops.begin(), loops.end(),
                     [&](const Loop &loop)
                     {
                       const unsigned int n = loop.end - loop.begin;
                       return may_meet_itself(n,
                                              [&](const unsigned int k) {
                                                return turning(surface.samples[loop.begin + k],
                                                               surface.samples[loop.begin + (k + 1) % n]);
                                              });
                     });
}

std::vector<NearStretch<2>> stretches_of_fold(const SampledSurface<2> &surface, const double reach)
{
  std::vector<double> along(surface.samples.size(), 0.),
      round(along);                               // of the loop: to a sample, and all [m]
  std::vector<unsigned int> number(along.size()); // of the loop
  const std::vector<Loop> loops = loops_of(surface);
  for (unsigned int l = 0; l < loops.size(); ++l)
  {
    double way = 0.;
    for (unsigned int i = loops[l].begin; i < loops[l].end; ++i)
    {
      along[i] = way;
      number[i] = l;
      const unsigned int next = i + 1 < loops[l].end ? i + 1 : loops[l].begin;
      way += surface.samples[i].position.distance(surface.samples[next].position);
    }
    std::fill(round.begin() + loops[l].begin, round.begin() + loops[l].end, way);
  }
  const auto may_face = [&](const unsigned int i, const unsigned int j)
  {
    if (i >= j || number[i] != number[j])
      return false;
    const dealii::Tensor<1, 2> across = surface.samples[j].position - surface.samples[i].position;
    const double way = std::min(along[j] - along[i], round[i] - (along[j] - along[i])),
                 least = -deepest_overlap * surface.spacing;
    return way > std::max(shortest_along * surface.spacing, longer_along * across.norm()) &&
           across * surface.samples[i].normal > least && -(across * surface.samples[j].normal) > least;
  };
  return near_stretches<2>(surface, surface, reach, may_face);
}
} // namespace softgrain::mpm
