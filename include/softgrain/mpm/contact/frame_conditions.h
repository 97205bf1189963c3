// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_conditions_h
#define softgrain_mpm_contact_frame_conditions_h

#include <softgrain/mpm/contact/frame_state.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace softgrain::mpm
{
/// What is asked of the forces of a frame's rays in a step: gaps and slides as forces see them, bounds, and
/// what yields beside the bodies. It looks at the state of the frame, and lives no longer.
template <int dim>
class FrameConditions
{
public:
  using Across = dealii::Tensor<1, dim - 1>;

  explicit FrameConditions(const FrameState<dim> &state) : state(state) {}

  /// The gap that forces see: dents that the grid misses let both come nearer, and what softness has given to
  /// the force at the start of a step without inertia is taken back [m].
  double free_gap(const unsigned int k) const
  {
    return state.rays[k].gap + state.dent_depth -
           (state.inertia() ? 0. : state.softness * state.frame.rays[k].force);
  }
  /// Slide that softness lets a force on a ray have that differs from the one at the start of the step [m].
  Across free_slide(const unsigned int k) const
  {
    const RayRub<dim> &rub = state.rays[k].rub;
    return rub.slide - rub.known_slide - state.softness * state.frame.rays[k].friction;
  }
  /// A unit force on a ray closes its gap by this beside all else [m^2/N]. It is so little that it shows
  /// nowhere, but where a body's field has fewer shapes than there are rays it shares the force out.
  double ray_softness() const { return state.softness; }
  /// Young's modulus of the softer one, times the edge of a cell in space [N/m^2; N/m].
  double stiffness() const { return state.young; }
  double dent_slope() const { return state.by_force; }
  /// Energy in the dent that the grid misses, for these forces of the rays [J/m^(3-dim)].
  double dent_energy(const std::vector<double> &force) const
  {
    return state.subgrid.energy(state.dent, std::accumulate(force.begin(), force.end(), 0.));
  }
  double total_force() const { return state.sum_of_forces; }

  /// Whether a ray is closed: its surfaces part where adhesion alone is left of its force.
  bool closed(const unsigned int k, const double force) const { return force > -state.rays[k].held.pull; }
  /// The largest friction for a force [N/m].
  double most_friction(const unsigned int k, const double force) const
  {
    return state.rays[k].rub.bound * (force + state.rays[k].held.pull);
  }
  /// Whether a ray rubs: a pair with friction, met at the start of the step.
  bool rubs(const unsigned int k) const { return state.rays[k].rub.bound > 0.; }
  double friction_coefficient() const { return state.friction; }
  /// The force of a ray as the step begins: no less than adhesion leaves of it [N/m].
  double start_force(const unsigned int k) const
  {
    const RayHere<dim> &ray = state.rays[k];
    const double least = -ray.held.pull, force = state.frame.rays[k].force;
    if (ray.left)
      return 0.;
    return ray.held.pull > 0. && force <= 0. && free_gap(k) > 0. ? least : std::max(force, least);
  }
  /// Adds the kinks of its rays, after a step without inertia.
  void
  add_kinks(const std::vector<double> &force, const std::vector<Across> &rubbing, ContactKinks &kinks) const;

private:
  const FrameState<dim> &state;
};
} // namespace softgrain::mpm

#endif
