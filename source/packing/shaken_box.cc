// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/preparation.h>
#include <softgrain/packing/shaken_box.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace softgrain
{
namespace
{
/// Share that the box may lose in a round, at most and at first.
constexpr double largest_shrinkage = 0.02;
/// Rounds in which the box loses less than this count as jammed.
constexpr unsigned int patience = 400;
constexpr double least_progress = 1e-3;
} // namespace

ShakenBox::ShakenBox(std::vector<ConvexGrain> grains, const Place &half)
    : list(std::move(grains)), edges(half)
{
  for (const ConvexGrain &grain : list)
    mean += grain.radius() / list.size();
  step = mean;
}

void ShakenBox::find_neighbours(const double way)
{
  std::vector<std::uint32_t> order(list.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](const std::uint32_t i, const std::uint32_t j) {
                     return list[i].center()[0] - list[i].radius() < list[j].center()[0] - list[j].radius();
                   });
  neighbours.assign(list.size(), {});
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    const ConvexGrain &one = list[order[k]];
    for (std::size_t l = k + 1; l < order.size(); ++l)
    {
      const ConvexGrain &other = list[order[l]];
      if (other.center()[0] - other.radius() > one.center()[0] + one.radius() + 2. * way)
        break;
      if (one.center().distance(other.center()) > one.radius() + other.radius() + 2. * way)
        continue;
      neighbours[order[k]].push_back(order[l]);
      neighbours[order[l]].push_back(order[k]);
    }
  }
}

bool ShakenBox::fits(const ConvexGrain &grain) const
{
  for (unsigned int d = 0; d < 2; ++d)
    for (const double sign : {-1., 1.})
    {
      if (sign * grain.center()[d] + grain.radius() <= edges[d])
        continue;
      ConvexGrain::Vector out;
      out[d] = sign;
      if (grain.support(out) * out > edges[d])
        return false;
    }
  return true;
}

bool ShakenBox::free(const std::size_t i, const ConvexGrain &moved) const
{
  return fits(moved) && std::none_of(neighbours[i].begin(), neighbours[i].end(),
                                     [&](const std::uint32_t j) { return touch(moved, list[j]); });
}

void ShakenBox::shake(Uniform &random)
{
  find_neighbours(2. * step); // a way along both axes
  std::size_t moved = 0;
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    ConvexGrain trial = list[i];
    const double x = 2. * random() - 1., y = 2. * random() - 1., turn = 2. * random() - 1.;
    trial.put(trial.center() + step * ConvexGrain::Vector({x, y}), trial.angle() + step / mean * turn);
    if (!free(i, trial))
      continue;
    list[i] = trial;
    ++moved;
  }
  // About a third of all moves should succeed.
  step = std::clamp(step * (3 * moved > list.size() ? 1.1 : 0.9), 1e-5 * mean, 0.5 * mean);
}

bool ShakenBox::scale(const double factor)
{
  const std::vector<ConvexGrain> before = list;
  const Place edges_before = edges;
  for (ConvexGrain &grain : list)
    grain.put(factor * grain.center(), grain.angle());
  for (unsigned int d = 0; d < 2; ++d)
    edges[d] *= factor;
  find_neighbours(0.);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!fits(list[i]) ||
        std::any_of(neighbours[i].begin(), neighbours[i].end(),
                    [&](const std::uint32_t j) { return j > i && touch(list[i], list[j]); }))
    {
      list = before;
      edges = edges_before;
      return false;
    }
  return true;
}

bool ShakenBox::shrink(const double end, Uniform &random)
{
  double shrinkage = largest_shrinkage, remembered = edges[0];
  Preparation telling("the packing", list.size());
  const double begin = edges[0], way = std::log(begin / end);
  for (unsigned int round = 1; edges[0] > end * (1. + 1e-12); ++round)
  {
    shake(random);
    // As much as there is room for: half as much, and again, until it fits.
    bool shrunk = false;
    for (unsigned int attempt = 0; attempt < 4 && !shrunk; ++attempt)
    {
      shrunk = scale(std::max(end / edges[0], 1. - shrinkage));
      if (!shrunk)
        shrinkage *= 0.5;
    }
    telling.reach(std::log(begin / edges[0]) / way);
    shrinkage = std::clamp(shrunk ? 1.5 * shrinkage : shrinkage, 1e-7, largest_shrinkage);
    if (round % patience == 0)
    {
      if (edges[0] > (1. - least_progress) * remembered)
        return false;
      remembered = edges[0];
    }
  }
  return true;
}
} // namespace softgrain
