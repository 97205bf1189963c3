// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_layout_h
#define softgrain_mpm_contact_frame_layout_h

#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/frame_stretches.h>

namespace softgrain::mpm
{
/// Lays the rays of frames over the stretches of one pair.
class FrameLayout
{
public:
  using Vector = dealii::Tensor<1, 2>;

  /// @param apart   from the partner to the image that the body meets [m]
  /// @param partner samples of that image, or of an obstacle; null: a wall
  FrameLayout(const FrameScene &scene,
              const Vector &apart,
              const SampledSurface<2> *partner,
              const SampledSurface<2> &body)
      : scene(scene), apart(apart), partner(partner), body(body)
  {
  }

  /// Gives a frame the rays that a stretch wants; forces of rays that stay are kept.
  void lay(const FrameStretch &stretch, ContactFrame<2> &frame) const;

  /// Moves a new frame to where the two are nearest, and turns it to their normals there: a light contact is
  /// met at its middle.
  void center(const FrameStretch &stretch, ContactFrame<2> &frame) const;

private:
  /// Places of the samples of a side, with where they lie across the rays [m].
  using Guesses = std::vector<std::pair<double, SurfacePlace<2>>>;

  Guesses guesses_of(const FrameStretch &stretch, const ContactFrame<2> &frame, unsigned int side) const;
  bool meet_from(const SurfacePlace<2> &guess,
                 const ContactFrame<2> &frame,
                 unsigned int side,
                 ContactFrame<2>::RayPlace &ray,
                 double &height) const;
  bool near_corner(const ContactFrame<2> &frame, unsigned int side, const SurfacePlace<2> &place) const;
  bool meet_side(const FrameStretch &stretch,
                 const ContactFrame<2> &frame,
                 unsigned int side,
                 const Guesses &guesses,
                 const ContactFrame<2>::RayPlace *old,
                 ContactFrame<2>::RayPlace &ray,
                 double &height) const;
  void note_dent(const std::array<SurfacePlace<2>, 2> &place, ContactFrame<2> &frame) const;
  const SampledSurface<2> &surface(const unsigned int side) const { return side == 0 ? *partner : body; }
  Vector away(const unsigned int side) const { return side == 0 ? apart : Vector(); }
  RaySide<2> meet_surface(const ContactFrame<2> &frame,
                          unsigned int side,
                          double offset,
                          const SurfacePlace<2> &guess) const;

  const FrameScene &scene;
  const Vector &apart;
  const SampledSurface<2> *partner;
  const SampledSurface<2> &body;
};
} // namespace softgrain::mpm

#endif
