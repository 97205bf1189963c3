// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_cell_levels_h
#define softgrain_mpm_field_cell_levels_h

#include <softgrain/mpm/field/lattice.h>

#include <functional>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Which cells of the lattice are one cell for a body: small near contact, large elsewhere.
 *
 * The cells of the lattice are the smallest. A cell of level l is a block of 2^l of them per direction, and
 * begins at a multiple of 2^l. Cells that share a face, an edge or a corner differ by one level at most, so
 * that what a node hangs on does not hang itself.
 */
template <int dim>
class CellLevels
{
public:
  using Index = typename Lattice<dim>::Index;

  /// Whether a cell of some level [> 0] between two corners [m] is to be cut into cells of the next level.
  using Cut = std::function<bool(
      const dealii::Point<dim> &lower, const dealii::Point<dim> &upper, unsigned int level)>;

  /**
   * @param lattice      whose cells are the smallest
   * @param lower, upper box around the body; cells more than one of the largest outside of it are of the
   *                     highest level [m]
   * @param highest      level of the largest cells
   * @param cut          asked from the largest cells down
   */
  CellLevels(const Lattice<dim> &lattice,
             const dealii::Point<dim> &lower,
             const dealii::Point<dim> &upper,
             unsigned int highest,
             const Cut &cut);

  /// Level of the largest cells.
  unsigned int highest() const { return highest_level; }
  /// Level of the cell that holds cell @p c of the lattice.
  unsigned int level(const Index &c) const;
  /// Cells of the lattice along its edge.
  int edge(const Index &c) const { return 1 << level(c); }
  /// The first cell of the lattice in cell @p c.
  Index first(const Index &c) const;

private:
  std::size_t offset(const Index &c) const;
  void cut_cell(const Index &first);
  void balance();

  unsigned int highest_level;
  Index origin, last;                ///< first and last cell of the lattice in the box
  std::vector<unsigned char> levels; ///< of them
};
} // namespace softgrain::mpm

#endif
