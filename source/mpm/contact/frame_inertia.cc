// SPDX-License-Identifier: LGPL-2.1-or-later
// Gaps of a step with inertia.
#include <softgrain/mpm/contact/frame_state.h>
#include <softgrain/mpm/contact/row_velocity.h>

#include <algorithm>

namespace softgrain::mpm
{
/// Share of an overlap at the start that a step with inertia opens, see Opening: what is found late is pushed
/// out without a velocity.
template <int dim>
double FrameState<dim>::share_that_opens(const FrameScene<dim> &scene) const
{
  return Opening{true, scene.cell_size}.share(scene.bodies[frame.body], scene.dt);
}

/// Replaces the gap halfway through the step by a first guess of the gap at its end.
template <int dim>
void FrameState<dim>::draw_on(const unsigned int k)
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

template <int dim>
double FrameState<dim>::added(const unsigned int k,
                              const std::vector<Eigen::VectorXd> &increment,
                              const Vector &wall_way) const
{
  const RayHere &here = rays[k];
  double sum = here.by_motion * moved;
  for (unsigned int side = 0; side < 2; ++side)
  {
    const Vector normal = side == 0 && flat_partner() ? frame.direction : here.side[side].normal;
    Vector way = side == 0 ? way_of_partner(wall_way, here.side[0].place) : Vector();
    if (const unsigned int b = body(side); b != none)
      way += here.side[side].function.at(increment[b]) + carried[side];
    sum += sign(side) * (way * normal);
  }
  return sum;
}

/// The way by which the two places part that a row of a ray stands for.
template <int dim>
typename FrameState<dim>::Vector FrameState<dim>::parted(const unsigned int k,
                                                         const std::vector<Eigen::VectorXd> &increment,
                                                         const Vector &wall_way) const
{
  const RayHere &here = rays[k];
  // Places at the start are known where there is friction alone.
  Vector way = -1. * way_of_partner(wall_way, conditions().rubs(k) ? here.rub.start[0] : here.side[0].place);
  for (unsigned int side = 0; side < 2; ++side)
    if (const unsigned int b = body(side); b != none)
      way += sign(side) *
             ((conditions().rubs(k) ? here.rub.hold[side] : here.side[side].function).at(increment[b]) +
              carried[side]);
  return way;
}

template double FrameState<2>::share_that_opens(const FrameScene<2> &) const;
template double FrameState<3>::share_that_opens(const FrameScene<3> &) const;
template void FrameState<2>::draw_on(unsigned int);
template void FrameState<3>::draw_on(unsigned int);
template double
FrameState<2>::added(unsigned int, const std::vector<Eigen::VectorXd> &, const FrameState<2>::Vector &) const;
template double
FrameState<3>::added(unsigned int, const std::vector<Eigen::VectorXd> &, const FrameState<3>::Vector &) const;
template FrameState<2>::Vector FrameState<2>::parted(unsigned int,
                                                     const std::vector<Eigen::VectorXd> &,
                                                     const FrameState<2>::Vector &) const;
template FrameState<3>::Vector FrameState<3>::parted(unsigned int,
                                                     const std::vector<Eigen::VectorXd> &,
                                                     const FrameState<3>::Vector &) const;
} // namespace softgrain::mpm
