// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of a frame's state that adhesion has to do with.
#include <softgrain/mpm/contact/frame_state.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace softgrain::mpm
{
/// How far across the rays it is from one of them to the end of the side that it meets, @p direction 1 or -1;
/// no more than their spacing [m].
double FrameState::way_to_edge(const FrameScene &scene, const unsigned int k, const double direction) const
{
  double least = frame.spacing;
  for (unsigned int side = flat_partner() ? 1 : 0; side < 2; ++side)
  {
    const RaySide<2> &here = rays[k].side[side];
    const double per_offset = -(here.way[0] * frame.across[0]);
    dealii::Tensor<1, 1> way;
    way[0] = per_offset * direction * frame.spacing;
    const SurfacePlace<2> end = scene.surface_of(frame, side).move(here.place, way);
    if (end.at_edge)
      least = std::min(least, end.position.distance(here.place.position) / std::abs(per_offset));
  }
  return least;
}

bool FrameState::has_neighbour(const unsigned int k, const int direction) const
{
  const unsigned int next = k + direction; // beyond all for the first
  return next < rays.size() && rays[next].met &&
         frame.rays[next].index[0] == frame.rays[k].index[0] + direction;
}

/// The gap at its ends is drawn from the slope at the ray: neighbours come and go, and curvatures jump from
/// cell to cell.
std::array<FrameState::HalfLength, 2> FrameState::half_lengths(const FrameScene &scene,
                                                               const unsigned int k) const
{
  std::array<HalfLength, 2> halves;
  for (const unsigned int half : {0, 1})
  {
    const int direction = half == 0 ? -1 : 1;
    const double edge = way_to_edge(scene, k, direction);
    const bool ends = edge < frame.spacing && !has_neighbour(k, direction);
    const double length = ends ? edge : 0.5 * frame.spacing;
    halves[half] = {length, rays[k].gap + direction * length * rays[k].by_motion};
  }
  return halves;
}

/// At the gaps that were last met [N/m].
double FrameState::pull_now(const FrameScene &scene, const unsigned int k) const
{
  if (strength == 0. || !rays[k].met || rays[k].left)
    return 0.;
  double sum = 0.;
  for (const HalfLength &half : half_lengths(scene, k))
    sum += half.length * scene.adhesion->mean_share(rays[k].memory, rays[k].gap, half.gap);
  return strength * sum;
}

void FrameState::find_pulls(const FrameScene &scene, const bool held)
{
  if (strength == 0.)
    return;
  for (unsigned int k = 0; k < rays.size(); ++k)
  {
    RayHere &ray = rays[k];
    if (!ray.met)
      continue;
    ray.memory = frame.rays[k].memory != 0. ? frame.rays[k].memory : scene.adhesion->first_memory(ray.gap);
    ray.pull = pull_now(scene, k);
    if (held)
      ray.pull = 0.5 * (ray.pull + frame.rays[k].pull);
  }
}

double FrameState::pull_to_come(const FrameScene &scene) const
{
  double sum = 0.;
  for (unsigned int k = 0; k < rays.size(); ++k)
    sum += std::abs(pull_now(scene, k) - rays[k].pull);
  return sum;
}

double FrameState::memory_after(const FrameScene &scene,
                                const unsigned int k,
                                const double force,
                                const double rubbing) const
{
  if (strength == 0. || !rays[k].met || rays[k].left)
    return 0.;
  constexpr double near_limit = 1. - 1e-6; // of friction: solvers have tolerances
  const std::array<HalfLength, 2> halves = half_lengths(scene, k);
  const bool slides =
      rubs(k) && closed(k, force) && std::abs(rubbing) >= near_limit * most_friction(k, force);
  const double nearest =
      scene.adhesion->nearest(rays[k].gap, {{halves[0].gap - rays[k].gap, halves[1].gap - rays[k].gap}});
  return scene.adhesion->memory_after(rays[k].memory, {nearest, closed(k, force), slides, scene.dt});
}
} // namespace softgrain::mpm
