// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/stepping/space_ray_step.h>

#include <algorithm>
#include <utility>

namespace softgrain::mpm
{
SpaceRayStep::SpaceRayStep(SpaceState &state,
                           const SpaceScene &space,
                           const std::vector<WallMotion<3>> &motion,
                           const StepPlan &plan,
                           BodyEquations<3> &equations)
    : RayNewton<3>({state.bodies, state.surfaces, state.frames, motion, space.settings,
                    space.settings.cell_size, space.subgrid, space.work.share, space.work.matrices,
                    space.work.solvers, *space.work.timer},
                   plan,
                   equations)
    , wall_names(space.wall_names)
{
  scene.pairs = &space.pairs;
}

std::string SpaceRayStep::partner_of(const ContactFrame<3> &frame) const
{
  return frame.partner != none ? "body '" + world.bodies[frame.partner].name
                               : "wall '" + wall_names[frame.wall];
}

void SpaceRayStep::add_contacts(const unsigned int f, SpaceState &state) const
{
  const FrameState<3> &frame = frames[f];
  const std::vector<double> &of_rays = force[f];
  const ContactFrame<3> &layout = frame.layout();
  for (unsigned int k = 0; k < frame.n_rays(); ++k)
    if (of_rays[k] != 0.)
    {
      SpaceContact contact{layout.body, layout.partner, layout.wall, layout.origin, {}, {}, frame.ray(k).gap};
      const dealii::Tensor<1, 2> offset = layout.offset(layout.rays[k].index) + frame.motion();
      contact.place += offset[0] * layout.across[0] + offset[1] * layout.across[1] +
                       frame.ray(k).side[1].height * layout.direction;
      contact.normal = frame.resultant(k) / frame.resultant(k).norm();
      contact.force = of_rays[k] * frame.resultant(k) + frame.in_space(k, rubbing[f][k]);
      if (layout.partner == none)
        state.wall_force[layout.wall] += contact.force;
      state.contacts.push_back(contact);
    }
}

void SpaceRayStep::accept_ways(SpaceState &state)
{
  for (const Eigen::VectorXd &of_body : way)
    outcome.largest_move = std::max(outcome.largest_move, of_body.lpNorm<Eigen::Infinity>());
  std::vector<ContactFrame<3>> kept;
  state.contacts.clear();
  state.wall_force.assign(world.motion.size(), dealii::Tensor<1, 3>());
  for (unsigned int f = 0; f < frames.size(); ++f)
  {
    add_contacts(f, state);
    kept.push_back(frames[f].after(scene, force[f], rubbing[f]));
  }
  state.frames = std::move(kept);
  const Vectors &ways = way;
  world.share.for_mine(state.bodies,
                       [&](Body<3> &body)
                       {
                         body.displacement += ways[body.index];
                         move_boundary(body);
                       });
}
} // namespace softgrain::mpm
