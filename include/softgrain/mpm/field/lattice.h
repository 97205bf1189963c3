// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_lattice_h
#define softgrain_mpm_field_lattice_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>
#include <string>

namespace softgrain::mpm
{
/**
 * @brief The background mesh that all bodies share: square cells of one size, by integer coordinates. Where
 * there are points, PointStore makes a triangulation of it.
 *
 * Nodal fields live on integer lattices whose numbering needs no table: the shape functions say which lattice
 * nodes belong to a cell.
 */
template <int dim>
class Lattice
{
public:
  using Index = std::array<int, dim>;

  /// Cells of edge @p cell_size [m] from @p lower on, as many as it takes to cover @p upper.
  Lattice(const dealii::Point<dim> &lower, const dealii::Point<dim> &upper, double cell_size);

  double cell_size() const { return h; }
  const dealii::Point<dim> &lower() const { return origin; }
  const Index &n_cells() const { return cells; }

  /// Integer coordinates of the cell that holds @p x; on a face the upper cell, on the border of the mesh
  /// that within. May lie outside of the mesh.
  Index cell_of(const dealii::Point<dim> &x) const
  {
    Index c;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double place = (x[d] - origin[d]) / h;
      c[d] = static_cast<int>(std::floor(place));
      // Both borders belong to the mesh, each with what rounding puts beyond it: mirrored, a place on the
      // lower border lies on the upper one.
      if (c[d] == cells[d] && place <= cells[d] + rounding)
        c[d] = cells[d] - 1;
      else if (c[d] == -1 && place >= -rounding)
        c[d] = 0;
    }
    return c;
  }

  /// Place of @p x in its cell @p c, every component in [0, 1] but for rounding.
  dealii::Point<dim> unit_position(const dealii::Point<dim> &x, const Index &c) const
  {
    dealii::Point<dim> xi;
    for (unsigned int d = 0; d < dim; ++d)
      xi[d] = (x[d] - origin[d]) / h - c[d];
    return xi;
  }

  bool contains(const Index &c) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (c[d] < 0 || c[d] >= cells[d])
        return false;
    return true;
  }

  /// @p x moved off the faces of its cell to 1e-10 of its edge, if it lies on one: rounding must not decide
  /// to which cell a particle belongs, or whether to any.
  dealii::Point<dim> off_faces(dealii::Point<dim> x) const
  {
    constexpr double least = 1e-10;
    const Index c = cell_of(x);
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double inside = (x[d] - origin[d]) / h - c[d];
      if (inside < least)
        x[d] = origin[d] + h * (c[d] + least);
      else if (inside > 1. - least)
        x[d] = origin[d] + h * (c[d] + 1. - least);
    }
    return x;
  }

  /// @throw ComputationError when @p x, the place of a @p thing, lies outside of the mesh
  void check_inside(const dealii::Point<dim> &x, const std::string &thing) const;

private:
  static constexpr double rounding = 1e-9; ///< of places on the border [cells]

  dealii::Point<dim> origin;
  double h;
  Index cells;
};
} // namespace softgrain::mpm

#endif
