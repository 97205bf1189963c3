// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_field_nodes_h
#define softgrain_mpm_field_field_nodes_h

#include <deal.II/base/point.h>

#include <cstdint>
#include <vector>

namespace softgrain::mpm
{
template <int>
class BodyField;

/// The nodes of a body on the lattice, in the order of the lattice.
template <int dim>
class FieldNodes
{
public:
  unsigned int n() const { return place.size(); }
  /// Place of node @p i [m]; for B-splines the place of its control point.
  const dealii::Point<dim> &position(const unsigned int i) const { return place[i]; }
  /// Lattice number of node @p i, the same for all bodies.
  std::int64_t lattice_number(const unsigned int i) const { return number[i]; }

private:
  friend class BodyField<dim>;
  std::vector<dealii::Point<dim>> place;
  std::vector<std::int64_t> number;
};
} // namespace softgrain::mpm

#endif
