// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_layout_h
#define softgrain_mpm_contact_frame_layout_h

#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/frame_stretches.h>

#include <optional>

namespace softgrain::mpm
{
/// Lays the rays of frames over the stretches of one pair.
template <int dim>
class FrameLayout
{
public:
  using Vector = dealii::Tensor<1, dim>;
  using Across = dealii::Tensor<1, dim - 1>;

  /// @param apart   from the partner to the image that the body meets [m]
  /// @param partner samples of that image, or of an obstacle; null: a wall
  FrameLayout(const FrameScene<dim> &scene,
              const Vector &apart,
              const SampledSurface<dim> *partner,
              const SampledSurface<dim> &body)
      : scene(scene), apart(apart), partner(partner), body(body)
  {
  }

  /// Gives a frame the rays that a stretch wants; forces of rays that stay are kept.
  void lay(const FrameStretch<dim> &stretch, ContactFrame<dim> &frame) const;

  /// Moves a new frame to where the two are nearest, and turns it to their normals there: a light contact is
  /// met at its middle.
  void center(const FrameStretch<dim> &stretch, ContactFrame<dim> &frame) const;

  /// Turns a frame about the place where both are met in the middle of its forces: there the gap stays what
  /// it is. @param direction unit
  void turn(const Vector &direction, ContactFrame<dim> &frame) const;

private:
  using Places = std::array<SurfacePlace<dim>, 2>; ///< on the partner and on the body
  /// What the ray at the origin of a frame meets on both sides.
  struct Met
  {
    Across slope;                    ///< of the gap across the rays
    dealii::Tensor<2, dim - 1> bend; ///< of the gap across the rays [1/m]
    double gap = 0.;                 ///< [m]
    double height = 0.;              ///< mean of both sides that are no wall [m]
    Vector normal;                   ///< sum of both
  };
  std::optional<Met> meet_both(const ContactFrame<dim> &frame, Places &place) const;
  /// Places of the samples of a side, with where they lie across the rays [m].
  using Guesses = std::vector<std::pair<Across, SurfacePlace<dim>>>;

  Guesses
  guesses_of(const FrameStretch<dim> &stretch, const ContactFrame<dim> &frame, unsigned int side) const;
  bool meets_outside(const RaySide<dim> &found,
                     const ContactFrame<dim> &frame,
                     unsigned int side,
                     typename ContactFrame<dim>::RayPlace &ray,
                     double &height) const;
  bool near_corner(const ContactFrame<dim> &frame, unsigned int side, const SurfacePlace<dim> &place) const;
  bool
  far_side(const ContactFrame<dim> &frame, const Across &offset, const std::array<double, 2> &height) const;
  bool meet_side(const FrameStretch<dim> &stretch,
                 const ContactFrame<dim> &frame,
                 unsigned int side,
                 const Guesses &guesses,
                 const typename ContactFrame<dim>::RayPlace *old,
                 typename ContactFrame<dim>::RayPlace &ray,
                 double &height) const;
  Places begin_at_samples(const FrameStretch<dim> &stretch, ContactFrame<dim> &frame) const;
  std::vector<Places> on_both_sides_of_corners(const Places &places, const ContactFrame<dim> &frame) const;
  std::optional<double> find_middle(Places place, ContactFrame<dim> &frame) const;
  void note_dent(const Places &place, ContactFrame<dim> &frame) const;
  const SampledSurface<dim> &surface(const unsigned int side) const { return side == 0 ? *partner : body; }
  Vector away(const unsigned int side) const { return side == 0 ? apart : Vector(); }
  RaySide<dim> meet_surface(const ContactFrame<dim> &frame,
                            unsigned int side,
                            const Across &offset,
                            const SurfacePlace<dim> &guess,
                            bool bends) const;

  const FrameScene<dim> &scene;
  const Vector &apart;
  const SampledSurface<dim> *partner;
  const SampledSurface<dim> &body;
};
} // namespace softgrain::mpm

#endif
