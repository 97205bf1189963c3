// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_tasks_h
#define softgrain_mpm_contact_frame_tasks_h

#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/frame_stretches.h>

#include <deal.II/base/bounding_box.h>

#include <memory>
#include <vector>

namespace softgrain::mpm
{
/// A body and what it may touch, and what is found there.
struct FrameTask
{
  ContactFrame<2> named;                    ///< without place and rays
  dealii::Tensor<1, 2> apart;               ///< from the partner to the image that the body meets [m]
  std::unique_ptr<SampledSurface<2>> image; ///< of the partner, where that is not the body itself
  dealii::BoundingBox<2> near;              ///< in which an obstacle is looked at
  const SampledSurface<2> *partner = nullptr;
  std::vector<FrameStretch> stretches;
  std::vector<ContactFrame<2>> found;
};

/// All that may touch, in an order that depends on nothing but the bodies.
/// @throw ComputationError when a body meets its own image
std::vector<FrameTask> find_frame_tasks(const FrameScene &scene,
                                        const std::vector<SampledSurface<2>> &samples);
} // namespace softgrain::mpm

#endif
