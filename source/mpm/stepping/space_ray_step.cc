// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/body/remembered_points.h>
#include <softgrain/mpm/stepping/account_loads.h>
#include <softgrain/mpm/stepping/space_ray_step.h>

#include <algorithm>
#include <array>
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
  for (unsigned int w = 0; w < motion.free.size(); ++w)
    if (motion.pressure[w])
    {
      motion.walls[w].velocity = motion.free[w].wall.start_speed;
      way_of_free_walls = std::max(way_of_free_walls, plan.dt * motion.free[w].wall.fastest());
    }
  scene.reach += 2. * way_of_free_walls;
  take_bodies_along();
}

void SpaceRayStep::take_bodies_along()
{
  cell = motion.cell();
  scene.cell = cell ? &*cell : nullptr;
  scene.ways.carried.clear();
  if (cell)
    for (const Body<3> &body : world.bodies)
      scene.ways.carried.push_back(plan.dt * cell->velocity(body.center()));
}

// As in the plane, where they may also slide.
void SpaceRayStep::find_free_walls()
{
  const double young = softest(world.bodies);
  const std::vector<WallMotion<3>> end = motion.at_end(plan.dt).walls;
  for (unsigned int w = 0; w < motion.walls.size(); ++w)
    if (motion.pressure[w])
    {
      pressed.push_back(w);
      if (inertia)
      {
        system.ways.push_back(FreeWay<3>::with_mass(motion.free[w].wall, none, nullptr, theta, plan.dt));
        continue;
      }
      FreeWall<3> free;
      free.wall = w;
      free.normal = free.way = motion.walls[w].normal;
      const double area = pressed_area(end, w), load = *motion.pressure[w] * area,
                   net = load - wall_force[w] * free.normal;
      const PeriodicCell<3> *const side = motion.walls[w].plane ? nullptr : &cell->cell;
      system.ways.emplace_back(free, none, side, std::abs(net) < 0.5 * std::abs(load) ? 0. : net, load,
                               world.settings.wall_motion * h,
                               10. * world.settings.regularisation * young * std::sqrt(area));
    }
}

