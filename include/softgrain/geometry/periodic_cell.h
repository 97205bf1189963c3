// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_periodic_cell_h
#define softgrain_geometry_periodic_cell_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace softgrain
{
/**
 * @brief A cell that repeats along x, y or both: every body has images, one in every copy of the cell.
 *
 * Images are told by two whole numbers n: the image of a place x is x + shift(n). The cells above may stand
 * to the side by an offset, which grows for ever in simple shear (Lees and Edwards, J. Phys. C 5, 1972): the
 * lattice is the same for offsets that differ by a length, so nothing is ever remapped, and the numbers of an
 * image never change.
 */
struct PeriodicCell
{
  using Image = std::array<int, 2>;

  std::array<bool, 2> periodic{};       ///< along x, y
  dealii::Point<2> lower;               ///< corner [m]
  std::array<double, 2> length{{1, 1}}; ///< width and height, of the directions that repeat [m]
  double offset = 0;                    ///< along x of the cell above [m]

  /// Whether anything repeats.
  bool repeats() const { return periodic[0] || periodic[1]; }

  /// From a body to its image @p n [m].
  dealii::Tensor<1, 2> shift(const Image &n) const
  {
    return dealii::Tensor<1, 2>({n[0] * length[0] + n[1] * offset, n[1] * length[1]});
  }

  /// The copy of the cell in which @p x lies: x - shift(image_of(x)) lies in the cell itself.
  Image image_of(const dealii::Point<2> &x) const;

  /// The image that is @p n as counted in the lattice whose offset is the smallest, at most half a length.
  Image from_reduced(const Image &n) const;

  /// The vector between two places or their images that is the shortest, for vectors that are short against
  /// the cell [m].
  dealii::Tensor<1, 2> shortest(const dealii::Tensor<1, 2> &way) const;
};

/// A side of a cell, or of what stands where a cell does not repeat.
struct CellSide
{
  dealii::Point<2> point;      ///< [m]
  dealii::Tensor<1, 2> normal; ///< unit, into the cell
};

/// Direction that a side stands across: 0 or 1.
inline unsigned int axis_of(const dealii::Tensor<1, 2> &normal)
{
  return normal[1] * normal[1] > normal[0] * normal[0] ? 1 : 0;
}

/// The cell between @p sides, of which there are two in every direction that repeats.
template <typename Sides>
PeriodicCell make_cell(const Sides &sides, const double offset)
{
  PeriodicCell cell;
  cell.offset = offset;
  std::array<double, 2> upper{};
  for (const CellSide &side : sides)
  {
    const unsigned int d = axis_of(side.normal);
    cell.periodic[d] = true;
    (side.normal[d] > 0. ? cell.lower[d] : upper[d]) = side.point[d];
  }
  for (unsigned int d = 0; d < 2; ++d)
    if (cell.periodic[d])
      cell.length[d] = upper[d] - cell.lower[d];
  return cell;
}
} // namespace softgrain

#endif
