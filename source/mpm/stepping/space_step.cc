// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/ray_newton.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/space_step.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
class SpaceStep : private RayNewton<3>
{
public:
  SpaceStep(const RayWorld<3> &world,
            const StepPlan &plan,
            SpaceEquations &equations,
            const ContactPairs &pairs,
            const std::vector<std::string> &wall_names)
      : RayNewton<3>(world, plan, equations), of_space(equations), wall_names(wall_names)
  {
    scene.pairs = &pairs;
  }

  using RayNewton<3>::careful;
  using RayNewton<3>::most_resistance;
  using RayNewton<3>::outcome;

  std::string find() { return converge(); }
  void accept(SpaceState &state);

private:
  std::string partner_of(const ContactFrame<3> &frame) const override
  {
    return frame.partner != none ? "body '" + world.bodies[frame.partner].name
                                 : "wall '" + wall_names[frame.wall];
  }
  void add_contacts(unsigned int f, SpaceState &state) const;
  void account_frame(unsigned int f, SpaceState &state) const;

  SpaceEquations &of_space;
  const std::vector<std::string> &wall_names;
};

void SpaceStep::add_contacts(const unsigned int f, SpaceState &state) const
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
        state.wall_force[layout.wall] += contact.force * world.motion[layout.wall].normal;
      state.contacts.push_back(contact);
    }
}

// From balance to balance friction does the work of the mean of both ends, but for what kinks tell.
void SpaceStep::account_frame(const unsigned int f, SpaceState &state) const
{
  const FrameState<3> &frame = frames[f];
  state.dent_energy += frame.dent_energy(force[f]);
  frame.add_kinks(force[f], rubbing[f], state.kinks);
  for (unsigned int k = 0; k < frame.n_rays(); ++k)
    if (frame.ray(k).met && frame.rubs(k))
      state.rubbed -= 0.5 * (frame.layout().rays[k].friction + rubbing[f][k]) * frame.ray(k).slide;
}

void SpaceStep::accept(SpaceState &state)
{
  state.held_back.resize(way.size());
  for (unsigned int b = 0; b < way.size(); ++b)
  {
    state.held_back[b] = of_space.held_back(b);
    state.regularisation_work += of_space.regularisation_work(b);
    outcome.largest_move = std::max(outcome.largest_move, way[b].lpNorm<Eigen::Infinity>());
  }
  std::vector<ContactFrame<3>> kept;
  state.contacts.clear();
  state.wall_force.assign(world.motion.size(), 0.);
  state.dent_energy = 0.;
  state.kinks = ContactKinks();
  for (unsigned int f = 0; f < frames.size(); ++f)
  {
    add_contacts(f, state);
    account_frame(f, state);
    kept.push_back(frames[f].after(scene, force[f], rubbing[f]));
  }
  state.frames = std::move(kept);
  const Vectors &ways = way;
  world.share.for_mine(state.bodies,
                       [&](Body<3> &body)
                       {
                         body.displacement += ways[body.index];
                         move_markers(body);
                       });
}
} // namespace

void move_markers(Body<3> &body)
{
  Boundary<3> &boundary = body.boundary;
  for (unsigned int m = 0; m < boundary.position.size(); ++m)
  {
    const NodeWeightsView weights = body.field.marker_weights(m);
    boundary.position[m] = boundary.grid_position[m];
    for (unsigned int i = 0; i < weights.size; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        boundary.position[m][d] += weights.weight[i] * body.displacement[3 * weights.node[i] + d];
  }
}

StepOutcome SpaceAtRest::step(const StepPlan &plan, const bool careful, const double most_resistance)
{
  std::vector<WallMotion<3>> walls = motion;
  for (WallMotion<3> &wall : walls)
    if (plan.held)
    {
      wall.point += plan.dt * wall.velocity * wall.normal;
      wall.velocity = 0.;
    }
  SpaceEquations equations(state.bodies, settings, work, plan, pairs.frictionless());
  SpaceStep step({state.bodies, state.surfaces, state.frames, walls, settings, settings.cell_size, subgrid,
                  work.share, work.matrices, work.solvers, *work.timer},
                 plan, equations, pairs, wall_names);
  return try_ray_step(step, careful, most_resistance, state);
}

double SpaceAtRest::unbalanced()
{
  return unbalanced_rays(state.bodies, state.frames, state.held_back, settings.cell_size);
}
} // namespace softgrain::mpm
