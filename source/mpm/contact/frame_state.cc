// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_adhesion.h>
#include <softgrain/mpm/contact/frame_state.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
constexpr double nearly_flat = 0.5; ///< bend of an obstacle over that of a body
/// Times the softer Young's modulus, at rest and with inertia, where masses hold what the field of a body
/// does not.
constexpr double softness_at_rest = 1e-3, softness_with_inertia = 1e-4;
} // namespace

template <int dim>
FrameState<dim>::FrameState(const ContactFrame<dim> &layout, const FrameScene<dim> &scene)
    : frame(layout)
    , rays(layout.rays.size())
    , met_at(scene.instants.met_at)
    , theta(scene.instants.theta)
    , subgrid(scene.subgrid)
{
  young = scene.bodies[frame.body].material.law->young_modulus();
  if (frame.partner != none)
    young = std::min(young, scene.bodies[frame.partner].material.law->young_modulus());
  if constexpr (dim == 3)
    young *= scene.cell_size;
  softness = (inertia() ? softness_with_inertia : softness_at_rest) / young;
  line = scene.line_of(frame);
  // The law of dents is one of smooth surfaces; at a corner it would let go where the force grows.
  if (subgrid.on && frame.corner == none && !meets_bent_obstacle(scene))
    dent = subgrid.dent(scene.bodies[frame.body],
                        frame.partner == none ? nullptr : &scene.bodies[frame.partner], frame.log_full_width);
  apart = apart_of(scene, frame);
  partner_is_driven = frame.partner != none && scene.bodies[frame.partner].rigid.driven;
  carry(scene);
  find_pair(scene);
  double sum = 0.;
  for (const auto &ray : frame.rays)
    sum += ray.force;
  dent_at_start = subgrid(dent, sum) * sum;
  if (inertia())
  {
    opens = share_that_opens(scene);
    softness *= opens; // in short steps masses yield much less than matter
    beside.resize(2 * (dim - 1));
  }
  weigh_rays(scene);
  find_mean(scene);
}

template <int dim>
void FrameState<dim>::weigh_rays(const FrameScene<dim> &scene)
{
  weight.assign(rays.size(), 0.);
  double pressed = 0.;
  for (const auto &ray : frame.rays)
    pressed += std::max(0., ray.force);
  if (pressed > 0.)
  {
    for (unsigned int k = 0; k < rays.size(); ++k)
      weight[k] = std::max(0., frame.rays[k].force) / pressed;
    return;
  }
  // The rays that will be pressed first, all those of a flat side.
  std::vector<double> gaps;
  for (unsigned int k = 0; k < rays.size(); ++k)
    gaps.push_back(gap_at_places(scene, k));
  const double nearest = *std::min_element(gaps.begin(), gaps.end()) + same_gap(scene);
  const double n = std::count_if(gaps.begin(), gaps.end(), [&](const double g) { return g <= nearest; });
  for (unsigned int k = 0; k < rays.size(); ++k)
    weight[k] = gaps[k] <= nearest ? 1. / n : 0.;
}

/// The gap of a ray between the places that lie under it as the step begins, without meeting them anew [m].
template <int dim>
double FrameState<dim>::gap_at_places(const FrameScene<dim> &scene, const unsigned int k) const
{
  double gap = 0.;
  for (unsigned int side = 0; side < 2; ++side)
    if (body(side) != none)
    {
      const SurfacePlace<dim> &place = frame.rays[k].place[side];
      const Body<dim> &b = scene.bodies[body(side)];
      const Vector x = place.position + b.field.functions_at(place.position).at(b.nodes.displacement) +
                       away(side) - frame.origin;
      gap += sign(side) * (x * frame.direction);
    }
    else if (line != nullptr && side == 0)
      gap -= (line->placed(frame.rays[k].place[0], 0.) - frame.origin) * frame.direction;
  return gap;
}

template <int dim>
void FrameState<dim>::find_mean(const FrameScene<dim> &scene)
{
  for (unsigned int side = 0; side < 2; ++side)
    if (unknown(side) != none && share(side) > 0.)
      for (unsigned int k = 0; k < rays.size(); ++k)
        if (weight[k] > 0.)
        {
          const PlaceFunctions<dim> function =
              scene.bodies[body(side)].field.functions_at(frame.rays[k].place[side].position);
          for (unsigned int i = 0; i < function.node.size(); ++i)
            mean[side].emplace_back(function.node[i], share(side) * weight[k] * function.value[i]);
        }
}

/// In space the law of dents is that of a plane or a ball: not of an obstacle that bends as a body does.
template <int dim>
bool FrameState<dim>::meets_bent_obstacle(const FrameScene<dim> &scene) const
{
  if (dim == 2 || line == nullptr)
    return false;
  const double size = std::cbrt(scene.bodies[frame.body].rest.area);
  return frame.rays[0].place[0].bend.norm() * size > nearly_flat;
}

