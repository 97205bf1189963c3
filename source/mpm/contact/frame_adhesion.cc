// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_adhesion.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
/// The integral of the share over the way on which a contact is still held, in the mean over a part of it
/// along which the gap goes linearly from @p start to @p end [m]. A gap t lies on that way where the contact
/// is nearer than t, so it is the share at t times the part that is nearer: three points of Gauss between the
/// kinks of that part.
double mean_way(const Adhesion &adhesion, const double memory, const double start, const double end)
{
  constexpr double root = 0.7745966692414834;
  constexpr std::array<double, 3> at = {{0.5 - 0.5 * root, 0.5, 0.5 + 0.5 * root}},
                                  weight = {{5. / 18., 8. / 18., 5. / 18.}};
  const double reach = adhesion.reach();
  const std::array<double, 4> kinks = {
      {0., std::clamp(std::min(start, end), 0., reach), std::clamp(std::max(start, end), 0., reach), reach}};
  double sum = 0.;
  for (unsigned int piece = 0; piece < 3; ++piece)
    for (unsigned int q = 0; q < at.size(); ++q)
    {
      const double length = kinks[piece + 1] - kinks[piece], t = kinks[piece] + at[q] * length;
      if (length > 0.)
        sum += weight[q] * length * adhesion.mean_share(memory, t, t) * part_within(t, start, end);
    }
  return sum;
}
} // namespace

/// How far across the rays it is from one of them to the end of the side that it meets, @p direction 1 or -1;
/// no more than their spacing [m].
template <int dim>
double FrameAdhesion<dim>::way_to_edge(const FrameScene<dim> &scene,
                                       const unsigned int k,
                                       const double direction) const
{
  double least = frame.spacing;
  for (unsigned int side = state.flat_partner() ? 1 : 0; side < 2; ++side)
  {
    const RaySide<dim> &here = rays[k].side[side];
    const double per_offset = -(here.way[0] * frame.across[0]);
    dealii::Tensor<1, dim - 1> way;
    way[0] = per_offset * direction * frame.spacing;
    const SurfacePlace<dim> end = surface_of(scene, frame, side).move(here.place, way);
    if (end.at_edge)
      least = std::min(least, end.position.distance(here.place.position) / std::abs(per_offset));
  }
  return least;
}

template <int dim>
bool FrameAdhesion<dim>::has_neighbour(const unsigned int k, const int direction) const
{
  const unsigned int next = k + direction; // beyond all for the first
  return next < rays.size() && rays[next].met &&
         frame.rays[next].index[0] == frame.rays[k].index[0] + direction;
}

/// The gap at its ends is drawn from the slope at the ray: neighbours come and go, and curvatures jump from
/// cell to cell.
template <int dim>
std::array<typename FrameAdhesion<dim>::HalfLength, 2>
FrameAdhesion<dim>::half_lengths(const FrameScene<dim> &scene, const unsigned int k) const
{
  std::array<HalfLength, 2> halves;
  for (const unsigned int half : {0, 1})
  {
    const int direction = half == 0 ? -1 : 1;
    const double edge = way_to_edge(scene, k, direction);
    const bool ends = edge < frame.spacing && !has_neighbour(k, direction);
    const double length = ends ? edge : 0.5 * frame.spacing;
    halves[half] = {length, rays[k].gap + direction * length * rays[k].by_motion[0]};
  }
  return halves;
}

/// At the gaps that were last met [N/m].
template <int dim>
double FrameAdhesion<dim>::pull_now(const FrameScene<dim> &scene, const unsigned int k) const
{
  if (state.strength == 0. || !rays[k].met || rays[k].left)
    return 0.;
  double sum = 0.;
  for (const HalfLength &half : half_lengths(scene, k))
    sum += half.length * scene.adhesion->mean_share(rays[k].held.memory, rays[k].gap, half.gap);
  return state.strength * sum;
}

/// Likewise [J/m].
template <int dim>
double FrameAdhesion<dim>::parts_for_now(const FrameScene<dim> &scene, const unsigned int k) const
{
  double sum = 0.;
  for (const HalfLength &half : half_lengths(scene, k))
    sum += half.length * mean_way(*scene.adhesion, rays[k].held.memory, rays[k].gap, half.gap);
  return state.strength * sum;
}

template <int dim>
double FrameAdhesion<dim>::adhesion_work(const FrameScene<dim> &scene) const
{
  double sum = 0.;
  for (unsigned int k = 0; k < rays.size() && state.strength != 0.; ++k)
    if (rays[k].met && !rays[k].left)
      sum += parts_for_now(scene, k) - rays[k].held.parts_for;
  return sum;
}

template <int dim>
void FrameAdhesion<dim>::find_pulls(FrameState<dim> &state, const FrameScene<dim> &scene, const bool held)
{
  if (state.strength == 0.)
    return;
  const FrameAdhesion adhesion(state);
  for (unsigned int k = 0; k < state.rays.size(); ++k)
  {
    RayHere<dim> &ray = state.rays[k];
    const auto &before = state.frame.rays[k];
    if (!ray.met)
      continue;
    ray.held.memory = before.memory != 0. ? before.memory : scene.adhesion->first_memory(ray.gap);
    ray.held.pull = adhesion.pull_now(scene, k);
    if (held)
      ray.held.pull = 0.5 * (ray.held.pull + before.pull);
    if (!state.inertia())
      ray.held.parts_for = adhesion.parts_for_now(scene, k);
  }
}

template <int dim>
double FrameAdhesion<dim>::pull_to_come(const FrameScene<dim> &scene) const
{
  double sum = 0.;
  for (unsigned int k = 0; k < rays.size(); ++k)
    sum += std::abs(pull_now(scene, k) - rays[k].held.pull);
  return sum;
}

template <int dim>
double FrameAdhesion<dim>::memory_after(const FrameScene<dim> &scene,
                                        const unsigned int k,
                                        const double force,
                                        const double rubbing) const
{
  if (state.strength == 0. || !rays[k].met || rays[k].left)
    return 0.;
  constexpr double near_limit = 1. - 1e-6; // of friction: solvers have tolerances
  const std::array<HalfLength, 2> halves = half_lengths(scene, k);
  const FrameConditions<dim> conditions(state);
  const bool slides = conditions.rubs(k) && conditions.closed(k, force) &&
                      std::abs(rubbing) >= near_limit * conditions.most_friction(k, force);
  const double nearest =
      scene.adhesion->nearest(rays[k].gap, {{halves[0].gap - rays[k].gap, halves[1].gap - rays[k].gap}});
  return scene.adhesion->memory_after(rays[k].held.memory,
                                      {nearest, conditions.closed(k, force), slides, scene.dt});
}

template void FrameAdhesion<2>::find_pulls(FrameState<2> &, const FrameScene<2> &, bool);
template double FrameAdhesion<2>::pull_to_come(const FrameScene<2> &) const;
template double FrameAdhesion<2>::adhesion_work(const FrameScene<2> &) const;
template double FrameAdhesion<2>::memory_after(const FrameScene<2> &, unsigned int, double, double) const;
} // namespace softgrain::mpm
