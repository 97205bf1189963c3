// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_pair_search_h
#define softgrain_contact_pair_search_h

#include <softgrain/contact/fine_cells.h>
#include <softgrain/contact/neighbour_list.h>
#include <softgrain/contact/strip_grid.h>

#include <array>
#include <cstdint>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief Finds the pairs of a NeighbourList in the cells of a grid.
 *
 * The largest disks are in the cells of the grid. Those that are at least four times smaller, for which these
 * cells hold too many, are in FineCells of a size of their own, and so on. A disk looks for
 * those of its size in half of the cells around, and for larger ones in all of them.
 *
 * The order of pairs does not depend on how many strips are searched here.
 */
class PairSearch
{
public:
  using Pair = std::array<std::uint32_t, 2>;

  /// Disks, some of which may be images of others: these come last.
  struct Disks
  {
    const std::vector<std::array<double, 2>> &positions; ///< with images [m]
    const std::vector<std::uint32_t> &sources;           ///< of the images
    const std::vector<double> &radius;                   ///< of the disks themselves [m]
    const std::vector<std::uint32_t> &group;             ///< or empty
  };

  /**
   * @param disks all that are here
   * @param range of pairs
   * @param factors by level: so many cells of disks of this level are in a cell of the grid
   * @param part whose cells are as large as the reach of two of the largest disks; its grid has to stay
   */
  PairSearch(const Disks &disks,
             const NeighbourList::Range &range,
             const std::vector<double> &factors,
             const NeighbourList::Part &part);

  /// Pairs by strips, of all strips.
  std::vector<std::vector<Pair>> run();

  /// Pairs whose distance was looked at.
  std::uint64_t n_looked_at() const { return looked_at; }

private:
  /// Pairs of one strip, and what it took.
  struct Found
  {
    std::vector<Pair> pairs;
    std::uint64_t looked_at = 0;
  };

  std::size_t disk(const std::size_t i) const
  {
    return i < disks.radius.size() ? i : disks.sources[i - disks.radius.size()];
  }
  std::size_t coarse_cell(const std::size_t column, const std::size_t row) const
  {
    return (column - first_column) * grid.n_rows + row;
  }
  unsigned int level(double radius) const;
  void sort_coarse(const std::vector<std::uint32_t> &members);
  void look(std::size_t i, std::uint32_t j, Found &found) const;
  void look_in(std::size_t i, std::size_t cell, std::size_t from, Found &found) const;
  template <class Work>
  void for_rows_around(std::size_t row, const Work &work) const;
  void search_coarse(std::size_t strip, Found &found) const;
  void search_fine(std::size_t i, std::size_t strip, Found &found) const;

  const Disks disks;
  const NeighbourList::Range range;
  const std::vector<double> &factors;
  const StripGrid &grid;
  const std::size_t first_strip, end_strip, first_column, end_column;
  std::vector<std::uint32_t> start, sorted; ///< of coarse cells, column by column
  std::vector<unsigned char> levels;        ///< of all; empty where all are coarse
  std::vector<FineCells> fine;              ///< by level; the first is empty
  std::vector<std::vector<std::uint32_t>>
      fine_of_strip; ///< small disks of a strip; the first columns of the next behind
  std::uint64_t looked_at = 0;
};
} // namespace softgrain::contact

#endif
