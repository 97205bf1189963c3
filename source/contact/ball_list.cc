// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/contact/ball_list.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace softgrain::contact
{
namespace
{
/// Cells at most, for each ball and beside: balls far from each other get wider ones.
constexpr double cells_of_a_ball = 8., cells_beside = 1000.;

double square_of_distance(const BallList::Place &a, const BallList::Place &b)
{
  double sum = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    sum += (a[d] - b[d]) * (a[d] - b[d]);
  return sum;
}
} // namespace

/// Balls sorted by the cells of a grid around all of them.
struct BallList::Cells
{
  std::array<std::size_t, 3> n{{1, 1, 1}};
  std::vector<std::uint32_t> start, sorted;

  /// @param least width of a cell [m]
  Cells(const std::vector<Place> &positions, double least)
  {
    Place lower = positions[0], upper = positions[0];
    for (std::size_t i = 0; i < positions.size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
      {
        if (!std::isfinite(positions[i][d]))
          throw ComputationError("ball " + std::to_string(i) + " has no finite position");
        lower[d] = std::min(lower[d], positions[i][d]);
        upper[d] = std::max(upper[d], positions[i][d]);
      }
    const double most = cells_of_a_ball * positions.size() + cells_beside;
    std::array<double, 3> number;
    for (;; least *= 1.25)
    {
      for (unsigned int d = 0; d < 3; ++d)
        number[d] = std::max(1., std::floor((upper[d] - lower[d]) / least));
      if (number[0] * number[1] * number[2] <= most)
        break;
    }
    for (unsigned int d = 0; d < 3; ++d)
      n[d] = static_cast<std::size_t>(number[d]);
    std::vector<std::uint32_t> cell(positions.size());
    start.assign(n[0] * n[1] * n[2] + 1, 0);
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      Cell at;
      for (unsigned int d = 0; d < 3; ++d)
        at[d] = n[d] == 1 ? 0
                          : std::min(n[d] - 1, static_cast<std::size_t>((positions[i][d] - lower[d]) /
                                                                        (upper[d] - lower[d]) * n[d]));
      cell[i] = index(at);
      ++start[cell[i] + 1];
    }
    for (std::size_t c = 0; c + 1 < start.size(); ++c)
      start[c + 1] += start[c];
    sorted.resize(positions.size());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < positions.size(); ++i)
      sorted[next[cell[i]]++] = i;
  }

  std::size_t index(const Cell &at) const { return (at[0] * n[1] + at[1]) * n[2] + at[2]; }
};

BallList::BallList(std::vector<double> radii,
                   std::vector<std::uint32_t> groups,
                   const NeighbourList::Range &pair_range,
                   const unsigned int n_numbers)
    : radius(std::move(radii)), group(std::move(groups)), range(pair_range), width(n_numbers)
{
  if (!(range.skin > 0.) || !(range.gap >= 0.) || (!group.empty() && group.size() != radius.size()))
    throw InputError("list of balls: the range is not positive, or groups do not fit");
  const double largest = radius.empty() ? 0. : *std::max_element(radius.begin(), radius.end());
  largest_distance = range.reach(2. * largest, !group.empty());
}

bool BallList::update(const std::vector<Place> &positions)
{
  const double most = 0.25 * range.skin * range.skin;
  bool outdated = built_at.size() != positions.size();
  for (std::size_t i = 0; i < positions.size() && !outdated; ++i)
    outdated = !(square_of_distance(positions[i], built_at[i]) <= most); // takes what is not a number
  if (outdated)
    build(positions);
  return outdated;
}

bool BallList::is_near(const std::uint32_t i, const std::uint32_t j) const
{
  const double reach = range.reach(radius[i] + radius[j], !group.empty() && group[i] == group[j]);
  return square_of_distance(built_at[i], built_at[j]) < reach * reach;
}

