// SPDX-License-Identifier: LGPL-2.1-or-later
// What a frame knows of forces that do not change evenly in a step.
#include <softgrain/mpm/contact/frame_state.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
template <int dim>
void FrameState<dim>::note_gap_at_start(const Vector &wall_way, const unsigned int k)
{
  // Bodies are where the step begins, what carries them has gone its way.
  RayHere &here = rays[k];
  here.at_start =
      here.gap -
      at * derivatives().gap_by(k, {{carried[0] + way_of_partner(wall_way, here.side[0].place), carried[1]}});
}

template <int dim>
void FrameConditions<dim>::add_kinks(const std::vector<double> &force,
                                     const std::vector<Across> &rubbing,
                                     ContactKinks &kinks) const
{
  const auto &rays = state.rays;
  constexpr double near_bound = 1. - 1e-6; // of friction: solutions have tolerances
  for (unsigned int k = 0; k < rays.size(); ++k)
  {
    const double before = state.frame.rays[k].force, now = force[k];
    // Adhesion does work of its own on what is open.
    if (!rays[k].met || rays[k].left || rays[k].held.pull > 0. || state.frame.rays[k].pull > 0.)
      continue;
    if (before == 0. && now > 0.)
      kinks.of_gaps -= 0.5 * now * std::max(0., rays[k].at_start + state.dent_at_start);
    else if (before > 0. && now == 0.)
      kinks.of_gaps += 0.5 * before * std::max(0., free_gap(k));
    if (!rubs(k) || now <= 0. || rubbing[k].norm() < near_bound * most_friction(k, now))
      continue;
    const Across mean = 0.5 * (state.frame.rays[k].friction + rubbing[k]),
                 sliding = 0.5 * (before + now) / now * rubbing[k];
    kinks.of_slides -= (sliding - mean) * (rays[k].rub.slide - rays[k].rub.known_slide);
  }
}

template void FrameState<2>::note_gap_at_start(const FrameState<2>::Vector &, unsigned int);
template void FrameState<3>::note_gap_at_start(const FrameState<3>::Vector &, unsigned int);
template void FrameConditions<2>::add_kinks(const std::vector<double> &,
                                            const std::vector<FrameConditions<2>::Across> &,
                                            ContactKinks &) const;
template void FrameConditions<3>::add_kinks(const std::vector<double> &,
                                            const std::vector<FrameConditions<3>::Across> &,
                                            ContactKinks &) const;
} // namespace softgrain::mpm
