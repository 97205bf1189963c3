// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_shape_function_h
#define softgrain_mpm_field_shape_function_h

#include <softgrain/base/registry.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <string>

namespace softgrain::mpm
{
/**
 * @brief One-dimensional functions whose tensor products interpolate on the lattice.
 *
 * A cell reaches the nodes `first_node() ... first_node() + n_nodes() - 1` relative to its own index in every
 * direction, so all points of a cell share their nodes whatever the kind of function.
 */
class ShapeFunction
{
public:
  static constexpr unsigned int max_nodes = 4;
  using Values = std::array<double, max_nodes>;

  virtual ~ShapeFunction() = default;

  /// Nodes per direction that a cell reaches.
  virtual unsigned int n_nodes() const = 0;
  /// Lattice index of the first of them, relative to the cell.
  virtual int first_node() const = 0;
  /// Place of node 0 relative to the lower face of cell 0, in cells: 0 for vertices, 1/2 for cell centres.
  virtual double node_shift() const = 0;
  /// Largest total degree per direction that is reproduced exactly; also the degree of extrapolation.
  virtual unsigned int degree() const = 0;
  /// Whether the values depend on the extent of the point (GIMP).
  virtual bool uses_extent() const { return false; }

  /**
   * @brief Values and slopes at @p xi in [0, 1] of a cell.
   * @param[in]  xi          place in the cell, in cells
   * @param[in]  half_extent half the edge of the point's domain, in cells (used by GIMP only)
   * @param[out] values      dimensionless
   * @param[out] slopes      per cell edge
   */
  virtual void evaluate(double xi, double half_extent, Values &values, Values &slopes) const = 0;
};

/// The member of the family that `Material points/Shape function` names. @throw InputError for another name.
std::unique_ptr<ShapeFunction> create_shape_function(const std::string &name);
} // namespace softgrain::mpm

template <>
softgrain::Registry<softgrain::mpm::ShapeFunction> &
softgrain::Registry<softgrain::mpm::ShapeFunction>::instance();

#endif
