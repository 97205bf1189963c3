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

  /// Integer coordinates of the cell that holds @p x; on a face the upper cell. May lie outside of the mesh.
  Index cell_of(const dealii::Point<dim> &x) const
  {
    Index c;
    for (unsigned int d = 0; d < dim; ++d)
      c[d] = static_cast<int>(std::floor((x[d] - origin[d]) / h));
    return c;
  }

  /// Place of @p x in its cell @p c, every component in [0, 1).
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
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double place = (x[d] - origin[d]) / h, first = std::floor(place), inside = place - first;
      if (inside < least)
        x[d] = origin[d] + h * (first + least);
      else if (inside > 1. - least)
        x[d] = origin[d] + h * (first + 1. - least);
    }
    return x;
  }

  /// @throw ComputationError when @p x, the place of a @p thing, lies outside of the mesh
  void check_inside(const dealii::Point<dim> &x, const std::string &thing) const;

private:
  dealii::Point<dim> origin;
  double h;
  Index cells;
};
} // namespace softgrain::mpm

#endif
