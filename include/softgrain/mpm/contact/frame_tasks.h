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
template <int dim>
struct FrameTask
{
  ContactFrame<dim> named;                    ///< without place and rays
  dealii::Tensor<1, dim> apart;               ///< from the partner to the image that the body meets [m]
  std::unique_ptr<SampledSurface<dim>> image; ///< of the partner, where that is not the body itself
  dealii::BoundingBox<dim> near;              ///< in which an obstacle is looked at
  const SampledSurface<dim> *partner = nullptr;
  std::vector<FrameStretch<dim>> stretches;
  std::vector<ContactFrame<dim>> found;
};

/// All that may touch, in an order that depends on nothing but the bodies.
/// @throw ComputationError when a body meets its own image
template <int dim>
std::vector<FrameTask<dim>> find_frame_tasks(const FrameScene<dim> &scene,
                                             const std::vector<SampledSurface<dim>> &samples);
} // namespace softgrain::mpm

#endif
