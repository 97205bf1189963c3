// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_near_stretches_h
#define softgrain_mpm_contact_near_stretches_h

#include <softgrain/geometry/rest_surface.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <functional>
#include <utility>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief A surface as it is now, at places about half a cell apart.
 */
template <int dim>
struct SampledSurface
{
  struct Sample
  {
    dealii::Point<dim> position;   ///< now [m]
    dealii::Tensor<1, dim> normal; ///< unit, outward
    /// Half the angle between the normals of both sides where the surface has a corner, else 0 [rad].
    double corner = 0.;
    SurfacePlace<dim> place; ///< in the configuration of the grid
  };
  std::vector<Sample> samples;
  std::vector<std::pair<unsigned int, unsigned int>> neighbours; ///< samples that lie side by side, once each
  double spacing = 0.;                                           ///< of neighbours, at most [m]
};

/**
 * @brief A connected part of two surfaces where they are near each other, face to face.
 */
template <int dim>
struct NearStretch
{
  /// A sample of the first surface and one of the second that faces it, in ascending order.
  std::vector<std::pair<unsigned int, unsigned int>> facing;
  dealii::Tensor<1, dim> direction; ///< unit, mean from the first to the second
  dealii::Point<dim> middle;        ///< mean of all places [m]
  double gap = 0.;                  ///< the smallest along the direction, negative where they overlap [m]
};

/**
 * @brief All stretches in which two surfaces are no further from each other than @p reach [m].
 *
 * Two places face each other where their normals are opposed within 60 degrees, what a corner spans counted
 * in. Of those the nearest are taken, seen from either surface, so that the stretches of (b, a) are those of
 * (a, b). A stretch in which a normal leaves the mean direction by more than 57 degrees is parted: so two
 * bodies that wrap around each other, a disk in a ring, or a hook and a bar have several. Nothing here knows
 * what bodies are round.
 * @param may_face whether two samples may face each other; null: all may
 */
template <int dim>
std::vector<NearStretch<dim>>
near_stretches(const SampledSurface<dim> &a,
               const SampledSurface<dim> &b,
               double reach,
               const std::function<bool(unsigned int of_a, unsigned int of_b)> &may_face = nullptr);
} // namespace softgrain::mpm

#endif
