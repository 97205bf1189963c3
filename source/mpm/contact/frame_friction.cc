// SPDX-License-Identifier: LGPL-2.1-or-later
// What the sides of a frame do to each other, and the friction of its rays.
#include <softgrain/mpm/contact/frame_state.h>

namespace softgrain::mpm
{
/// What the two sides do to each other. A body of which a wall is made stands for the wall.
template <int dim>
void FrameState<dim>::find_pair(const FrameScene<dim> &scene)
{
  const unsigned int wall = frame.partner == none ? frame.wall : scene.bodies[frame.partner].rigid.wall;
  const bool two_bodies = wall == none;
  if (scene.pairs != nullptr)
    friction = line != nullptr ? line->friction
               : two_bodies    ? scene.pairs->friction(frame.body, frame.partner)
                               : scene.pairs->friction_at_wall(frame.body, wall);
  // A corner has no length of its own.
  if (scene.adhesion != nullptr && frame.corner == none && line == nullptr)
    strength = two_bodies ? scene.pairs->adhesion(frame.body, frame.partner)
                          : scene.pairs->adhesion_at_wall(frame.body, wall);
}

template <int dim>
void FrameState<dim>::begin_to_rub(const FrameScene<dim> &scene, const Vector &wall_way, const unsigned int k)
{
  RayHere &here = rays[k];
  for (unsigned int side = 0; side < 2; ++side)
    if (side == 1 || !flat_partner())
      here.rub.start[side] = here.side[side].place;
  const Vector pushed = derivatives().resultant(k);
  here.rub.bound = friction * pushed.norm();
  const Vector normal = pushed / pushed.norm();
  if constexpr (dim == 2)
    here.rub.e[0] = Vector({normal[1], -normal[0]});
  else
  {
    // As the frame's own from step to step, so friction that a ray carries on keeps its direction.
    const Vector along = frame.across[0] - (frame.across[0] * normal) * normal;
    here.rub.e[0] = along / along.norm();
    here.rub.e[1] = dealii::cross_product_3d(normal, here.rub.e[0]);
  }
  if (theta < 1.)
    hold_at(scene, here.rub.start, wall_way, k);
}

/// The places that friction holds together from now on. Friction rests where end velocities are alike.
template <int dim>
void FrameState<dim>::hold_at(const FrameScene<dim> &scene,
                              const std::array<SurfacePlace<dim>, 2> &place,
                              const Vector &wall_way,
                              const unsigned int k)
{
  RayHere &here = rays[k];
  Vector apart_by = -1. * way_of_partner(wall_way, place[0]);
  for (unsigned int side = 0; side < 2; ++side)
    if (const unsigned int b = body(side); b != none)
    {
      apart_by += sign(side) * carried[side];
      here.rub.hold[side] = scene.bodies[b].field.functions_at(place[side].position);
      if (unknown(side) != none && theta < 1.)
        apart_by += sign(side) * scene.dt * here.rub.hold[side].at(scene.bodies[b].nodes.velocity);
    }
  here.rub.known_slide = (1. - theta) * here.rub.along(apart_by);
}

template <int dim>
void FrameState<dim>::look_for_slide(const FrameScene<dim> &scene,
                                     const std::vector<Eigen::VectorXd> &increment,
                                     const Vector &wall_way,
                                     const unsigned int k)
{
  RayHere &here = rays[k];
  // A ray that follows its contact holds what is in contact halfway.
  std::array<SurfacePlace<dim>, 2> place = here.rub.start;
  for (unsigned int side = 0; side < 2 && follows && !begins; ++side)
    place[side] = here.side[side].place;
  if (follows || here.rub.hold[1].node.empty())
    hold_at(scene, place, wall_way, k);
  Vector slid = -1. * way_of_partner(wall_way, place[0]);
  for (unsigned int side = 0; side < 2; ++side)
    if (const unsigned int b = body(side); b != none)
      slid += sign(side) * (here.rub.hold[side].at(increment[b]) + carried[side]);
  here.rub.slide = here.rub.along(slid);
}

template void FrameState<2>::begin_to_rub(const FrameScene<2> &, const FrameState<2>::Vector &, unsigned int);
template void FrameState<2>::look_for_slide(const FrameScene<2> &,
                                            const std::vector<Eigen::VectorXd> &,
                                            const FrameState<2>::Vector &,
                                            unsigned int);
template void FrameState<3>::begin_to_rub(const FrameScene<3> &, const FrameState<3>::Vector &, unsigned int);
template void FrameState<3>::look_for_slide(const FrameScene<3> &,
                                            const std::vector<Eigen::VectorXd> &,
                                            const FrameState<3>::Vector &,
                                            unsigned int);
template void FrameState<2>::find_pair(const FrameScene<2> &);
template void FrameState<3>::find_pair(const FrameScene<3> &);
} // namespace softgrain::mpm