template <int dim>
void FrameState<dim>::carry(const FrameScene<dim> &scene)
{
  for (unsigned int side = 0; side < 2 && !scene.ways.carried.empty(); ++side)
    if (body(side) != none)
      carried[side] = scene.ways.carried[body(side)];
  if (scene.cell != nullptr)
    carried[0] += scene.dt * (scene.cell->gradient * apart);
}

template <int dim>
RaySide<dim> FrameState<dim>::meet_surface(const FrameScene<dim> &scene,
                                           const std::vector<Eigen::VectorXd> &displacement,
                                           const unsigned int side,
                                           const Ray<dim> &ray,
                                           const SurfacePlace<dim> &guess) const
{
  const unsigned int b = body(side);
  if (b == none)
    return line->meet(ray, at, guess);
  return meet(ray, scene.outlines[b], scene.bodies[b].field, displacement[b], guess);
}

/// A corner is a place of the material, or of an obstacle: no ray need be followed to it.
template <int dim>
void FrameState<dim>::meet_corner(const FrameScene<dim> &scene,
                                  const std::vector<Eigen::VectorXd> &displacement,
                                  const unsigned int k)
{
  const unsigned int side = frame.corner, b = body(side);
  RaySide<dim> &corner = rays[k].side[side];
  if (!corner.met)
  {
    corner.met = true;
    corner.place = frame.rays[k].place[side];
    if (b != none)
      corner.find_functions(scene.bodies[b].field);
    corner.normal = frame.direction;
  }
  dealii::Point<dim> place;
  if (b != none)
    place = dealii::Point<dim>(corner.place.position + corner.function.at(displacement[b]) + away(side));
  else
    place = line->placed(corner.place, at);
  corner.height = (place - frame.origin) * frame.direction;
  rays[k].gap += sign(side) * corner.height;
}

/// Lets a ray at @p offset from the origin meet a side. @param guess near where it does
template <int dim>
bool FrameState<dim>::meet_side(const FrameScene<dim> &scene,
                                const std::vector<Eigen::VectorXd> &displacement,
                                const double wall_height,
                                const unsigned int side,
                                const Across &offset,
                                const SurfacePlace<dim> &guess,
                                RayHere &here) const
{
  if (side == 0 && flat_partner())
  {
    here.gap -= wall_height;
    return true;
  }
  const Ray<dim> ray = ray_of(frame, offset, away(side));
  RaySide<dim> found = meet_surface(scene, displacement, side, ray, guess);
  if constexpr (dim == 2)
    if (const unsigned int b = body(side); !found.met && found.place.at_edge && b != none)
    {
      const SurfacePlace<2> end = found.place;
      found = meet_around(ray, scene.outlines[b], scene.bodies[b].field, displacement[b], end);
      if (!found.met && frame.corner != none)
        found = meet_past_end(ray, scene.bodies[b].field, displacement[b], end, past_ends(scene));
    }
  if (!found.met)
    return false;
  here.side[side] = found;
  here.gap += sign(side) * found.height;
  for (unsigned int m = 0; m < dim - 1; ++m)
    here.by_motion[m] -= sign(side) * (found.normal * frame.across[m]);
  return true;
}

template <int dim>
bool FrameState<dim>::meet_ray(const FrameScene<dim> &scene,
                               const std::vector<Eigen::VectorXd> &displacement,
                               const double wall_height,
                               const unsigned int k)
{
  const Across offset = frame.offset(frame.rays[k].index) + at * moved;
  RayHere &here = rays[k];
  here.gap = 0.;
  here.by_motion = Across();
  for (unsigned int side = 0; side < 2; ++side)
    if (side == frame.corner)
      meet_corner(scene, displacement, k);
    else if (!meet_side(scene, displacement, wall_height, side, offset,
                        here.side[side].met ? here.side[side].place : frame.rays[k].place[side], here))
      return false;
  return true;
}

/// Of the surfaces under the rays, over the step.
template <int dim>
typename FrameState<dim>::Across
FrameState<dim>::mean_motion(const std::vector<Eigen::VectorXd> &increment) const
{
  Across sum;
  for (unsigned int m = 0; m < dim - 1; ++m)
    for (unsigned int side = 0; side < 2; ++side)
    {
      const Vector &t = frame.across[m];
      if (unknown(side) != none)
        for (const auto &[i, weight] : mean[side])
          sum[m] += weight * (PlaceFunctions<dim>::of_node(increment[body(side)], i) * t);
      sum[m] += share(side) * (carried[side] * t);
      if (line != nullptr && side == 0 && share(0) > 0.)
        sum[m] += line->way_of(frame.rays[0].place[0]) * t;
    }
  return sum;
}

