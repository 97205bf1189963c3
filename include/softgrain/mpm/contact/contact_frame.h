// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_contact_frame_h
#define softgrain_mpm_contact_contact_frame_h

#include <softgrain/geometry/periodic_cell.h>
#include <softgrain/geometry/rest_surface.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief One stretch in which a body is near another one or a wall: a lattice of parallel rays, and what they
 * carry.
 *
 * A frame lasts from step to step. Its direction stays. Its origin moves across the rays with the mean motion
 * of the surfaces under them. Rays come and go only at its ends. So gaps at the end of a step are gaps at the
 * start of the next one, and contact does no work of its own.
 */
template <int dim>
struct ContactFrame
{
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  std::uint64_t id = 0;        ///< no other frame has it; it stays as long as the frame lasts
  unsigned int body = none;    ///< feels +force along the direction
  unsigned int partner = none; ///< another body; none: the wall
  unsigned int wall = none;    ///< wall; obstacles are counted on after walls
  /// Image of the partner that the body meets, counted as if no body had ever been brought back into the
  /// cell.
  typename PeriodicCell<dim>::Image image{};
  /// Body::home of the body when the frame was laid.
  typename PeriodicCell<dim>::Image home{};
  /// The side, 0 the partner and 1 the body, through whose corner its only ray goes; none: all surfaces are
  /// smooth where its rays meet them. A corner is a place of the material, on which the ray rides.
  unsigned int corner = none;
  dealii::Point<dim> origin;                          ///< [m]
  dealii::Tensor<1, dim> direction;                   ///< unit, from the partner to the body
  std::array<dealii::Tensor<1, dim>, dim - 1> across; ///< unit
  double spacing = 0;                                 ///< of the lattice [m]
  /// SubgridCompliance::log_full_width() at the places where body and partner touch first.
  std::array<double, 2> log_full_width = {{0., 0.}};

  struct RayPlace
  {
    std::array<int, dim - 1> index;      ///< on the lattice
    double force = 0;                    ///< multiplier of its gap [N/m^(dim-2)]; adhesion makes it negative
    dealii::Tensor<1, dim - 1> friction; ///< on the body, along RayRub::e [N/m^(dim-2)]
    double pull = 0;                     ///< of adhesion in the step before [N/m^(dim-2)]
    double memory = 0;                   ///< of a contact law that remembers
    std::array<SurfacePlace<dim>, 2> place; ///< where it meets the partner and the body
  };
  std::vector<RayPlace> rays; ///< in ascending order of their indices

  /// Where a ray of the lattice stands, from the origin [m]. In space the lattice is hexagonal.
  dealii::Tensor<1, dim - 1> offset(const std::array<int, dim - 1> &index) const
  {
    dealii::Tensor<1, dim - 1> way;
    way[0] = index[0] * spacing;
    if constexpr (dim == 3)
    {
      way[0] += 0.5 * index[1] * spacing;
      way[1] = 0.86602540378443864676 * index[1] * spacing;
    }
    return way;
  }
};

/// What a frame and its successor have in common.
template <int dim>
using FrameKey = std::tuple<unsigned int,
                            unsigned int,
                            unsigned int,
                            typename PeriodicCell<dim>::Image,
                            unsigned int,
                            unsigned int>;

template <int dim>
FrameKey<dim> key_of(const ContactFrame<dim> &frame)
{
  constexpr unsigned int none = ContactFrame<dim>::none;
  return {frame.body,
          frame.partner,
          frame.wall,
          frame.image,
          frame.corner,
          frame.corner == none || frame.rays.empty() ? none : frame.rays[0].place[frame.corner].piece};
}

/// Turns a frame to another direction. @param to unit
inline void turn(ContactFrame<2> &frame, const dealii::Tensor<1, 2> &to)
{
  frame.direction = to;
  frame.across[0] = dealii::Tensor<1, 2>({to[1], -to[0]});
}

/// The first of the unit vectors across the rays goes along the axis of space that is nearest to lying across
/// them, so lattices of mirrored scenes are mirror images.
inline void turn(ContactFrame<3> &frame, const dealii::Tensor<1, 3> &to)
{
  constexpr double rounding = 1e-6;
  frame.direction = to;
  unsigned int axis = 0;
  for (unsigned int d = 1; d < 3; ++d)
    if (std::abs(to[d]) < std::abs(to[axis]) - rounding)
      axis = d;
  dealii::Tensor<1, 3> along;
  along[axis] = 1.;
  along -= to[axis] * to;
  frame.across[0] = along / along.norm();
  frame.across[1] = dealii::cross_product_3d(to, frame.across[0]);
}
} // namespace softgrain::mpm

#endif
