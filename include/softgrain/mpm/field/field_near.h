// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_field_near_h
#define softgrain_mpm_field_field_near_h

#include <softgrain/mpm/field/body_field.h>
#include <softgrain/mpm/field/cell_functions.h>

#include <boost/container/small_vector.hpp>

#include <Eigen/Core>

#include <array>

namespace softgrain::mpm
{
/**
 * @brief What a nodal field of a body is at one place after the other, with two derivatives.
 *
 * Places in one cell share what the nodes of that cell have, so a search along a surface costs little.
 */
template <int dim>
class FieldNear
{
public:
  using Vector = dealii::Tensor<1, dim>;

  /// @param nodal dim values for each independent node of the field, which must outlive this object
  FieldNear(const BodyField<dim> &field, const Eigen::VectorXd &nodal) : field(field), nodal(nodal) {}

  /// Fills what follows for a place. @return whether a node of the body reaches it
  bool look_at(const dealii::Point<dim> &x);
  /// Fills second derivatives at the place that was looked at.
  void find_curvature();

  double cell_size() const { return field.cell_size(); }

  Vector value;
  /// How the value changes along @p direction [per m].
  Vector along(const Vector &direction) const
  {
    Vector result;
    for (unsigned int d = 0; d < dim; ++d)
      result += direction[d] * slope[d];
    return result;
  }
  /// Second change of the field along @p one and @p other [per m^2], after find_curvature().
  Vector along(const Vector &one, const Vector &other) const
  {
    Vector result;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        result += one[d] * other[e] * curvature[d][e];
    return result;
  }

private:
  const BodyField<dim> &field;
  const Eigen::VectorXd &nodal;
  unsigned int cell = static_cast<unsigned int>(-1);
  double edge_length = 0.;                                        ///< of the cell [m]
  typename CellFunctions<dim>::Factors factors;                   ///< at the place
  boost::container::small_vector<Vector, dim == 2 ? 9 : 27> node; ///< of the cell
  std::array<Vector, dim> slope;
  std::array<std::array<Vector, dim>, dim> curvature;
};
} // namespace softgrain::mpm

#endif
