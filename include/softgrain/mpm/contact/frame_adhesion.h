// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_adhesion_h
#define softgrain_mpm_contact_frame_adhesion_h

#include <softgrain/mpm/contact/frame_state.h>

#include <array>
#include <vector>

namespace softgrain::mpm
{
/// What adhesion has to do with the rays of a frame. It looks at the state of the frame, and lives no longer.
template <int dim>
class FrameAdhesion
{
public:
  explicit FrameAdhesion(const FrameState<dim> &state) : state(state), frame(state.frame), rays(state.rays) {}

  /// Finds by how much rays of @p state pull in this step: what adhesion does where they were met as the step
  /// begins. @param held the step seeks balance only: pulls go half-way there
  static void find_pulls(FrameState<dim> &state, const FrameScene<dim> &scene, bool held);

  /// The difference of what rays pull to what they would pull where they were last met [N/m].
  double pull_to_come(const FrameScene<dim> &scene) const;
  /// What adhesion does in a step without inertia: parting takes as much less where rays were last met than
  /// at the start [J/m]. Whatever the pull of the step, what comes near and goes again leaves nothing.
  double adhesion_work(const FrameScene<dim> &scene) const;
  /// What a ray remembers after a step in which it carried @p force and @p rubbing.
  double memory_after(const FrameScene<dim> &scene, unsigned int k, double force, double rubbing) const;

private:
  /// The length of outline that a ray stands for, to one side of it [m].
  struct HalfLength
  {
    double length = 0; ///< across the rays
    double gap = 0;    ///< at its end
  };
  std::array<HalfLength, 2> half_lengths(const FrameScene<dim> &scene, unsigned int k) const;
  double pull_now(const FrameScene<dim> &scene, unsigned int k) const;
  double parts_for_now(const FrameScene<dim> &scene, unsigned int k) const;
  bool has_neighbour(unsigned int k, int direction) const;
  double way_to_edge(const FrameScene<dim> &scene, unsigned int k, double direction) const;

  const FrameState<dim> &state;
  const ContactFrame<dim> &frame;
  const std::vector<RayHere<dim>> &rays;
};
} // namespace softgrain::mpm

#endif
