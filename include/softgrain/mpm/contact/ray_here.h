// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_ray_here_h
#define softgrain_mpm_contact_ray_here_h

#include <softgrain/mpm/contact/ray.h>

#include <array>

namespace softgrain::mpm
{
/// How both surfaces under a ray rub: vectors of e are 0 where there is no friction.
template <int dim>
struct RayRub
{
  std::array<SurfacePlace<dim>, 2> start;        ///< places under the ray at the start of the step
  std::array<PlaceFunctions<dim>, 2> hold;       ///< of the field there
  std::array<dealii::Tensor<1, dim>, dim - 1> e; ///< unit, at right angles to each other and to its push
  double bound = 0;                              ///< largest friction over force
  bool keeps = false;                            ///< its friction was kept, see FrameSystem::kept
  dealii::Tensor<1, dim - 1> slide;              ///< along e [m]
  dealii::Tensor<1, dim - 1> known_slide; ///< what velocities at the start have in it, with inertia [m]

  /// Components of a vector along e.
  dealii::Tensor<1, dim - 1> along(const dealii::Tensor<1, dim> &way) const
  {
    dealii::Tensor<1, dim - 1> result;
    for (unsigned int m = 0; m < dim - 1; ++m)
      result[m] = e[m] * way;
    return result;
  }
  /// The vector that stands at @p way in the directions of e.
  dealii::Tensor<1, dim> in_space(const dealii::Tensor<1, dim - 1> &way) const
  {
    dealii::Tensor<1, dim> result;
    for (unsigned int m = 0; m < dim - 1; ++m)
      result += way[m] * e[m];
    return result;
  }
};

/// How adhesion holds both surfaces under a ray.
struct RayHold
{
  double pull = 0;      ///< with which it holds them together [N/m]
  double memory = 0;    ///< of a contact law that remembers
  double parts_for = 0; ///< what parting takes from it, as the step begins [J/m]
};

/// A ray of a frame in a step: what it meets and what it knows of its gap.
template <int dim>
struct RayHere
{
  using Vector = dealii::Tensor<1, dim>;
  using Across = dealii::Tensor<1, dim - 1>; ///< a component for each direction across the ray

  std::array<RaySide<dim>, 2> side; ///< of the partner and the body
  bool met = false;
  bool met_at_start = false; ///< with inertia; else no gap at the end is known
  bool near = true;          ///< looked at
  bool first = true;         ///< for the first time
  bool left = false;   ///< has slid off one of its surfaces, so that it is no more looked at in this step
  double gap = 0;      ///< [m]
  double path = 0;     ///< when it was last looked at
  Across by_motion;    ///< dg/dc
  double at_start = 0; ///< gap at the start of the step [m]
  double beyond =
      0; ///< what its gap opens beside the way of the places that its row stands for, with inertia [m]
  double stays = 0; ///< what the step leaves closed of an overlap with which it began [m]
  RayHold held;     ///< by adhesion
  RayRub<dim> rub;
};
} // namespace softgrain::mpm

#endif
