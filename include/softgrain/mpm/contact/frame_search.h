// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_search_h
#define softgrain_mpm_contact_frame_search_h

#include <softgrain/driving/cell_motion.h>
#include <softgrain/geometry/outline_surface.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/contact/contact_frame.h>
#include <softgrain/mpm/contact/contact_rows.h>
#include <softgrain/mpm/contact/ray.h>
#include <softgrain/mpm/contact/subgrid_compliance.h>
#include <softgrain/scene/contact_pairs.h>

#include <vector>

namespace softgrain::mpm
{
/// What a search for frames looks at.
struct FrameScene
{
  const std::vector<Body<2>> &bodies;
  const std::vector<OutlineSurface> &outlines; ///< of the bodies, in the configuration of their grids
  const std::vector<WallMotion<2>> &walls;
  double cell_size;                    ///< [m]
  SubgridCompliance subgrid;           ///< what the grid misses of dents
  double reach;                        ///< gap up to which places are looked at [m]
  const ContactPairs *pairs = nullptr; ///< what bodies and walls do to each other; null: no friction
  const CellMotion *cell = nullptr;    ///< that repeats; null: nothing does
  double dt = 0.;                      ///< [s]
  /// By which bodies move beside what their nodes do over the step, since they are driven or a cell takes
  /// them along; empty: by nothing [m].
  std::vector<dealii::Tensor<1, 2>> carried = {};

  /// From the partner of a frame to the image of it that the body meets, at the start of the step [m].
  dealii::Tensor<1, 2> apart(const ContactFrame<2> &frame) const;
};

/// The ray of a frame at @p offset [m] from its origin, as a body sees it that stands @p away [m] from where
/// the frame has it.
Ray<2> ray_of(const ContactFrame<2> &frame,
              double offset,
              const dealii::Tensor<1, 2> &away = dealii::Tensor<1, 2>());

/**
 * @brief The frames of all that is near each other where the bodies are now.
 *
 * A stretch that is already covered by one of the frames @p before, whose direction it has kept within 11
 * degrees, keeps that frame and the forces of its rays.
 */
std::vector<ContactFrame<2>> find_frames(const FrameScene &scene, std::vector<ContactFrame<2>> before);
} // namespace softgrain::mpm

#endif
