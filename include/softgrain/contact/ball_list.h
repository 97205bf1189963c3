// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_ball_list_h
#define softgrain_contact_ball_list_h

#include <softgrain/contact/neighbour_list.h>

#include <array>
#include <cstdint>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief Pairs of balls that are near each other, found with linked cells and kept until a ball has moved by
 * half the skin (Verlet): NeighbourList in space, without images and owners.
 *
 * Pairs are ordered by tiles, as there: slabs across x at least as wide as the longest pair, so that tiles of
 * one colour (every other one) share no ball. Of a pair the first has the smaller number, so that what it
 * remembers keeps its sign. What pairs remember are as many numbers each as the list is told.
 */
class BallList
{
public:
  using Place = std::array<double, 3>;
  using Pair = std::array<std::uint32_t, 2>;

  BallList() = default;

  /**
   * @param radii of the balls [m]
   * @param groups of the balls, or empty: no stretch then
   * @param range what belongs to the list
   * @param n_numbers that a pair remembers
   */
  BallList(std::vector<double> radii,
           std::vector<std::uint32_t> groups,
           const NeighbourList::Range &range,
           unsigned int n_numbers);

  /// Makes the list anew if a ball has moved too far since it was made; memories of pairs survive.
  /// @return whether it was made anew.
  bool update(const std::vector<Place> &positions);

  /// Makes the list anew. @throw ComputationError when a position is not finite.
  void build(const std::vector<Place> &positions);

  std::size_t n_pairs() const { return pairs.size(); }
  std::uint32_t a(const std::size_t pair) const { return pairs[pair][0]; }
  std::uint32_t b(const std::size_t pair) const { return pairs[pair][1]; }

  /// Tiles of a colour `c` are [colour_start()[c], colour_start()[c + 1]), pairs of tile t [tile_start()[t],
  /// …).
  const std::vector<std::uint32_t> &tile_start() const { return tiles; }
  const std::vector<std::uint32_t> &colour_start() const { return colours; }
  unsigned int n_tiles() const { return tiles.empty() ? 0 : tiles.size() - 1; }

  /// What a pair remembers.
  double *memory(const std::size_t pair) { return &memories[pair * width]; }
  const double *memory(const std::size_t pair) const { return &memories[pair * width]; }
  /// Memories of all pairs, one after the other.
  std::vector<double> &all_memories() { return memories; }
  const std::vector<double> &all_memories() const { return memories; }
  unsigned int n_numbers() const { return width; }

  /// Places for which the list was made [m]: together with all_memories() all that a restart needs.
  const std::vector<Place> &build_positions() const { return built_at; }

private:
  using Cell = std::array<std::size_t, 3>;
  struct Cells;
  bool is_near(std::uint32_t i, std::uint32_t j) const;
  void find_in_slab(const Cells &cells, std::size_t slab, std::vector<Pair> &found) const;
  void list_pairs(const std::vector<std::vector<Pair>> &of_slab);
  void take_over_memories(const std::vector<Pair> &old_pairs, const std::vector<double> &old_memories);

  std::vector<double> radius;
  std::vector<std::uint32_t> group;
  NeighbourList::Range range;
  unsigned int width = 1;
  double largest_distance = 0.; ///< of the centres of a listed pair [m]
  std::vector<Place> built_at;
  std::vector<Pair> pairs;
  std::vector<double> memories;
  std::vector<std::uint32_t> tiles, colours;
};
} // namespace softgrain::contact

#endif
