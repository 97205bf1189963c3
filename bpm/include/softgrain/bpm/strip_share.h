// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_strip_share_h
#define softgrain_bpm_strip_share_h

#include <softgrain/base/exchange.h>
#include <softgrain/bpm/primaries.h>
#include <softgrain/contact/disk_exchanges.h>
#include <softgrain/contact/neighbour_list.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace softgrain::bpm
{
/// Primaries below which words between ranks would take longer than the work.
constexpr std::size_t fewest_to_part = 2000;

/**
 * @brief Which primaries this rank has: those in some strips of the neighbour list, side by side.
 *
 * A rank holds its own primaries in the order of their numbers, and behind them copies of those in the first
 * column of the next rank's strips, which its last tile reaches: the seam. All are shared out anew with every
 * neighbour list, about as many to each rank; what a primary carries goes with it.
 */
class StripShare
{
public:
  /// @p exchange has to stay.
  explicit StripShare(const Exchange &exchange) : exchange(exchange) {}

  const Exchange &exchange;

  std::size_t n_all() const { return n_primaries; }
  std::size_t n_own() const { return n_own_primaries; }
  std::size_t n_held() const { return n_own_primaries + n_seam; } ///< with the seam

  /// Leaves a piece of @p disks, which are all of them, here; share_out() comes next.
  void cut(Primaries &disks);

  /**
   * @brief Shares primaries out by their places, and makes the neighbour list of the own strips.
   * @param disks that are here; copies behind the own ones do not count
   * @param kept goes along; may be empty on all ranks
   * @param list whose pairs keep their memories
   */
  void share_out(Primaries &disks, Motion &kept, contact::NeighbourList &list);

  /// What all primaries have; where there are none, that cannot be seen.
  struct Carried
  {
    bool spins = false, strength = false, start = false;
  };
  const Carried &carried() const { return has; }

  /// Place of a primary among those held here, whose @p numbers these are; or none.
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  std::uint32_t place_of(std::uint32_t number, const std::vector<std::uint32_t> &numbers) const;

  /// What is told at seams after the tiles of @p colour: who has just come by tells the other.
  const contact::DiskRound &seams(const unsigned int colour) const { return rounds[colour]; }
  /// Whether the rank before this one has a copy of own primary @p i.
  bool is_at_seam(std::uint32_t i) const;
  /// The rank whose strips come before those of @p rank; none where nothing comes before.
  unsigned int before(unsigned int rank) const;

  /// End of the tiles of every rank, for both colours.
  const std::vector<std::vector<std::uint32_t>> &end_of_tiles() const { return tile_end; }
  /// Numbers of all primaries on the first rank, @p n of each, by number; nothing on others.
  std::vector<double> at_first(const double *values, unsigned int n, const Primaries &disks) const;

private:
  void choose_strips(const Primaries &disks, double cell);
  std::vector<contact::StripGrid::Span> spans_of_all(const Primaries &disks, double cell) const;
  void divide(const std::vector<double> &weight);
  unsigned int owner(std::size_t strip) const;
  unsigned int after(unsigned int rank) const;
  bool has_strips(const unsigned int rank) const { return end_strip[rank] > first_strip(rank); }
  std::size_t first_strip(const unsigned int rank) const { return rank > 0 ? end_strip[rank - 1] : 0; }
  std::vector<std::vector<double>> send_memories(const Primaries &disks,
                                                 const contact::NeighbourList &list) const;
  contact::NeighbourList::Remembered memories_of(const std::vector<std::vector<double>> &came,
                                                 const std::vector<std::uint32_t> &numbers,
                                                 unsigned int n_impulses) const;
  void carry(Primaries &disks, Motion &kept);
  void make_rounds(const Primaries &disks);

  std::size_t n_primaries = 0, n_own_primaries = 0, n_seam = 0;
  std::vector<std::size_t> n_own_of; ///< of every rank
  Carried has;
  contact::StripGrid grid;
  std::vector<std::size_t> end_strip; ///< of every rank
  std::vector<std::vector<std::uint32_t>> tile_end;
  std::array<contact::DiskRound, 2> rounds;
  std::vector<std::uint32_t> to_previous; ///< own primaries of which the rank before has copies
};

/// Tiles of @p colour that number @p owner has: first and end. @param end_of_tiles see StripShare
std::pair<std::uint32_t, std::uint32_t> tiles_of(const std::vector<std::vector<std::uint32_t>> &end_of_tiles,
                                                 unsigned int colour,
                                                 unsigned int owner);
} // namespace softgrain::bpm

#endif
