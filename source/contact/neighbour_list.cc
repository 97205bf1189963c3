// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/contact/neighbour_list.h>

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
  bounds.take(positions, positions.size());
  return StripGrid(bounds.lower, bounds.upper, positions.size(), size);
}

/// Disks sorted by the cells of some columns of a grid, in which all of them are.
struct SortedDisks
{
  SortedDisks(const std::vector<std::array<double, 2>> &positions,
              const StripGrid &grid,
              const std::size_t first_column,
              const std::size_t end_column)
      : grid(grid), first_column(first_column)
  {
    start.assign((end_column - first_column) * grid.n_rows + 1, 0);
    std::vector<std::uint32_t> cell_of(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      cell_of[i] = cell(grid.column(positions[i]), grid.row(positions[i]));
      ++start[cell_of[i] + 1];
    }
    for (std::size_t c = 1; c < start.size(); ++c)
      start[c] += start[c - 1];
    disks.resize(positions.size());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < positions.size(); ++i)
      disks[next[cell_of[i]]++] = i;
  }

  std::size_t cell(const std::size_t column, const std::size_t row) const
  {
    return (column - first_column) * grid.n_rows + row;
  }

  const StripGrid &grid;
  const std::size_t first_column;
  std::vector<std::uint32_t> start; ///< of cells, column by column
  std::vector<std::uint32_t> disks;
};

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
  largest_distance =
      std::max(2. * largest + range.gap, group.empty() ? 0. : range.stretch * 2. * largest) + range.skin;
}

bool NeighbourList::has_moved(const std::vector<std::array<double, 2>> &positions,
                              const ImageLattice &lattice) const
{
  if (built_in.periodic != lattice.periodic)
    return true;
  // What moves as the lattice deforms comes nearer by its strain; what counts is how disks move beside that.
  double stretch[2] = {1., 1.};
  for (unsigned int d = 0; d < 2; ++d)
    if (lattice.periodic[d])
      stretch[d] = lattice.length[d] / built_in.length[d];
  const double shear = (lattice.offset - stretch[0] * built_in.offset) / built_in.length[1];
  const double strain = std::sqrt((stretch[0] - 1.) * (stretch[0] - 1.) +
                                  (stretch[1] - 1.) * (stretch[1] - 1.) + shear * shear);
  const double room = 0.5 * (range.skin - strain * largest_distance);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const double x = built_at[i][0] - built_in.lower[0], y = built_at[i][1] - built_in.lower[1];
    const double dx = positions[i][0] - lattice.lower[0] - stretch[0] * x - shear * y,
                 dy = positions[i][1] - lattice.lower[1] - stretch[1] * y;
    if (!(room > 0. && dx * dx + dy * dy < room * room))
      return true;
  }
  return false;
}

bool NeighbourList::has_moved(const std::vector<std::array<double, 2>> &positions) const
{
  const double limit = 0.25 * range.skin * range.skin;
  for (std::size_t i = 0; i < built_at.size(); ++i)
  {
    const double dx = positions[i][0] - built_at[i][0], dy = positions[i][1] - built_at[i][1];
    if (!(dx * dx + dy * dy < limit))
      return true;
  }
  return false;
}

bool NeighbourList::update(const std::vector<std::array<double, 2>> &positions, const ImageLattice &lattice)
{
  if (built_at.size() == positions.size() &&
      !(lattice.repeats() ? has_moved(positions, lattice) : has_moved(positions)))
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
  built_at = places;
  built_in = lattice;
  forget_pairs();
  if (!places.empty())
  {
    const ImagesNear copies =
        lattice.repeats() ? ImagesNear(places, lattice, largest_distance) : ImagesNear();
    const std::vector<std::array<double, 2>> &positions = lattice.repeats() ? copies.position : places;
    const StripGrid grid = grid_of(positions, largest_distance);
    list_pairs(find(positions, copies, grid, 0, grid.n_strips()), copies);
  }
  take_over_memories(old);
}

void NeighbourList::build_part(const std::vector<std::array<double, 2>> &places,
                               const std::size_t n_own,
                               const Part &part,
                               const Remembered &old)
{
  built_at.assign(places.begin(), places.begin() + n_own);
  built_in = ImageLattice();
  forget_pairs();
  const ImagesNear copies;
  list_pairs(find(places, copies, part.grid, part.first_strip, part.end_strip), copies);
  take_over_memories(old);
}

void NeighbourList::set_disks(const std::vector<double> &radii, const std::vector<std::uint32_t> &groups)
{
  radius = radii;
  if (range.stretch > 0.)
    group = groups;
}

void NeighbourList::forget_pairs()
{
  first.clear();
  second.clear();
  images.clear();
  tiles.assign(1, 0);
  colours.assign(1, 0);
}

std::vector<std::vector<NeighbourList::Pair>>
NeighbourList::find(const std::vector<std::array<double, 2>> &positions,
                    const ImagesNear &copies,
                    const StripGrid &grid,
                    const std::size_t first_strip,
                    const std::size_t end_strip) const
{
  const std::size_t n_disks = radius.size(), width = grid.width, n_rows = grid.n_rows;
  const std::size_t end_column = std::min(end_strip * width, grid.n_columns);
  const auto disk = [&](const std::size_t i) { return i < n_disks ? i : copies.source[i - n_disks]; };
  std::vector<std::vector<Pair>> found(grid.n_strips());
  if (first_strip == end_strip)
    return found;
  // The last strip reaches one column farther.
  const SortedDisks sorted(positions, grid, first_strip * width, std::min(end_column + 1, grid.n_columns));
  const auto search = [&](const std::size_t i, const std::size_t cell, std::size_t from, auto &pairs)
  {
    const double x = positions[i][0], y = positions[i][1], r = radius[disk(i)];
    for (std::size_t k = std::max<std::size_t>(from, sorted.start[cell]); k < sorted.start[cell + 1]; ++k)
    {
      const std::uint32_t j = sorted.disks[k];
      if (i >= n_disks && j >= n_disks)
        continue;
      const double dx = x - positions[j][0], dy = y - positions[j][1], sum = r + radius[disk(j)];
      double reach = sum + range.gap;
      if (!group.empty() && group[disk(i)] == group[disk(j)])
        reach = std::max(reach, range.stretch * sum);
      reach += range.skin;
      if (dx * dx + dy * dy < reach * reach)
        pairs.push_back({static_cast<std::uint32_t>(i), j});
    }
  };
  const auto search_strip = [&](const std::size_t strip)
  {
    for (std::size_t column = strip * width; column < std::min((strip + 1) * width, end_column); ++column)
      for (std::size_t row = 0; row < n_rows; ++row)
      {
        const std::size_t cell = sorted.cell(column, row);
        for (std::size_t k = sorted.start[cell]; k < sorted.start[cell + 1]; ++k)
        {
          const std::size_t i = sorted.disks[k];
          search(i, cell, k + 1, found[strip]);
          if (row + 1 < n_rows)
            search(i, cell + 1, 0, found[strip]);
          if (column + 1 == grid.n_columns)
            continue;
          for (std::size_t other = row > 0 ? row - 1 : 0; other <= std::min(row + 1, n_rows - 1); ++other)
            search(i, sorted.cell(column + 1, other), 0, found[strip]);
        }
      }
  };
  parallel_for(end_strip - first_strip, 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t strip = begin; strip < end; ++strip)
                   search_strip(first_strip + strip);
               });
  return found;
}

void NeighbourList::list_pairs(const std::vector<std::vector<Pair>> &found, const ImagesNear &copies)
{
  const std::size_t n_disks = radius.size(), n_strips = found.size();
  const bool repeats = built_in.repeats();
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
