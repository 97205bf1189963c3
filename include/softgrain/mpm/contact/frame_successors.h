// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_successors_h
#define softgrain_mpm_contact_frame_successors_h

#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/frame_stretches.h>

#include <map>
#include <vector>

namespace softgrain::mpm
{
/// Frames of the step before that have no successor yet, by what they have in common with one.
template <int dim>
using FramesBefore = std::multimap<FrameKey<dim>, ContactFrame<dim>>;

/// Frames of the step before: moved with bodies that have been brought into the cell since then.
template <int dim>
FramesBefore<dim> frames_before(const FrameScene<dim> &scene, std::vector<ContactFrame<dim>> frames);

/// Cosine of 11 degrees: a frame that is off the direction of its stretch by more, and off the normals where
/// it presses, is turned or laid anew.
constexpr double keeps_direction = 0.98163;

/**
 * @brief Gives each stretch of a pair its frame: one that was pressed in the step before and covers it, or a
 * new one.
 *
 * The frame and the stretch that are nearest to each other go together first, then the nearest of those that
 * are left: whichever stretch is found first, none gets the frame of another one. A stretch also
 * gets a frame near it that has to be turned, which still has its old direction: with inertia any, at rest
 * one of the plane that presses over a width. What is narrower is laid anew at rest, where both are nearest.
 * A new frame may be turned off its stretch, since it has the normals there; if wide ones were laid anew,
 * they would be so in every step, with other gaps. A corner has but one ray, whose gap does not depend on
 * where it stood before.
 *
 * @param named  what the frame of each stretch is to have in common with one before
 * @param before loses the frames that are taken
 */
template <int dim>
std::vector<ContactFrame<dim>> start_frames(const FrameScene<dim> &scene,
                                            const std::vector<FrameStretch<dim>> &stretches,
                                            std::vector<ContactFrame<dim>> named,
                                            FramesBefore<dim> &before);
} // namespace softgrain::mpm

#endif
