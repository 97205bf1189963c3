// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_periodic_cell_h
#define softgrain_geometry_periodic_cell_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <vector>

namespace softgrain
{
/**
 * @brief A cell that repeats along some of its directions: every body has images, one in every copy of the
 * cell.
 *
 * Images are told by whole numbers n, one per direction: the image of a place x is x + shift(n). The cells
 * above, those along y in the plane and along z in space, may stand to the side by an offset along x, which
 * grows for ever in simple shear (Lees and Edwards, J. Phys. C 5, 1972): the lattice is the same for offsets
 * that differ by a length, so nothing is ever remapped, and the numbers of an image never change.
 */
template <int dim>
struct PeriodicCell
{
  using Image = std::array<int, dim>;

  static constexpr unsigned int up = dim - 1; ///< direction of the cells that an offset moves

  std::array<bool, dim> periodic{}; ///< along x, y and z
  dealii::Point<dim> lower;         ///< corner [m]
  std::array<double, dim> length;   ///< edges, of the directions that repeat [m]
  double offset = 0;                ///< along x of the cell above [m]

  PeriodicCell() { length.fill(1.); }

  /// Whether anything repeats.
  bool repeats() const
  {
    return std::any_of(periodic.begin(), periodic.end(), [](bool does) { return does; });
  }

  /// Vector from a body to its image @p n [m].
  dealii::Tensor<1, dim> shift(const Image &n) const
  {
    dealii::Tensor<1, dim> way;
    way[0] = n[0] * length[0] + n[up] * offset;
    for (unsigned int d = 1; d < dim; ++d)
      way[d] = n[d] * length[d];
    return way;
  }

  /// The copy of the cell in which @p x lies: x - shift(image_of(x)) lies in the cell itself.
  Image image_of(const dealii::Point<dim> &x) const;

  /// The image that is @p n as counted in the lattice whose offset is the smallest, at most half a length.
  Image from_reduced(const Image &n) const;

  /// The image above: the first cell along the direction that an offset moves.
  static Image above()
  {
    Image n{};
    n[up] = 1;
    return n;
  }

  /// Copies of the cell in which a neighbour of what lies in it may lie, itself among them, in ascending
  /// order of their last number, then of the others. Of those above there are two on each side along x,
  /// because they stand to the side.
  std::vector<Image> neighbours() const;

  /// The vector between two places or their images that is the shortest, for vectors that are short against
  /// the cell [m].
  dealii::Tensor<1, dim> shortest(const dealii::Tensor<1, dim> &way) const;
};

/// A side of a cell, or of what stands where a cell does not repeat.
template <int dim>
struct CellSide
{
  dealii::Point<dim> point;      ///< [m]
  dealii::Tensor<1, dim> normal; ///< unit, into the cell
};

/// Direction that a side stands across.
template <int dim>
unsigned int axis_of(const dealii::Tensor<1, dim> &normal)
{
  unsigned int axis = 0;
  for (unsigned int d = 1; d < dim; ++d)
    if (normal[d] * normal[d] > normal[axis] * normal[axis])
      axis = d;
  return axis;
}

/// The cell between @p sides, of which there are two in every direction that repeats.
template <int dim>
PeriodicCell<dim> make_cell(const std::vector<CellSide<dim>> &sides, const double offset)
{
  PeriodicCell<dim> cell;
  cell.offset = offset;
  std::array<double, dim> upper{};
  for (const CellSide<dim> &side : sides)
  {
    const unsigned int d = axis_of(side.normal);
    cell.periodic[d] = true;
    (side.normal[d] > 0. ? cell.lower[d] : upper[d]) = side.point[d];
  }
  for (unsigned int d = 0; d < dim; ++d)
    if (cell.periodic[d])
      cell.length[d] = upper[d] - cell.lower[d];
  return cell;
}
} // namespace softgrain

#endif
