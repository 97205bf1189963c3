// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/stepping/account_loads.h>
#include <softgrain/mpm/stepping/space_ray_step.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace softgrain::mpm
{
namespace
{
/// Where a ray presses: on a wall or an obstacle, and in the middle between two bodies. Dents that the grid
/// misses let surfaces come nearer than to each other.
double at_height(const FrameState<3> &frame, const unsigned int k)
{
  const double share = frame.body(0) == FrameState<3>::none ? 1. : 0.5;
  return frame.ray(k).side[1].height - share * frame.ray(k).gap;
}
} // namespace

SpaceRayStep::SpaceRayStep(SpaceState &state,
                           const SpaceScene &space,
                           SpaceMotion &motion,
                           const StepPlan &plan,
                           BodyEquations<3> &equations)
    : RayNewton<3>({state.bodies, state.surfaces, state.frames, motion.walls, space.settings,
                    space.settings.cell_size, space.subgrid, space.work.share, space.work.matrices,
                    space.work.solvers, *space.work.timer},
                   plan,
                   equations)
    , motion(motion)
    , of_points(space.work.trial)
    , wall_names(space.wall_names)
    , obstacles(state.obstacles)
    , wall_force(state.wall_force)
    , solids(rays_of(obstacles, motion.obstacles))
{
  for (const auto &solid : solids)
    way_of_obstacles = std::max(way_of_obstacles, solid->largest_way());
  scene.pairs = &space.pairs;
  scene.lines = &solids;
  scene.reach += 2. * way_of_obstacles;
}

// As in the plane, where they may also slide.
void SpaceRayStep::find_free_walls()
{
  const double young = softest(world.bodies);
  const std::vector<WallMotion<3>> end = motion.at_end(plan.dt).walls;
  for (unsigned int w = 0; w < motion.walls.size(); ++w)
    if (motion.pressure[w])
    {
      FreeWall<3> free;
      free.wall = w;
      free.normal = free.way = motion.walls[w].normal;
      const double area = pressed_area(end, w), load = *motion.pressure[w] * area,
                   net = load - wall_force[w] * free.normal;
      system.ways.emplace_back(free, none, nullptr, std::abs(net) < 0.5 * std::abs(load) ? 0. : net, load,
                               world.settings.wall_motion * h,
                               10. * world.settings.regularisation * young * std::sqrt(area));
      pressed.push_back(w);
    }
}

void SpaceRayStep::move_free_walls()
{
  for (unsigned int i = 0; i < pressed.size(); ++i)
    motion.walls[pressed[i]].velocity = system.ways[i].at / plan.dt;
}

dealii::Tensor<1, 3> SpaceRayStep::way_of_partner(const FrameState<3> &frame, const unsigned int k) const
{
  if (const RigidRays<3> *obstacle = scene.line_of(frame.layout()))
    return obstacle->way_of(frame.ray(k).side[0].place);
  return way_of_wall(scene, frame.layout().wall);
}

std::string SpaceRayStep::partner_of(const ContactFrame<3> &frame) const
{
  if (frame.partner != none)
    return "body '" + world.bodies[frame.partner].name;
  const unsigned int o = obstacle_of(frame);
  return o != none ? "obstacle '" + obstacles[o].description.name : "wall '" + wall_names[frame.wall];
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
      const dealii::Tensor<1, 2> offset = layout.offset(layout.rays[k].index) + frame.derivatives().motion();
      contact.place += offset[0] * layout.across[0] + offset[1] * layout.across[1] +
                       at_height(frame, k) * layout.direction;
      const dealii::Tensor<1, 3> resultant = frame.derivatives().resultant(k);
      contact.normal = resultant / resultant.norm();
      contact.force = of_rays[k] * resultant + frame.ray(k).rub.in_space(rubbing[f][k]);
      if (const unsigned int o = obstacle_of(layout); o != none)
        state.obstacles[o].give(plan.dt * contact.force, contact.place, plan.dt);
      else if (layout.partner == none)
        state.wall_force[layout.wall] += contact.force;
      state.contacts.push_back(contact);
    }
}

void SpaceRayStep::account_load(const Body<3> &body,
                                const Eigen::VectorXd &load,
                                const LoadTimes &times,
                                SpaceState &state) const
{
  const unsigned int b = body.index;
  double left = load.dot(way[b]);
  auto name = body.loads.begin();
  for (const double work : powers_of_loads(body, times, way[b], way[b]))
  {
    state.load_work.add((*name++)->name, work);
    left -= work;
  }
  state.load_work.add((*name)->name, left);
}

void SpaceRayStep::accept_ways(SpaceState &state)
{
  for (const Eigen::VectorXd &of_body : way)
    outcome.largest_move = std::max(outcome.largest_move, of_body.lpNorm<Eigen::Infinity>());
  std::vector<ContactFrame<3>> kept;
  for (unsigned int o = 0; o < state.obstacles.size(); ++o)
  {
    state.obstacles[o].way = motion.obstacles[o];
    state.obstacles[o].arrive();
  }
  state.contacts.clear();
  state.wall_force.assign(world.motion.size(), dealii::Tensor<1, 3>());
  for (unsigned int f = 0; f < frames.size(); ++f)
  {
    add_contacts(f, state);
    kept.push_back(frames[f].after(scene, force[f], rubbing[f]));
  }
  state.frames = std::move(kept);
  const Vectors &ways = way;
  std::vector<WorkOfLaw> of_laws(state.bodies.size());
  world.share.for_mine(state.bodies,
                       [&](Body<3> &body)
                       {
                         const unsigned int b = body.index;
                         body.displacement += ways[b];
                         move_boundary(body);
                         of_laws[b] = keep_points(of_points[b], body);
                       });
  for (const WorkOfLaw &of_body : of_laws)
  {
    state.laws.loss += of_body.loss;
    state.laws.supply += of_body.supply;
  }
}
} // namespace softgrain::mpm
