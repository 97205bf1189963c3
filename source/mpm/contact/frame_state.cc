// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_state.h>
#include <softgrain/mpm/contact/row_velocity.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
constexpr double softness_of_rays = 1e-3; ///< times the softer Young's modulus
} // namespace

FrameState::FrameState(const ContactFrame<2> &layout, const FrameScene &scene)
    : frame(layout)
    , rays(layout.rays.size())
    , met_at(scene.met_at)
    , theta(scene.theta)
    , subgrid(scene.subgrid)
{
  young = scene.bodies[frame.body].law->young_modulus();
  if (frame.partner != none)
    young = std::min(young, scene.bodies[frame.partner].law->young_modulus());
  softness = softness_of_rays / young;
  // The law of dents is one of smooth surfaces; at a corner it would let go where the force grows.
  if (subgrid.on && frame.corner == none)
    dent = subgrid.dent(scene.bodies[frame.body],
                        frame.partner == none ? nullptr : &scene.bodies[frame.partner], frame.log_full_width);
  apart = scene.apart(frame);
  line = scene.line_of(frame);
  partner_is_driven = frame.partner != none && scene.bodies[frame.partner].driven;
  carry(scene);
  if (scene.pairs != nullptr)
    friction = line != nullptr         ? line->friction
               : frame.partner == none ? scene.pairs->friction_at_wall(frame.body, frame.wall)
                                       : scene.pairs->friction(frame.body, frame.partner);
  // A corner has no length of its own.
  if (scene.adhesion != nullptr && frame.corner == none && line == nullptr)
    strength = frame.partner == none ? scene.pairs->adhesion_at_wall(frame.body, frame.wall)
                                     : scene.pairs->adhesion(frame.body, frame.partner);
  double sum = 0., pressed = 0.;
  for (const auto &ray : frame.rays)
  {
    sum += ray.force;
    pressed += std::max(0., ray.force);
  }
  dent_at_start = subgrid(dent, sum) * sum;
  if (met_at < 1.)
  {
    opens = share_that_opens(scene);
    softness *= opens; // in short steps masses yield much less than matter
  }
  std::vector<double> weight(rays.size(), 0.);
  if (pressed > 0.)
    for (unsigned int k = 0; k < rays.size(); ++k)
      weight[k] = std::max(0., frame.rays[k].force) / pressed;
  else
  {
    // The ray that will be pressed first.
    unsigned int nearest = 0;
    double least = std::numeric_limits<double>::max();
    for (unsigned int k = 0; k < rays.size(); ++k)
    {
      double height = 0.;
      for (unsigned int side = 0; side < 2; ++side)
        if (body(side) != none)
        {
          const SurfacePlace<2> &place = frame.rays[k].place[side];
          const Body<2> &b = scene.bodies[body(side)];
          const Vector x = place.position + b.field.functions_at(place.position).at(b.displacement) +
                           away(side) - frame.origin;
          height += sign(side) * (x * frame.direction);
        }
        else if (line != nullptr && side == 0)
          height -= (line->placed(frame.rays[k].place[0], 0.) - frame.origin) * frame.direction;
      if (height < least)
      {
        least = height;
        nearest = k;
      }
    }
    weight[nearest] = 1.;
  }
  for (unsigned int side = 0; side < 2; ++side)
    if (unknown(side) != none && share(side) > 0.)
      for (unsigned int k = 0; k < rays.size(); ++k)
        if (weight[k] > 0.)
        {
          const PlaceFunctions<2> function =
              scene.bodies[body(side)].field.functions_at(frame.rays[k].place[side].position);
          for (unsigned int i = 0; i < function.node.size(); ++i)
            mean[side].emplace_back(function.node[i], share(side) * weight[k] * function.value[i]);
        }
}

void FrameState::carry(const FrameScene &scene)
{
  for (unsigned int side = 0; side < 2 && !scene.carried.empty(); ++side)
    if (body(side) != none)
      carried[side] = scene.carried[body(side)];
  if (scene.cell != nullptr)
    carried[0] += scene.dt * (scene.cell->gradient * apart);
}

RaySide<2> FrameState::meet_surface(const FrameScene &scene,
                                    const std::vector<Eigen::VectorXd> &displacement,
                                    const unsigned int side,
                                    const Ray<2> &ray,
                                    const SurfacePlace<2> &guess) const
{
  const unsigned int b = body(side);
  return b == none ? line->meet(ray, at, guess)
                   : meet(ray, scene.outlines[b], scene.bodies[b].field, displacement[b], guess);
}

