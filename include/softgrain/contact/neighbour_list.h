// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_neighbour_list_h
#define softgrain_contact_neighbour_list_h

#include <softgrain/contact/image_lattice.h>
#include <softgrain/contact/pair_memory.h>
#include <softgrain/contact/strip_grid.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief Pairs of disks that are near each other, found with a grid of cells and kept until a disk has moved
 * by half the skin (Verlet).
 *
 * A disk, or a group that moves as one, which had no others near it when the list was made and has none now,
 * may go farther: one that flies about alone does not make the list anew in every step.
 *
 * Pairs are ordered by tiles: vertical strips at least as wide as the longest pair, so that a tile reaches no
 * farther than the next strip and tiles of one colour (every other one) share no disk. Loops over pairs may
 * therefore run over the tiles of a colour at the same time and add to their disks without locks, with the
 * same answer for any number of threads. Each pair carries what its contact remembers from step to step.
 *
 * Where disks repeat, their places are anywhere in the lattice and pairs are with images; those across a side
 * of the cell are one tile, which has a colour of its own.
 *
 * One of several owners may have the pairs of some strips alone: build_part(). Its list has the tiles of all
 * strips, those of others without pairs.
 */
class NeighbourList
{
public:
  /// How near a pair is that belongs to the list.
  struct Range
  {
    double gap = 0;     ///< distance between the edges of any two disks [m]
    double stretch = 0; ///< in a group also those with centres nearer than this times the sum of the radii
    double skin = 0;    ///< added to both, room to move before the list is made anew [m]

    /// Distance of the centres [m] below which disks are listed, whose radii have this @p sum.
    double reach(const double sum, const bool same_group) const
    {
      const double apart = sum + gap;
      return (same_group ? std::max(apart, stretch * sum) : apart) + skin;
    }
  };

  /// Least and largest coordinates of disks [m].
  struct Bounds
  {
    static constexpr double far = std::numeric_limits<double>::max();
    std::array<double, 2> lower{{far, far}}, upper{{-far, -far}};

    /// The first @p n of @p positions too. @throw ComputationError when one is not finite
    void take(const std::vector<std::array<double, 2>> &positions, std::size_t n);
  };

  /// Disks that may be others than before.
  struct Disks
  {
    const std::vector<std::array<double, 2>> &positions;
    const std::vector<double> &radii;
    const std::vector<std::uint32_t> &groups;
  };

  /// Some strips of a grid.
  struct Part
  {
    StripGrid grid;
    std::size_t first_strip = 0, end_strip = 0;
  };

  /// Pairs that a list had before it was made anew, and what they remember.
  struct Remembered
  {
    std::vector<std::uint32_t> first, second;
    std::vector<ImageLattice::Image> images; ///< empty when nothing repeats
    PairMemory memories;
  };

  NeighbourList() = default;

  /**
   * @param radii of the disks [m]
   * @param groups of the disks, or empty: no stretch then
   * @param range what belongs to the list
   * @param n_impulses that a pair remembers
   * @throw InputError when sizes do not fit or a range is not positive.
   */
  NeighbourList(std::vector<double> radii,
                std::vector<std::uint32_t> groups,
                const Range &range,
                unsigned int n_impulses = 3);

  /**
   * @brief Makes the list anew if a disk has moved too far since it was made; memories of pairs survive.
   * @return whether it was made anew.
   */
  bool update(const std::vector<std::array<double, 2>> &positions, const ImageLattice &lattice = {});

  /// Makes the list anew. @throw ComputationError when a position is not finite.
  void build(const std::vector<std::array<double, 2>> &positions, const ImageLattice &lattice = {});

  /**
   * @brief Makes the list of some strips anew.
   *
   * Of all disks of all strips, in their order, there are those of the own strips, and behind them those in
   * the first column of the next one. Pairs have the order of a list of all.
   * @param disks where these are [m], their radii [m] and groups
   * @param n_own disks in the own strips
   * @param part the own strips of the grid of all disks
   * @param old what is remembered, of these disks
   */
  void build_part(const Disks &disks, std::size_t n_own, const Part &part, const Remembered &old);

  /// Tells all owners some numbers, as many on each. @return those of all, in the order of the owners
  using Tell = std::function<std::vector<std::vector<double>>(const std::vector<double> &)>;

  /**
   * @brief Whether disks have moved too far for the list; the same for all owners.
   *
   * The answer depends on the places now and on those for which the list was made, on nothing in between: a
   * run that is restarted makes its lists in the same steps.
   * @param positions of the disks [m]
   * @param lattice in which they are now
   * @param numbers of the disks among those of all owners; empty where all are here
   * @param tell called the same number of times by all owners
   */
  bool is_outdated(const std::vector<std::array<double, 2>> &positions,
                   const ImageLattice &lattice,
                   const std::vector<std::uint32_t> &numbers,
                   const Tell &tell);

  /// Pairs whose distance was looked at when the list was made: what that costs.
  std::uint64_t n_looked_at() const { return looked_at; }

  /// Size of a cell of the grid [m].
  double cell_size() const { return largest_distance; }

  /// Places and lattice for which a list was made.
  struct Origin
  {
    std::vector<std::array<double, 2>> positions; ///< [m]
    ImageLattice lattice;
  };
  /// Together with memory() all that a restart needs.
  const Origin &origin() const { return built; }

  /// Image of b(pair) that a(pair) is near to.
  ImageLattice::Image image(const std::size_t pair) const
  {
    return images.empty() ? ImageLattice::Image() : images[pair];
  }

  std::size_t n_pairs() const { return first.size(); }
  std::uint32_t a(const std::size_t pair) const { return first[pair]; }
  std::uint32_t b(const std::size_t pair) const { return second[pair]; }

  /// Tiles of a colour `c` are [colour_start()[c], colour_start()[c + 1]), pairs of tile t [tile_start()[t],
  /// …).
  const std::vector<std::uint32_t> &tile_start() const { return tiles; }
  const std::vector<std::uint32_t> &colour_start() const { return colours; }

  PairMemory &memory() { return memories; }
  const PairMemory &memory() const { return memories; }

private:
  using Pair = std::array<std::uint32_t, 2>;
  struct ImagesNear;
  struct Mover;
  struct Moves;
  bool come_near(const Moves &moves, std::vector<Mover> &movers, const Tell &tell);
  void mark_partners();
  void choose_levels();
  void forget_pairs();
  /// Pairs of every strip; images count on after the disks.
  std::vector<std::vector<Pair>>
  find(const std::vector<std::array<double, 2>> &positions, const ImagesNear &copies, const Part &part);
  void list_pairs(const std::vector<std::vector<Pair>> &found, const ImagesNear &copies);
  void take_over_memories(const Remembered &old);

  std::vector<double> radius;
  std::vector<std::uint32_t> group;
  Range range;
  double largest_distance = 0; ///< of the centres of a listed pair
  std::vector<double> levels;  ///< by size of disks, how many times smaller their cells are
  Origin built;
  std::vector<std::uint32_t> first, second;
  std::vector<ImageLattice::Image> images; ///< of the second; empty when nothing repeats
  PairMemory memories;
  std::vector<std::uint32_t> tiles, colours;
  std::uint64_t looked_at = 0;
  std::vector<char> has_partner; ///< whether a disk has a pair with one of another group; filled when asked
};
} // namespace softgrain::contact

#endif
