// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_stretches_h
#define softgrain_mpm_contact_frame_stretches_h

#include <softgrain/geometry/outline_surface.h>
#include <softgrain/geometry/solid_surface.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/contact/contact_frame.h>
#include <softgrain/mpm/contact/contact_rows.h>
#include <softgrain/mpm/contact/near_stretches.h>

#include <deal.II/base/bounding_box.h>

#include <array>
#include <vector>

namespace softgrain::mpm
{
/// A stretch where a body is near another one or a wall, as a frame covers it.
template <int dim>
struct FrameStretch
{
  dealii::Tensor<1, dim> direction;                ///< unit, from the partner to the body
  dealii::Point<dim> middle;                       ///< [m]
  std::vector<std::array<unsigned int, 2>> facing; ///< samples of partner (none of a wall) and body
  unsigned int corner = ContactFrame<dim>::none;   ///< side whose first facing sample is a corner, for itself
};

/// The outline of a body as it is now, at the places that are half a cell apart, and at its corners.
SampledSurface<2> sample_surface(const Body<2> &body, const OutlineSurface &outline);

/// A ball as it is now, at the markers of its body, which are the vertices of a geodesic sphere.
SampledSurface<3> sample_surface(const Body<3> &body, const SolidSurface &solid);

/// Stretches of a body no further than @p reach [m] from a plane: connected along its outline.
template <int dim>
std::vector<FrameStretch<dim>>
stretches_at_plane(const SampledSurface<dim> &surface, const WallMotion<dim> &wall, double reach);

/// near_stretches() of two bodies, or stretches_of_fold() of a body with @p itself.
template <int dim>
std::vector<FrameStretch<dim>> stretches_between(const SampledSurface<dim> &partner,
                                                 const SampledSurface<dim> &body,
                                                 double reach,
                                                 bool itself = false);

/// Adds a stretch for every corner in the stretches of a pair: a corner is met by the normal of what it
/// faces. @param partner null: a wall
template <int dim>
void add_corners(const SampledSurface<dim> *partner,
                 const SampledSurface<dim> &body,
                 std::vector<FrameStretch<dim>> &stretches);

/// The samples of a surface that lie in a box.
SampledSurface<2> part_in(const dealii::BoundingBox<2> &box, const SampledSurface<2> &surface);
} // namespace softgrain::mpm

#endif
