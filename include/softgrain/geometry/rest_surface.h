// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_rest_surface_h
#define softgrain_geometry_rest_surface_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace softgrain
{
/**
 * @brief A place on the surface of a body, and how the surface runs there.
 *
 * A little way (a_1, ..., a_{dim-1}) along the tangents leads to
 * position + sum_i a_i tangent_i - 1/2 sum_ij a_i bend_ij a_j normal, to second order. So all that follows
 * from first and second derivatives is the same in the plane and in space, and for every kind of surface.
 */
template <int dim>
struct SurfacePlace
{
  dealii::Point<dim> position;                         ///< [m]
  std::array<dealii::Tensor<1, dim>, dim - 1> tangent; ///< unit, at right angles to each other
  dealii::Tensor<1, dim> normal;                       ///< unit, outward
  dealii::Tensor<2, dim - 1> bend;                     ///< of the surface, positive where it is convex [1/m]
  /// How the surface itself knows the place: for an outline the marker before it and how far it is beyond
  /// that, along the curve's parameter [m].
  unsigned int piece = 0;
  double along = 0.;
  bool at_edge = false; ///< the surface ends there, or has a corner
};

/**
 * @brief The surface of a body in the configuration of its grid.
 */
template <int dim>
class RestSurface
{
public:
  virtual ~RestSurface() = default;

  /// The place that lies about @p way [m], a component per tangent, from @p place: exactly on the surface,
  /// about so far. It goes to an edge or a corner and no further.
  virtual SurfacePlace<dim> move(const SurfacePlace<dim> &place,
                                 const dealii::Tensor<1, dim - 1> &way) const = 0;

  /// A place at an edge or a corner as the surface beyond it has it.
  virtual SurfacePlace<dim> beyond_edge(const SurfacePlace<dim> &place) const { return place; }
};
} // namespace softgrain

#endif
