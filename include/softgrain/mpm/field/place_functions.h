// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_place_functions_h
#define softgrain_mpm_field_place_functions_h

#include <softgrain/mpm/field/node_weights.h>

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The nodal field of a body at one place, with its first two derivatives.
 *
 * The displacement there is the sum of value times node value over the independent nodes that reach the
 * place; its gradient and its second gradient follow with the slopes and the curvatures. All derivatives are
 * those in the configuration in which the field was built.
 */
template <int dim>
struct PlaceFunctions
{
  using Vector = dealii::Tensor<1, dim>;

  unsigned int cell = 0;                         ///< of the body, whose independent nodes these are
  std::vector<unsigned int> node;                ///< independent nodes; none: out of reach
  std::vector<double> value;                     ///< one per node
  std::vector<Vector> slope;                     ///< [1/m]
  std::vector<dealii::Tensor<2, dim>> curvature; ///< [1/m^2]

  /// The values of the nodes, dim components each, become the vector at the place.
  Vector at(const Eigen::VectorXd &nodal) const
  {
    Vector result;
    for (unsigned int k = 0; k < node.size(); ++k)
      result += value[k] * of_node(nodal, node[k]);
    return result;
  }

  /// How that vector changes along @p direction [per m].
  Vector along(const Eigen::VectorXd &nodal, const Vector &direction) const
  {
    Vector result;
    for (unsigned int k = 0; k < node.size(); ++k)
      result += (slope[k] * direction) * of_node(nodal, node[k]);
    return result;
  }

  /// Its second change, along @p one and @p other [per m^2].
  Vector along(const Eigen::VectorXd &nodal, const Vector &one, const Vector &other) const
  {
    Vector result;
    for (unsigned int k = 0; k < node.size(); ++k)
      result += (one * (curvature[k] * other)) * of_node(nodal, node[k]);
    return result;
  }

  static Vector of_node(const Eigen::VectorXd &nodal, const unsigned int i)
  {
    Vector result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = nodal[dim * i + d];
    return result;
  }
};
} // namespace softgrain::mpm

#endif
