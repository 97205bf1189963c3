// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_place_functions_h
#define softgrain_mpm_field_place_functions_h

#include <softgrain/mpm/field/node_weights.h>

#include <deal.II/base/tensor.h>

#include <boost/container/small_vector.hpp>

#include <Eigen/Core>

#include <type_traits>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The nodal field of a body at one place, with its slopes.
 *
 * The displacement there is the sum of value times node value over the independent nodes that reach the
 * place; its gradient follows with the slopes, which are those in the configuration in which the field was
 * built. FieldNear has second derivatives.
 */
template <int dim>
struct PlaceFunctions
{
  using Vector = dealii::Tensor<1, dim>;

  /// A list, in the plane with room for as many as most places have, without an allocation. In space room for
  /// all would be more than a kilobyte of places that are never looked at.
  template <class T>
  using List = std::conditional_t<dim == 2, boost::container::small_vector<T, 16>, std::vector<T>>;

  unsigned int cell = 0;   ///< of the body, whose independent nodes these are
  List<unsigned int> node; ///< independent nodes; none: out of reach
  List<double> value;      ///< one per node
  List<Vector> slope;      ///< [1/m]

  /// The values of the nodes, dim components each, become the vector at the place.
  Vector at(const Eigen::VectorXd &nodal) const
  {
    Vector result;
    for (unsigned int k = 0; k < node.size(); ++k)
      result += value[k] * of_node(nodal, node[k]);
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
