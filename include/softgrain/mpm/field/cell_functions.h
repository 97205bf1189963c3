// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_cell_functions_h
#define softgrain_mpm_field_cell_functions_h

#include <softgrain/mpm/field/shape_function.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/tensor_product_polynomials.h>

#include <array>
#include <optional>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The shape functions of one cell: tensor products of a ShapeFunction, first coordinate fastest.
 *
 * Where the function is a polynomial in a cell they are deal.II's TensorProductPolynomials; for `linear` and
 * `quadratic` these are the functions of FE_Q in lexicographic order.
 */
template <int dim>
class CellFunctions
{
public:
  explicit CellFunctions(const ShapeFunction &shape);

  using Offset = std::array<int, dim>;

  /// Functions of a cell.
  unsigned int n() const { return offsets.size(); }
  /// Place of node @p k on the lattice of nodes, from the first node of the cell.
  const Offset &offset(const unsigned int k) const { return offsets[k]; }

  /**
   * @brief Values and slopes at a place; as with deal.II, a vector without elements is not filled.
   * @param[in]  unit        place in the cell, every component in [0, 1]
   * @param[in]  half_extent half the edge of the point's domain, in cells
   * @param[out] values      n() or none
   * @param[out] slopes      n() or none, per cell edge
   */
  void evaluate(const dealii::Point<dim> &unit,
                double half_extent,
                std::vector<double> &values,
                std::vector<dealii::Tensor<1, dim>> &slopes) const;

  /// Functions of one dimension for every direction, with their first and second derivatives [per cell edge,
  /// and squared]; the functions of the cell and their derivatives are products of these.
  using Factors = std::array<std::array<ShapeFunction::Values, 3>, dim>;
  /// Factors at a place without extent. A kink of the functions has no second derivative: there it is that of
  /// one side. Nothing is allocated.
  Factors factors(const dealii::Point<dim> &unit) const;

  /// Nodes that the points of a cell always reach and that carry its polynomial; GIMP's outer ring is reached
  /// by points near a face alone, and may have no mass however full the cell is.
  const std::vector<unsigned int> &core() const { return core_nodes; }
  /// Value at @p place on the lattice of nodes, from the first node of the cell, of the polynomial that is
  /// one at core node
  /// @p k and zero at the others.
  double extrapolate(unsigned int k, const dealii::Point<dim> &place) const;

private:
  const ShapeFunction *shape;
  std::vector<Offset> offsets;
  std::vector<unsigned int> core_nodes;
  std::optional<dealii::TensorProductPolynomials<dim>> products;
  /// Coefficients of the polynomials, from the constant on; none where functions are no polynomials.
  std::vector<std::array<double, ShapeFunction::max_nodes>> coefficients;
  std::vector<ShapeFunction::Polynomial>
      extrapolation; ///< of the core nodes in one direction, over their numbers
};
} // namespace softgrain::mpm

#endif