void SpaceRayStep::move_free_walls()
{
  for (unsigned int i = 0; i < pressed.size(); ++i)
    motion.walls[pressed[i]].velocity = system.ways[i].at / plan.dt;
  if (cell && !pressed.empty())
    take_bodies_along();
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

dealii::Tensor<1, 3> SpaceRayStep::force_on_body(const unsigned int f, const unsigned int k) const
{
  return force[f][k] * frames[f].derivatives().resultant(k) + frames[f].ray(k).rub.in_space(rubbing[f][k]);
}

dealii::Point<3> SpaceRayStep::place_of(const FrameState<3> &frame, const unsigned int k) const
{
  const ContactFrame<3> &layout = frame.layout();
  const dealii::Tensor<1, 2> offset = layout.offset(layout.rays[k].index) + frame.derivatives().motion();
  return layout.origin + offset[0] * layout.across[0] + offset[1] * layout.across[1] +
         at_height(frame, k) * layout.direction;
}

void SpaceRayStep::add_contacts(const unsigned int f, SpaceState &state) const
{
  const FrameState<3> &frame = frames[f];
  const ContactFrame<3> &layout = frame.layout();
  for (unsigned int k = 0; k < frame.n_rays(); ++k)
    if (force[f][k] != 0.)
    {
      SpaceContact contact{layout.body, layout.partner,   layout.wall, {}, {},
                           {},          frame.ray(k).gap, layout.image};
      contact.place = place_of(frame, k);
      const dealii::Tensor<1, 3> resultant = frame.derivatives().resultant(k);
      contact.normal = resultant / resultant.norm();
      contact.force = force_on_body(f, k);
      if (const unsigned int o = obstacle_of(layout); o != none)
        state.obstacles[o].give(plan.dt * contact.force, contact.place, plan.dt);
      else if (layout.partner == none)
        state.wall_force[layout.wall] += contact.force;
      state.contacts.push_back(contact);
    }
}

dealii::Tensor<2, 3> SpaceRayStep::virial() const
{
  dealii::Tensor<2, 3> sum;
  for (unsigned int f = 0; f < frames.size(); ++f)
  {
    const FrameState<3> &frame = frames[f];
    dealii::Tensor<1, 3> of_frame;
    const dealii::Point<3> center = world.bodies[frame.body(1)].center();
    for (unsigned int k = 0; k < frame.n_rays(); ++k)
      if (force[f][k] != 0.)
      {
        const dealii::Tensor<1, 3> on_body = force_on_body(f, k);
        of_frame += on_body;
        if (frame.body(0) == none)
          sum += outer_product(on_body, center - place_of(frame, k));
      }
    if (frame.body(0) != none)
      sum += outer_product(of_frame, center - (world.bodies[frame.body(0)].center() + frame.image_shift()));
  }
  return sum;
}

void SpaceRayStep::load_sides_of_cell(SpaceState &state) const
{
  if (!cell)
    return;
  const dealii::Tensor<2, 3> of_contacts = virial();
  for (unsigned int w = 0; w < motion.walls.size(); ++w)
    if (!motion.walls[w].plane)
      state.wall_force[w] -= force_on_side(cell->cell, motion.walls[w].normal, of_contacts);
  state.cell_offset = cell->offset_after(plan.dt);
}

std::vector<double> SpaceRayStep::works_of_loads(const Body<3> &body,
                                                 const Eigen::VectorXd &load,
                                                 const Eigen::VectorXd &gone,
                                                 const LoadTimes &times) const
{
  std::vector<double> works = powers_of_loads(body, times, gone, gone);
  double left = load.dot(gone);
  for (const double work : works)
    left -= work;
  works.push_back(left);
  return works;
}

void SpaceRayStep::account_loads(const std::function<std::vector<double>(const Body<3> &)> &works_of,
                                 SpaceState &state) const
{
  if (std::all_of(state.bodies.begin(), state.bodies.end(),
                  [](const Body<3> &body) { return body.loads.empty(); }))
    return;
  std::vector<std::vector<double>> works(state.bodies.size());
  world.share.share_lists(
      [&]()
      {
        world.share.for_mine_here(state.bodies,
                                  [&](const Body<3> &body) { works[body.index] = works_of(body); });
      },
      works);
  for (const Body<3> &body : state.bodies)
  {
    auto load = body.loads.begin();
    for (const double work : works[body.index])
      state.load_work.add((*load++)->name, work);
  }
}

void SpaceRayStep::accept_ways(SpaceState &state)
{
  for (const Eigen::VectorXd &of_body : way)
    outcome.largest_move = std::max(outcome.largest_move, of_body.lpNorm<Eigen::Infinity>());
  for (unsigned int o = 0; o < state.obstacles.size(); ++o)
  {
    state.obstacles[o].way = motion.obstacles[o];
    state.obstacles[o].arrive();
  }
  state.contacts.clear();
  state.wall_force.assign(world.motion.size(), dealii::Tensor<1, 3>());
  for (unsigned int f = 0; f < frames.size(); ++f)
    add_contacts(f, state);
  state.frames = frames_after();
  load_sides_of_cell(state);
  move_bodies(state);
}

void SpaceRayStep::move_bodies(SpaceState &state)
{
  for (Body<3> &body : state.bodies)
    if (cell)
      body.translate(plan.dt * cell->velocity(body.center()));
  parallel_for(state.bodies.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                 {
                   state.bodies[b].nodes.displacement += way[b];
                   move_boundary(state.bodies[b]);
                 }
               });
  for (const auto &[loss, supply] :
       world.share.numbers<2>(state.bodies,
                              [&](Body<3> &body)
                              {
                                const WorkOfLaw work = keep_points(of_points[body.index], body);
                                return std::array<double, 2>{work.loss, work.supply};
                              }))
  {
    state.laws.loss += loss;
    state.laws.supply += supply;
  }
  share_points(world.share, state.bodies);
}
} // namespace softgrain::mpm