/// A corner is a place of the material, or of an obstacle: no ray need be followed to it.
void FrameState::meet_corner(const FrameScene &scene,
                             const std::vector<Eigen::VectorXd> &displacement,
                             const unsigned int k)
{
  const unsigned int side = frame.corner, b = body(side);
  RaySide<2> &corner = rays[k].side[side];
  if (!corner.met)
  {
    corner.met = true;
    corner.place = frame.rays[k].place[side];
    if (b != none)
      corner.find_functions(scene.bodies[b].field);
    corner.normal = frame.direction;
  }
  const dealii::Point<2> place =
      b == none ? line->placed(corner.place, at)
                : dealii::Point<2>(corner.place.position + corner.function.at(displacement[b]) + away(side));
  corner.height = (place - frame.origin) * frame.direction;
  rays[k].gap += sign(side) * corner.height;
}

bool FrameState::meet_ray(const FrameScene &scene,
                          const std::vector<Eigen::VectorXd> &displacement,
                          const double wall_height,
                          const unsigned int k)
{
  const double offset = frame.rays[k].index[0] * frame.spacing + at * moved;
  RayHere &here = rays[k];
  here.gap = here.by_motion = 0.;
  for (unsigned int side = 0; side < 2; ++side)
  {
    if (side == 0 && flat_partner())
    {
      here.gap -= wall_height;
      continue;
    }
    if (side == frame.corner)
    {
      meet_corner(scene, displacement, k);
      continue;
    }
    const RaySide<2> found =
        meet_surface(scene, displacement, side, ray_of(frame, offset, away(side)),
                     here.side[side].met ? here.side[side].place : frame.rays[k].place[side]);
    if (!found.met)
      return false;
    here.side[side] = found;
    here.gap += sign(side) * found.height;
    here.by_motion -= sign(side) * (found.normal * frame.across[0]);
  }
  return true;
}

/// Share of an overlap at the start that a step with inertia opens, see Opening: what is found late is pushed
/// out without a velocity.
double FrameState::share_that_opens(const FrameScene &scene) const
{
  return Opening{true, scene.cell_size}.share(scene.bodies[frame.body], scene.dt);
}

/// Replaces the gap halfway through the step by the gap at its end.
void FrameState::draw_on(const unsigned int k)
{
  RayHere &here = rays[k];
  if (begins)
  {
    here.met_at_start = true;
    here.at_start = here.gap;
    here.stays = (1. - opens) * std::min(0., here.gap + dent_at_start);
  }
  here.gap = here.at_start + (here.gap - here.at_start) / met_at - here.stays;
}

void FrameState::begin_to_rub(const FrameScene &scene, const Vector &wall_way, const unsigned int k)
{
  RayHere &here = rays[k];
  for (unsigned int side = 0; side < 2; ++side)
    if (side == 1 || !flat_partner())
      here.start[side] = here.side[side].place;
  const Vector pushed = resultant(k);
  here.bound = friction * pushed.norm();
  here.e = Vector({pushed[1], -pushed[0]}) / pushed.norm();
  if (theta == 1.)
    return;
  // Friction rests where end velocities are alike.
  Vector apart_by = -1. * way_of_partner(wall_way, here.start[0]);
  for (unsigned int side = 0; side < 2; ++side)
    if (const unsigned int b = body(side); b != none)
    {
      apart_by += sign(side) * carried[side];
      here.hold[side] = scene.bodies[b].field.functions_at(here.start[side].position);
      if (unknown(side) != none)
        apart_by += sign(side) * scene.dt * here.hold[side].at(scene.bodies[b].velocity);
    }
  here.known_slide = (1. - theta) * (apart_by * here.e);
}

void FrameState::prepare(const FrameScene &scene,
                         const std::vector<Eigen::VectorXd> &increment,
                         const std::vector<double> &force,
                         const double path,
                         const double within)
{
  carry(scene);
  begins = !begun;
  begun = true;
  looks_within = within;
  at = begins && (met_at < 1. || scene.adhesion != nullptr) ? 0. : met_at;
  sum_of_forces = 0.;
  for (const double of_ray : force)
    sum_of_forces += of_ray;
  if (!keeps_dent)
  {
    dent_depth = subgrid(dent, sum_of_forces) * sum_of_forces;
    by_force = subgrid.slope(dent, sum_of_forces);
  }
  const Vector &t = frame.across[0];
  moved = 0.;
  for (unsigned int side = 0; side < 2; ++side)
  {
    if (unknown(side) != none)
      for (const auto &[i, weight] : mean[side])
        moved += weight * (PlaceFunctions<2>::of_node(increment[body(side)], i) * t);
    moved += share(side) * (carried[side] * t);
    if (line != nullptr && side == 0 && share(0) > 0.)
      moved += line->way_of(frame.rays[0].place[0]) * t;
  }
  for (unsigned int k = 0; k < rays.size(); ++k)
  {
    RayHere &here = rays[k];
    here.first = here.path == 0.;
    // Two places come nearer by their ways, times the lengths of their normals over the ray.
    here.near =
        !here.left && (here.first || force[k] != 0. || !(here.gap - 4. * (path - here.path) > within));
    if (here.near)
      here.path = path;
  }
}