void BallList::find_in_slab(const Cells &cells, const std::size_t slab, std::vector<Pair> &found) const
{
  const auto look = [&](const std::uint32_t i, const std::uint32_t begin, const std::uint32_t end)
  {
    for (std::uint32_t k = begin; k < end; ++k)
      if (const std::uint32_t j = cells.sorted[k]; is_near(i, j))
        found.push_back({{std::min(i, j), std::max(i, j)}});
  };
  const std::array<std::size_t, 3> &n = cells.n;
  for (std::size_t y = 0; y < n[1]; ++y)
    for (std::size_t z = 0; z < n[2]; ++z)
    {
      const std::size_t own = cells.index({{slab, y, z}});
      // Half of the cells around: those that come later.
      std::vector<std::size_t> others;
      for (std::size_t x = slab; x < std::min(n[0], slab + 2); ++x)
        for (std::size_t v = y == 0 ? 0 : y - 1; v < std::min(n[1], y + 2); ++v)
          for (std::size_t w = z == 0 ? 0 : z - 1; w < std::min(n[2], z + 2); ++w)
            if (const std::size_t other = cells.index({{x, v, w}}); other > own)
              others.push_back(other);
      for (std::uint32_t k = cells.start[own]; k < cells.start[own + 1]; ++k)
      {
        look(cells.sorted[k], k + 1, cells.start[own + 1]);
        for (const std::size_t other : others)
          look(cells.sorted[k], cells.start[other], cells.start[other + 1]);
      }
    }
}

void BallList::build(const std::vector<Place> &positions)
{
  built_at = positions;
  const std::vector<Pair> old_pairs = std::move(pairs);
  const std::vector<double> old_memories = std::move(memories);
  std::vector<std::vector<Pair>> of_slab;
  if (!positions.empty())
  {
    const Cells cells(positions, largest_distance);
    of_slab.resize(cells.n[0]);
    parallel_for(of_slab.size(), 1,
                 [&](const std::size_t begin, const std::size_t end)
                 {
                   for (std::size_t slab = begin; slab < end; ++slab)
                     find_in_slab(cells, slab, of_slab[slab]);
                 });
  }
  list_pairs(of_slab);
  take_over_memories(old_pairs, old_memories);
}

void BallList::list_pairs(const std::vector<std::vector<Pair>> &of_slab)
{
  pairs.clear();
  tiles.assign(1, 0);
  colours.assign(1, 0);
  for (const std::size_t first : {0, 1})
  {
    for (std::size_t slab = first; slab < of_slab.size(); slab += 2)
    {
      pairs.insert(pairs.end(), of_slab[slab].begin(), of_slab[slab].end());
      tiles.push_back(pairs.size());
    }
    colours.push_back(tiles.size() - 1);
  }
}

void BallList::take_over_memories(const std::vector<Pair> &old_pairs, const std::vector<double> &old_memories)
{
  memories.assign(pairs.size() * width, 0.);
  const auto remembers = [&](const std::size_t pair)
  {
    return std::any_of(&old_memories[pair * width], &old_memories[pair * width] + width,
                       [](const double number) { return number != 0.; });
  };
  // Old pairs that remember something, by their first ball.
  std::vector<std::uint32_t> start(radius.size() + 1, 0), kept;
  std::vector<std::uint32_t> old;
  for (std::size_t pair = 0; pair < old_pairs.size(); ++pair)
    if (remembers(pair))
    {
      old.push_back(pair);
      ++start[old_pairs[pair][0] + 1];
    }
  for (std::size_t i = 0; i + 1 < start.size(); ++i)
    start[i + 1] += start[i];
  kept.resize(old.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (const std::uint32_t pair : old)
    kept[next[old_pairs[pair][0]]++] = pair;
  for (std::size_t pair = 0; pair < pairs.size(); ++pair)
    for (std::uint32_t k = start[pairs[pair][0]]; k < start[pairs[pair][0] + 1]; ++k)
      if (old_pairs[kept[k]][1] == pairs[pair][1])
        std::copy_n(&old_memories[kept[k] * width], width, &memories[pair * width]);
}
} // namespace softgrain::contact
