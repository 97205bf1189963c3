// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_ray_h
#define softgrain_mpm_contact_ray_h

#include <softgrain/geometry/rest_surface.h>
#include <softgrain/mpm/field/body_field.h>

#include <array>

namespace softgrain::mpm
{
/**
 * @brief A line that stands in space during a step: origin + sum_i offset_i across_i + eta direction.
 *
 * The surfaces of two bodies meet it at two heights eta; the gap between them along the ray is the difference
 * of these.
 */
template <int dim>
struct Ray
{
  dealii::Point<dim> origin;                          ///< [m]
  dealii::Tensor<1, dim> direction;                   ///< unit
  std::array<dealii::Tensor<1, dim>, dim - 1> across; ///< unit, at right angles to it and to each other
  dealii::Tensor<1, dim - 1> offset;                  ///< [m]
};

/**
 * @brief Where the surface of a deformed body meets a ray, with the derivatives of its height.
 *
 * A place of the surface is x(X) = X + u(X). While nodes move, the place that lies under the ray slides along
 * the surface. With the tangents x_i = dx/da_i of the deformed surface, J_ij = across_i · x_j,
 * a = across · delta u the displacement across the ray, s = -J^-1 a is the way of the place, and
 *
 *   delta height   = w · delta u,    w = direction - sum_i slope_i across_i,  slope = J^-T (direction · x_j)
 *   delta^2 height = 2 sum_i s_i w · delta u_i + sum_ij s_i (w · x_ij) s_j
 *
 * with delta u_i and x_ij the derivatives along the tangents. w is the outward or inward normal of the
 * deformed surface, up to its length: a force at the ray acts along it. Both derivatives are exact, and sit
 * in the unknowns of this body alone.
 */
template <int dim>
struct RaySide
{
  using Vector = dealii::Tensor<1, dim>;

  bool met = false;
  SurfacePlace<dim> place;      ///< in the configuration of the grid
  double height = 0;            ///< [m]
  Vector normal;                ///< w above
  double past_end = 0;          ///< way from the place, an end of the surface, along its tangent there [m]
  PlaceFunctions<dim> function; ///< of the field at the place, once they are asked for

  /// Fills them: derivatives with regard to nodes need them.
  void find_functions(const BodyField<dim> &field)
  {
    function = field.functions_at(place.position);
    if (past_end != 0.)
      for (unsigned int i = 0; i < function.node.size(); ++i)
        function.value[i] += past_end * (function.slope[i] * place.tangent[0]);
  }

  /// delta height for the changes @p v of the nodes [m].
  double change(const Eigen::VectorXd &v) const { return normal * function.at(v); }

  /// Calls add(i, j, block) for pairs of independent nodes: delta^2 height for changes v of the nodes is the
  /// sum of v_i · block v_j over all of them. The matrix is symmetric.
  template <class F>
  void second_derivative(const F &add) const
  {
    // Displacement across the ray per displacement of a node becomes way of the place.
    for (unsigned int i = 0; i < function.node.size(); ++i)
      for (unsigned int j = 0; j < function.node.size(); ++j)
      {
        dealii::Tensor<2, dim> block = function.value[i] * function.value[j] * sliding_twice;
        for (unsigned int k = 0; k < dim - 1; ++k)
        {
          const double a = function.slope[i] * place.tangent[k] * function.value[j],
                       b = function.slope[j] * place.tangent[k] * function.value[i];
          block += a * outer_product(normal, way[k]) + b * outer_product(way[k], normal);
        }
        add(function.node[i], function.node[j], block);
      }
  }

  /// Second derivative as a matrix over the nodes of the place, dim numbers each.
  void second_derivative(Eigen::MatrixXd &matrix) const
  {
    const unsigned int n = function.node.size();
    matrix.resize(dim * n, dim * n);
    std::array<std::vector<double>, dim - 1> along; // slopes along the tangents
    for (unsigned int k = 0; k < dim - 1; ++k)
      for (unsigned int i = 0; i < n; ++i)
        along[k].push_back(function.slope[i] * place.tangent[k]);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
      {
        dealii::Tensor<2, dim> block = function.value[i] * function.value[j] * sliding_twice;
        for (unsigned int k = 0; k < dim - 1; ++k)
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int e = 0; e < dim; ++e)
              block[d][e] += along[k][i] * function.value[j] * normal[d] * way[k][e] +
                             along[k][j] * function.value[i] * way[k][d] * normal[e];
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = 0; e < dim; ++e)
            matrix(dim * i + d, dim * j + e) = block[d][e];
      }
  }

  /// Way of the place along tangent k per displacement, -sum_l (J^-1)_kl across_l.
  std::array<Vector, dim - 1> way;
  /// sum_ij way_i (w · x_ij) way_j [1/m].
  dealii::Tensor<2, dim> sliding_twice;
};

/**
 * @brief Where the ray meets a surface, by Newton's method from @p guess on, without functions of the field.
 * @param nodal displacement of the independent nodes of @p field [m]
 * @param bends whether second derivatives are found, too
 * @return one that is not met where the surface turns away from the ray, ends at a corner before it, or
 * leaves the field
 */
template <int dim>
RaySide<dim> meet(const Ray<dim> &ray,
                  const RestSurface<dim> &surface,
                  const BodyField<dim> &field,
                  const Eigen::VectorXd &nodal,
                  const SurfacePlace<dim> &guess,
                  bool bends = true);

/// The side of a ray that has left a surface at @p corner and goes on around it: beyond a convex one the
/// other side may look the same way. Not met where it does not.
RaySide<2> meet_around(const Ray<2> &ray,
                       const RestSurface<2> &surface,
                       const BodyField<2> &field,
                       const Eigen::VectorXd &nodal,
                       const SurfacePlace<2> &corner);

/// The side of a ray that has left a surface at @p corner by @p reach [m] at most, as if the surface went on
/// straight there.
RaySide<2> meet_past_end(const Ray<2> &ray,
                         const BodyField<2> &field,
                         const Eigen::VectorXd &nodal,
                         const SurfacePlace<2> &corner,
                         double reach);

/// The side of a rigid surface at a place that lies on the ray; not met where the surface stands along it.
template <int dim>
RaySide<dim> side_at(const Ray<dim> &ray, const SurfacePlace<dim> &place);

/// The place where the ray meets a rigid surface, as it is.
template <int dim>
RaySide<dim> meet(const Ray<dim> &ray, const RestSurface<dim> &surface, const SurfacePlace<dim> &guess);
} // namespace softgrain::mpm

#endif