template <int dim>
void FrameState<dim>::prepare(const FrameScene<dim> &scene,
                              const std::vector<Eigen::VectorXd> &increment,
                              const std::vector<double> &force,
                              const double path,
                              const double within)
{
  carry(scene);
  begins = !begun;
  begun = true;
  looks_within = within;
  at = begins && (inertia() || scene.adhesion != nullptr) ? 0. : met_at;
  sum_of_forces = 0.;
  for (const double of_ray : force)
    sum_of_forces += of_ray;
  if (!keeps_dent)
  {
    dent_depth = subgrid(dent, sum_of_forces) * sum_of_forces;
    by_force = subgrid.slope(dent, sum_of_forces);
  }
  if (!follows)
    moved = mean_motion(increment);
  for (unsigned int k = 0; k < rays.size(); ++k)
  {
    RayHere &here = rays[k];
    here.first = here.path == 0.;
    // Two places come nearer by their ways, times the lengths of their normals over the ray.
    here.near = !here.left && (here.first || (follows && weight[k] > 0.) || force[k] != 0. ||
                               !(here.gap - 4. * (path - here.path) > within));
    if (here.near)
      here.path = path;
  }
}

template <int dim>
void FrameState<dim>::look(const FrameScene<dim> &scene,
                           const std::vector<Eigen::VectorXd> &displacement,
                           const std::vector<Eigen::VectorXd> &increment,
                           const Vector &wall_way,
                           const std::vector<double> &force)
{
  const double wall_height =
      !flat_partner() ? 0. : (scene.walls[frame.wall].point + at * wall_way - frame.origin) * frame.direction;
  if (follows && !begins)
    follow(scene, displacement, increment, wall_height);
  for (unsigned int k = 0; k < rays.size(); ++k)
  {
    RayHere &here = rays[k];
    if (!here.near)
      continue;
    const bool known = begins || !inertia() || here.met_at_start;
    here.met = known && meet_ray(scene, displacement, wall_height, k);
    if (here.met && inertia())
      draw_on(k);
    else if (here.met && here.first)
      note_gap_at_start(wall_way, k);
  }
  if (begins && inertia())
    choose_followed(scene, displacement, wall_height);
  for (unsigned int k = 0; k < rays.size(); ++k)
    if (rays[k].near && rays[k].met)
      look_closer(scene, increment, wall_way, k, force[k]);
}

/// Finds what is asked of a ray that carries force or may do so.
template <int dim>
void FrameState<dim>::look_closer(const FrameScene<dim> &scene,
                                  const std::vector<Eigen::VectorXd> &increment,
                                  const Vector &wall_way,
                                  const unsigned int k,
                                  const double force)
{
  RayHere &here = rays[k];
  if (here.first && friction > 0.)
    begin_to_rub(scene, wall_way, k);
  if (force == 0. && !(follows && weight[k] > 0.) && !(conditions().free_gap(k) < looks_within))
    return;
  for (unsigned int side = 0; side < 2; ++side)
    if (body(side) != none && side != frame.corner)
      here.side[side].find_functions(scene.bodies[body(side)].field);
  const double opened = inertia() && !begins ? added(k, increment, wall_way) : 0.;
  if (inertia() && !begins)
    here.gap = here.at_start - here.stays + opened;
  if (conditions().rubs(k))
    look_for_slide(scene, increment, wall_way, k);
  if (inertia() && !begins)
    here.beyond = opened - derivatives().resultant(k) * parted(k, increment, wall_way);
}

template <int dim>
bool FrameState<dim>::meets(const std::vector<double> &force) const
{
  for (unsigned int k = 0; k < rays.size(); ++k)
    if (rays[k].near && !rays[k].met && force[k] != 0.)
      return false;
  return true;
}

template <int dim>
void FrameState<dim>::keep_dent()
{
  dent_depth = dent_at_start;
  by_force = 0.;
  keeps_dent = true;
}

template <int dim>
bool FrameState<dim>::leave_unmet(std::vector<double> &force, std::vector<Across> &rubbing)
{
  bool any = false;
  for (unsigned int k = 0; k < rays.size(); ++k)
    if (force[k] != 0. && !rays[k].met)
    {
      any = rays[k].left = true;
      force[k] = rays[k].held.pull = 0.;
      rubbing[k] = Across();
    }
  return any;
}

template <int dim>
ContactFrame<dim> FrameState<dim>::after(const FrameScene<dim> &scene,
                                         const std::vector<double> &force,
                                         const std::vector<Across> &rubbing) const
{
  ContactFrame<dim> result = frame;
  for (unsigned int m = 0; m < dim - 1; ++m)
    result.origin += moved[m] * frame.across[m];
  result.origin += (carried[1] * frame.direction) * frame.direction;
  for (unsigned int k = 0; k < rays.size(); ++k)
  {
    result.rays[k].force = force[k];
    result.rays[k].friction = rubbing[k];
    result.rays[k].pull = rays[k].held.pull;
    if constexpr (dim == 2)
      result.rays[k].memory = FrameAdhesion<dim>(*this).memory_after(scene, k, force[k], rubbing[k].norm());
    for (unsigned int side = 0; side < 2; ++side)
      if (rays[k].side[side].met)
        result.rays[k].place[side] = rays[k].side[side].place;
  }
  return result;
}

template class FrameState<2>;
template class FrameState<3>;
} // namespace softgrain::mpm
