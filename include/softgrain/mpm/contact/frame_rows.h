// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_rows_h
#define softgrain_mpm_contact_frame_rows_h

#include <softgrain/mpm/contact/contact_memory.h>
#include <softgrain/mpm/contact/contact_rows.h>
#include <softgrain/mpm/contact/frame_system.h>

#include <memory>
#include <vector>

namespace softgrain::mpm
{
/// The values of the shape functions at a place, as weights of the nodes of its body.
template <int dim>
std::shared_ptr<const NodeWeights> weights_of(const PlaceFunctions<dim> &function);

/// Gives a row of an explicit step what ray @p k tells of its gap at the start, its softness, its friction
/// and the weights of nodes, for those who own neither body, too.
template <int dim>
void tell_row(const FrameScene<dim> &scene,
              const FrameState<dim> &frame,
              unsigned int k,
              ContactRow<dim> &row);

/// The contact row of ray @p k of a frame, without gap, friction and weights of nodes.
ContactRow<2> row_of_ray(const FrameScene<2> &scene, const FrameState<2> &frame, unsigned int k);

/**
 * @brief Rays that carry force as contact rows, for all that reads forces of contacts.
 *
 * The force of a row is what its ray does to the body, its share in the mean motion and friction counted in:
 * the partner feels the opposite.
 * @param scene  with its cell, if it has one
 * @param force  of the rays [N/m]
 * @param rubbing friction of the rays [N/m]
 * @param memory takes their impulses over its step
 */
std::vector<ContactRow<2>> rows_of_frames(const FrameScene<2> &scene,
                                          const std::vector<FrameState<2>> &frames,
                                          const RayForces &force,
                                          const RayFriction<2> &rubbing,
                                          ContactMemory<2> &memory);
} // namespace softgrain::mpm

#endif
