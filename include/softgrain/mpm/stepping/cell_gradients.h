// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_cell_gradients_h
#define softgrain_mpm_stepping_cell_gradients_h

#include <softgrain/mpm/field/body_field.h>
#include <softgrain/mpm/field/lattice_box.h>
#include <softgrain/mpm/field/shape_function.h>

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <utility>

namespace softgrain::mpm
{
/// Gradients of two nodal vectors at the points of one cell: both at once, four numbers side by side in the
/// plane.
template <int dim>
class CellGradients
{
public:
  /// @param second may be null
  CellGradients(const BodyField<dim> &field,
                const unsigned int cell,
                const Eigen::VectorXd &first,
                const Eigen::VectorXd *second)
      : field(field)
  {
    const unsigned int n = field.cells().nodes_per_cell(), *nodes = field.cells().nodes(cell);
    nodal.resize(2 * dim, n);
    for (unsigned int k = 0; k < n; ++k)
    {
      nodal.col(k).template head<dim>() = first.template segment<dim>(dim * nodes[k]);
      if (second == nullptr)
        nodal.col(k).template tail<dim>().setZero();
      else
        nodal.col(k).template tail<dim>() = second->template segment<dim>(dim * nodes[k]);
    }
  }

  /// Gradients of the first and of the second at point @p p.
  std::pair<dealii::Tensor<2, dim>, dealii::Tensor<2, dim>> operator()(const unsigned int p) const
  {
    static_assert(sizeof(dealii::Tensor<1, dim>) == dim * sizeof(double));
    const Eigen::Map<const Eigen::Matrix<double, dim, Eigen::Dynamic>> slopes(
        field.at_point(p).slopes->begin_raw(), dim, nodal.cols());
    const Eigen::Matrix<double, 2 * dim, dim> both = nodal.lazyProduct(slopes.transpose());
    std::pair<dealii::Tensor<2, dim>, dealii::Tensor<2, dim>> result;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
      {
        result.first[d][e] = both(d, e);
        result.second[d][e] = both(dim + d, e);
      }
    return result;
  }

private:
  const BodyField<dim> &field;
  /// Rows up to dim: the first vector.
  Eigen::Matrix<double, 2 * dim, Eigen::Dynamic, 0, 2 * dim, power(ShapeFunction::max_nodes, dim)> nodal;
};
} // namespace softgrain::mpm

#endif
