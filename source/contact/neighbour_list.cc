// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/neighbour_list.h>
#include <softgrain/contact/pair_search.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace softgrain::contact
{
namespace
{
/// Cells and strips for @p positions. @throw ComputationError when one is not finite
StripGrid grid_of(const std::vector<std::array<double, 2>> &positions, const double size)
{
  NeighbourList::Bounds bounds;
  const std::size_t n = positions.size();
  bounds.take(positions, n);
  return StripGrid(bounds.lower, bounds.upper, n, size,
                   is_sparse(bounds.lower, bounds.upper, n, size) ? spans_of(positions, n, size)
                                                                  : std::vector<StripGrid::Span>());
}

/// Image of the disk with the higher number, as that with the lower one sees it.
ImageLattice::Image seen_from_low(const ImageLattice::Image &image, const bool low_is_first)
{
  return low_is_first ? image : ImageLattice::Image{{-image[0], -image[1]}};
}
} // namespace

/// Disks brought into the cell, and after them the images that are near to it: of two opposite ones that on
/// the right, or above.
struct NeighbourList::ImagesNear
{
  ImagesNear() = default;

  ImagesNear(const std::vector<std::array<double, 2>> &places,
             const ImageLattice &lattice,
             const double reach)
      : n(places.size())
  {
    for (const std::array<double, 2> &x : places)
    {
      ImageLattice::Image fold{};
      if (lattice.periodic[1])
        fold[1] = static_cast<int>(std::floor((x[1] - lattice.lower[1]) / lattice.length[1]));
      if (lattice.periodic[0])
        fold[0] = static_cast<int>(
            std::floor((x[0] - fold[1] * lattice.offset - lattice.lower[0]) / lattice.length[0]));
      folds.push_back(fold);
      position.push_back(moved(x, lattice.shift({{-fold[0], -fold[1]}})));
    }
    std::array<double, 2> lower = position[0], upper = position[0];
    for (const std::array<double, 2> &x : position)
      for (unsigned int d = 0; d < 2; ++d)
      {
        lower[d] = std::min(lower[d], x[d] - reach);
        upper[d] = std::max(upper[d], x[d] + reach);
      }
    // The offset is at most half a length in one of the lattices that are the same.
    const int turns = lattice.periodic[0] && lattice.periodic[1]
                          ? static_cast<int>(std::lround(lattice.offset / lattice.length[0]))
                          : 0;
    const int above = lattice.periodic[1] ? 1 : 0, beside = lattice.periodic[0] ? 1 + above : 0;
    for (int up = 0; up <= above; ++up)
      for (int right = up == 0 ? 1 : -beside; right <= beside; ++right)
      {
        const ImageLattice::Image image = {{right - turns * up, up}};
        const std::array<double, 2> way = lattice.shift(image);
        for (std::uint32_t i = 0; i < n; ++i)
        {
          const std::array<double, 2> x = moved(position[i], way);
          if (x[0] > upper[0] || x[0] < lower[0] || x[1] > upper[1] || x[1] < lower[1])
            continue;
          position.push_back(x);
          source.push_back(i);
          images.push_back(image);
        }
      }
  }

  /// Image of disk @p j, or of the disk of which it is an image, that disk @p i meets where nothing is
  /// folded.
  ImageLattice::Image image(const std::size_t i, const std::size_t j) const
  {
    const ImageLattice::Image &to = folds[j < n ? j : source[j - n]];
    ImageLattice::Image result = j < n ? ImageLattice::Image() : images[j - n];
    for (unsigned int d = 0; d < 2; ++d)
      result[d] += folds[i][d] - to[d];
    return result;
  }

  static std::array<double, 2> moved(const std::array<double, 2> &x, const std::array<double, 2> &way)
  {
    return {{x[0] + way[0], x[1] + way[1]}};
  }

  std::size_t n = 0;
  std::vector<std::array<double, 2>> position;
  std::vector<std::uint32_t> source;       ///< of the images
  std::vector<ImageLattice::Image> folds;  ///< of the disks: the copy of the cell each was in
  std::vector<ImageLattice::Image> images; ///< which images they are
};

void NeighbourList::Bounds::take(const std::vector<std::array<double, 2>> &positions, const std::size_t n)
{
  for (std::size_t i = 0; i < n; ++i)
    for (unsigned int d = 0; d < 2; ++d)
    {
      if (!std::isfinite(positions[i][d]))
        throw ComputationError("disk " + std::to_string(i) + " has no finite place");
      lower[d] = std::min(lower[d], positions[i][d]);
      upper[d] = std::max(upper[d], positions[i][d]);
    }
}

NeighbourList::NeighbourList(std::vector<double> radii,
                             std::vector<std::uint32_t> groups,
                             const Range &list_range,
                             const unsigned int n_impulses)
    : radius(std::move(radii)), group(std::move(groups)), range(list_range), memories(n_impulses)
{
  if (!group.empty() && group.size() != radius.size())
    throw InputError("neighbour list: " + std::to_string(group.size()) + " groups for " +
                     std::to_string(radius.size()) + " disks");
  if (!(range.gap >= 0.) || !(range.skin > 0.) || !(range.stretch >= 0.))
    throw InputError("neighbour list: gap and stretch must not be negative, the skin must be positive");
  double largest = 0.;
  for (const double r : radius)
    largest = std::max(largest, r);
  largest_distance = range.reach(2. * largest, !group.empty());
  choose_levels();
}

void NeighbourList::choose_levels()
{
  // Cells for large disks hold too many of those that are four times smaller, which get a level of their own.
  constexpr double step = 4.;
  levels.assign(1, 1.);
  while (true)
  {
    double next = 0.;
    for (const double r : radius)
    {
      const double reach = range.reach(2. * r, !group.empty());
      if (step * reach * levels.back() <= largest_distance)
        next = std::max(next, reach);
    }
    if (!(next > 0.))
      return;
    levels.push_back(std::floor(largest_distance / next));
  }
}

bool NeighbourList::update(const std::vector<std::array<double, 2>> &positions, const ImageLattice &lattice)
{
  const auto alone = [](const std::vector<double> &numbers)
  { return std::vector<std::vector<double>>{numbers}; };
  if (built.positions.size() == positions.size() && !is_outdated(positions, lattice, {}, alone))
    return false;
  build(positions, lattice);
  return true;
}

void NeighbourList::build(const std::vector<std::array<double, 2>> &places, const ImageLattice &lattice)
{
  if (places.size() != radius.size())
    throw InputError("neighbour list: " + std::to_string(places.size()) + " places for " +
                     std::to_string(radius.size()) + " disks");
  Remembered old{std::move(first), std::move(second), std::move(images), std::move(memories)};
  built.positions = places;
  built.lattice = lattice;
  forget_pairs();
  if (!places.empty())
  {
    const ImagesNear copies =
        lattice.repeats() ? ImagesNear(places, lattice, largest_distance) : ImagesNear();
    const std::vector<std::array<double, 2>> &positions = lattice.repeats() ? copies.position : places;
    Part all{grid_of(positions, largest_distance), 0, 0};
    all.end_strip = all.grid.n_strips();
    list_pairs(find(positions, copies, all), copies);
  }
  take_over_memories(old);
}

void NeighbourList::build_part(const Disks &disks,
                               const std::size_t n_own,
                               const Part &part,
                               const Remembered &old)
{
  radius = disks.radii;
  if (range.stretch > 0.)
    group = disks.groups;
  built.positions.assign(disks.positions.begin(), disks.positions.begin() + n_own);
  built.lattice = ImageLattice();
  forget_pairs();
  const ImagesNear copies;
  list_pairs(find(disks.positions, copies, part), copies);
  take_over_memories(old);
}

void NeighbourList::forget_pairs()
{
  first.clear();
  second.clear();
  images.clear();
  has_partner.clear();
  tiles.assign(1, 0);
  colours.assign(1, 0);
}

std::vector<std::vector<NeighbourList::Pair>> NeighbourList::find(
    const std::vector<std::array<double, 2>> &positions, const ImagesNear &copies, const Part &part)
{
  PairSearch search({positions, copies.source, radius, group}, range, levels, part);
  std::vector<std::vector<Pair>> found = search.run();
  looked_at = search.n_looked_at();
  return found;
}

void NeighbourList::list_pairs(const std::vector<std::vector<Pair>> &found, const ImagesNear &copies)
{
  const std::size_t n_disks = radius.size(), n_strips = found.size();
  const bool repeats = built.lattice.repeats();
  std::size_t n = 0;
  for (const auto &pairs : found)
    n += pairs.size();
  if (n > std::numeric_limits<std::uint32_t>::max())
    throw ComputationError("neighbour list: more pairs than can be numbered");
  first.reserve(n);
  second.reserve(n);
  std::vector<std::array<std::uint32_t, 2>> across; // the disk itself first, then the image
  for (unsigned int colour = 0; colour < 2; ++colour)
  {
    for (std::size_t strip = colour; strip < n_strips; strip += 2)
    {
      for (const auto &pair : found[strip])
      {
        if (pair[0] >= n_disks || pair[1] >= n_disks)
        {
          across.push_back({std::min(pair[0], pair[1]), std::max(pair[0], pair[1])});
          continue;
        }
        first.push_back(pair[0]);
        second.push_back(pair[1]);
        if (repeats)
          images.push_back(copies.image(pair[0], pair[1]));
      }
      tiles.push_back(first.size());
    }
    colours.push_back(tiles.size() - 1);
  }
  if (repeats)
  {
    for (const auto &pair : across)
    {
      first.push_back(pair[0]);
      second.push_back(copies.source[pair[1] - n_disks]);
      images.push_back(copies.image(pair[0], pair[1]));
    }
    tiles.push_back(first.size());
    colours.push_back(tiles.size() - 1);
  }
}

void NeighbourList::take_over_memories(const Remembered &old)
{
  memories.assign(first.size());
  // What is remembered, sorted by the disk with the lower number: a handful of entries per disk.
  std::vector<std::uint32_t> start(radius.size() + 1, 0), entries;
  for (std::size_t pair = 0; pair < old.first.size(); ++pair)
    if (old.memories.remembers(pair))
      ++start[std::min(old.first[pair], old.second[pair]) + 1];
  for (std::size_t i = 1; i < start.size(); ++i)
    start[i] += start[i - 1];
  entries.resize(start.back());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::size_t pair = 0; pair < old.first.size(); ++pair)
    if (old.memories.remembers(pair))
      entries[next[std::min(old.first[pair], old.second[pair])]++] = pair;
  for (std::size_t pair = 0; pair < first.size(); ++pair)
  {
    const std::uint32_t low = std::min(first[pair], second[pair]), high = std::max(first[pair], second[pair]);
    for (std::uint32_t k = start[low]; k < start[low + 1]; ++k)
      if (std::max(old.first[entries[k]], old.second[entries[k]]) == high &&
          (images.empty() || old.images.empty() ||
           seen_from_low(old.images[entries[k]], old.first[entries[k]] == low) ==
               seen_from_low(images[pair], first[pair] == low)))
      {
        // Impulses are scalars along n, t and the axis: the same whichever disk comes first.
        memories.set(pair, old.memories[entries[k]]);
        break;
      }
  }
}
} // namespace softgrain::contact