void FrameState::look(const FrameScene &scene,
                      const std::vector<Eigen::VectorXd> &displacement,
                      const std::vector<Eigen::VectorXd> &increment,
                      const Vector &wall_way,
                      const std::vector<double> &force)
{
  const double wall_height =
      !flat_partner() ? 0. : (scene.walls[frame.wall].point + at * wall_way - frame.origin) * frame.direction;
  for (unsigned int k = 0; k < rays.size(); ++k)
  {
    RayHere &here = rays[k];
    if (!here.near)
      continue;
    const bool known = begins || met_at == 1. || here.met_at_start;
    here.met = known && meet_ray(scene, displacement, wall_height, k);
    if (here.met && met_at < 1.)
      draw_on(k);
    if (here.met && here.first && friction > 0.)
      begin_to_rub(scene, wall_way, k);
    if (!here.met || !(force[k] != 0. || free_gap(k) < looks_within))
      continue;
    for (unsigned int side = 0; side < 2; ++side)
      if (body(side) != none && side != frame.corner)
        here.side[side].find_functions(scene.bodies[body(side)].field);
    if (!rubs(k))
      continue;
    here.slide = -(way_of_partner(wall_way, here.start[0]) * here.e);
    for (unsigned int side = 0; side < 2; ++side)
      if (const unsigned int b = body(side); b != none)
      {
        if (here.hold[side].node.empty())
          here.hold[side] = scene.bodies[b].field.functions_at(here.start[side].position);
        here.slide += sign(side) * ((here.hold[side].at(increment[b]) + carried[side]) * here.e);
      }
  }
}

bool FrameState::meets(const std::vector<double> &force) const
{
  for (unsigned int k = 0; k < rays.size(); ++k)
    if (rays[k].near && !rays[k].met && force[k] != 0.)
      return false;
  return true;
}

void FrameState::keep_dent()
{
  dent_depth = dent_at_start;
  by_force = 0.;
  keeps_dent = true;
}

bool FrameState::leave_unmet(std::vector<double> &force, std::vector<double> &rubbing)
{
  bool any = false;
  for (unsigned int k = 0; k < rays.size(); ++k)
    if (force[k] != 0. && !rays[k].met)
    {
      any = rays[k].left = true;
      force[k] = rubbing[k] = rays[k].pull = 0.;
    }
  return any;
}

double FrameState::twice_by(const std::vector<double> &force,
                            const std::array<Vector, 2> &v,
                            const std::array<Vector, 2> &w) const
{
  double sum = 0.;
  for (unsigned int k = 0; k < rays.size(); ++k)
    for (unsigned int side = 0; side < 2; ++side)
      if (force[k] != 0. && rays[k].met && (side == 1 || !flat_partner()))
        sum += sign(side) * met_at * force[k] * (v[side] * (rays[k].side[side].sliding_twice * w[side]));
  return sum;
}

double FrameState::tangential(const std::vector<double> &force) const
{
  double sum = 0.;
  for (unsigned int k = 0; k < rays.size(); ++k)
    sum -= force[k] * rays[k].by_motion;
  return sum;
}

ContactFrame<2> FrameState::after(const FrameScene &scene,
                                  const std::vector<double> &force,
                                  const std::vector<double> &rubbing) const
{
  ContactFrame<2> result = frame;
  result.origin += moved * frame.across[0];
  result.origin += (carried[1] * frame.direction) * frame.direction;
  for (unsigned int k = 0; k < rays.size(); ++k)
  {
    result.rays[k].force = force[k];
    result.rays[k].friction = rubbing[k];
    result.rays[k].pull = rays[k].pull;
    result.rays[k].memory = memory_after(scene, k, force[k], rubbing[k]);
    for (unsigned int side = 0; side < 2; ++side)
      if (rays[k].side[side].met)
        result.rays[k].place[side] = rays[k].side[side].place;
  }
  return result;
}
} // namespace softgrain::mpm
