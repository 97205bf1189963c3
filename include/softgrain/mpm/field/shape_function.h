// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_shape_function_h
#define softgrain_mpm_field_shape_function_h

#include <softgrain/base/registry.h>

#include <deal.II/base/polynomial.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief One-dimensional functions whose tensor products interpolate on the lattice, in any number of
 * dimensions.
 *
 * Nodes are counted from the lower face of the mesh, nodes_per_edge() to an edge of a cell. Cell c reaches
 * the nodes `c * nodes_per_edge() + first_node()` and n_nodes() - 1 more in every direction, so all points of
 * a cell share their nodes whatever the kind of function. CellFunctions makes the products.
 *
 * Most members are polynomials in a cell and give polynomials(); only others override evaluate().
 */
class ShapeFunction
{
public:
  static constexpr unsigned int max_nodes = 4;
  using Values = std::array<double, max_nodes>;
  using Polynomial = dealii::Polynomials::Polynomial<double>;

  virtual ~ShapeFunction() = default;

  /// Nodes per direction that a cell reaches.
  virtual unsigned int n_nodes() const = 0;
  /// The first of them, relative to the first node of the cell.
  virtual int first_node() const = 0;
  /// Nodes per direction for every cell.
  virtual unsigned int nodes_per_edge() const { return 1; }
  /// Place of node 0 relative to the lower face of cell 0, in cells: 0 for vertices, 1/2 for cell centres.
  virtual double node_shift() const = 0;
  /// Largest total degree per direction that is reproduced exactly; also the degree of extrapolation.
  virtual unsigned int degree() const = 0;

  /// Whether the functions are nowhere negative, so that lumped masses are positive wherever points are.
  virtual bool nowhere_negative() const { return true; }
  /// Least number of points per cell and direction that feel every deformation of the cell.
  virtual unsigned int least_points() const { return 1; }
  /// Whether cells of different sizes may meet. They may where only the nodes on a face have functions that
  /// are not zero there.
  virtual bool may_hang() const { return false; }
  /// Whether slopes are the same on both sides of a face between cells.
  virtual bool smooth() const { return false; }
  /// Whether the values depend on the extent of the point (GIMP).
  virtual bool uses_extent() const { return false; }

  /// The functions of a cell in one direction, one per node, of the place in the cell in [0, 1]; empty where
  /// they are no polynomials there.
  virtual std::vector<Polynomial> polynomials() const { return {}; }

  /**
   * @brief Values and slopes at @p xi in [0, 1] of a cell, asked of members without polynomials().
   * @param[in]  xi          place in the cell, in cells
   * @param[in]  half_extent half the edge of the point's domain, in cells
   * @param[out] values      dimensionless
   * @param[out] slopes      per cell edge
   */
  virtual void evaluate(double xi, double half_extent, Values &values, Values &slopes) const;
};

/// The member of the family that `Material points/Shape function` names. @throw InputError for another name.
std::unique_ptr<ShapeFunction> create_shape_function(const std::string &name);
} // namespace softgrain::mpm

template <>
softgrain::Registry<softgrain::mpm::ShapeFunction> &
softgrain::Registry<softgrain::mpm::ShapeFunction>::instance();

#endif
