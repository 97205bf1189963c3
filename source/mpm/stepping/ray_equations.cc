// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/moved_boundary.h>
#include <softgrain/mpm/contact/told_rays.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/ray_equations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace softgrain::mpm
{
RayEquations::RayEquations(const Problem &problem,
                           const State &state,
                           Workspace &work,
                           const StepPlan &plan,
                           std::vector<WallMotion<2>> &motion)
    : problem(problem)
    , state(state)
    , work(work)
    , plan(plan)
    , motion(motion)
    , h(problem.lattice->cell_size())
    , inertia(problem.settings.scheme.inertia)
    , theta(problem.settings.scheme.theta)
    , cell(state.cell_motion(motion))
    , lines(state.obstacles.begin(), state.obstacles.end())
    , equations(problem, state, work, plan)
    , scene{state.bodies,
            work.outlines,
            motion,
            h,
            problem.subgrid(),
            0.5 * h + 2. * largest_way() + (problem.pairs.adhere() ? state.adhesion.reach() : 0.),
            &problem.pairs,
            cell ? &*cell : nullptr,
            plan.dt,
            ways_of_bodies(),
            inertia ? 0.5 : 1.,
            theta,
            own_ways(),
            &lines,
            problem.pairs.adhere() ? &state.adhesion : nullptr}
    , system(work.share, state.bodies, work.solvers, theta * plan.dt * plan.dt)
{
}

void RayEquations::lay()
{
  find_free_walls();
  for (const Body<2> &body : state.bodies)
    at_rest.push_back(Eigen::VectorXd::Zero(body.field.n_dofs()));
  way = at_rest;
  dealii::TimerOutput::Scope section(*work.timer, "contact search");
  scene.looking = &work.share;
  for (const ContactFrame<2> &frame : find_frames(scene, state.frames))
  {
    frames.emplace_back(frame, scene);
    force.emplace_back(frame.rays.size());
    rubbing.emplace_back(frame.rays.size());
  }
  take_forces_of_start();
  system.take(frames);
  path = h; // 0 is for rays that have never been met
}

void RayEquations::take_forces_of_start()
{
  for (unsigned int f = 0; f < frames.size(); ++f)
    for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
    {
      force[f][k] = frames[f].start_force(k);
      rubbing[f][k] = frames[f].ray(k).left ? 0. : frames[f].layout().rays[k].friction;
    }
}

RayEquations::Vectors RayEquations::free_way() const
{
  Vectors ways = at_rest;
  for (const Body<2> &body : state.bodies)
    if (inertia && !body.driven)
      ways[body.index] = plan.dt * body.velocity;
  return ways;
}

Eigen::VectorXd RayEquations::end_velocity(const unsigned int b, const Eigen::VectorXd &way) const
{
  if (!inertia || state.bodies[b].driven)
    return way / plan.dt;
  return (way / plan.dt - (1. - theta) * state.bodies[b].velocity) / theta;
}

/// By which bodies move beside what their nodes do, see FrameScene::carried.
std::vector<FrameState<2>::Vector> RayEquations::ways_of_bodies() const
{
  std::vector<FrameState<2>::Vector> ways(state.bodies.size());
  for (const Body<2> &body : state.bodies)
    if (body.driven)
      ways[body.index] = plan.dt * work.drive[body.index];
    else if (cell)
      ways[body.index] = plan.dt * cell->velocity(body.center());
  return ways;
}

/// See FrameScene::own_way; those of driven bodies are in largest_way().
std::vector<double> RayEquations::own_ways() const
{
  std::vector<double> ways;
  if (!inertia)
    return ways;
  for (const auto &way : work.share.numbers<1>(
           state.bodies, [&](const Body<2> &body)
           { return std::array<double, 1>{plan.dt * mpm::largest_way(body, body.velocity)}; }))
    ways.push_back(way[0]);
  return ways;
}

/// The largest by which something that is no unknown brings two places nearer [m].
double RayEquations::largest_way() const
{
  double way = 0.;
  for (const WallMotion<2> &wall : motion)
    way = std::max(way, way_of(wall).norm());
  for (const ObstacleLine &line : lines)
    way = std::max(way, line.largest_way());
  for (const Body<2> &body : state.bodies)
    if (body.driven)
      way = std::max(way, plan.dt * work.drive[body.index].norm());
  return way;
}

/// Puts walls under loads where they have come to.
void RayEquations::move_free_walls()
{
  std::vector<FreeWall<2>> &list = work.contact.free_walls.list;
  for (unsigned int w = 0; w < list.size(); ++w)
    list[w].speed = (system.ways[w].at / plan.dt - (1. - theta) * list[w].start_speed) / theta;
  if (list.empty())
    return;
  settle_free_walls(problem, state, work, motion);
  cell = state.cell_motion(motion);
  scene.carried = ways_of_bodies();
}

bool RayEquations::evaluate(const Vectors &to)
{
  move_free_walls();
  trial.resize(to.size());
  for (unsigned int b = 0; b < to.size(); ++b)
    trial[b] = end_velocity(b, to[b]);
  not_met = none;
  return equations.evaluate(trial) && meet(to);
}

bool RayEquations::meet(const Vectors &to)
{
  displacement.resize(to.size());
  for (unsigned int b = 0; b < to.size(); ++b)
    displacement[b] = state.bodies[b].displacement + scene.met_at * to[b];
  dealii::TimerOutput::Scope section(*work.timer, "contact search");
  const double within = 2. * candidates_within() + largest_way();
  for (unsigned int f = 0; f < frames.size(); ++f)
    frames[f].prepare(scene, to, force[f], path, within);
  look_and_tell(work.share, frames,
                [&](const unsigned int f)
                {
                  const unsigned int w = frames[f].layout().wall;
                  frames[f].look(scene, displacement, to,
                                 w < motion.size() ? way_of(motion[w]) : FrameState<2>::Vector(), force[f]);
                });
  for (unsigned int f = 0; f < frames.size() && not_met == none; ++f)
    if (!frames[f].meets(force[f]))
      not_met = f;
  return not_met == none;
}

bool RayEquations::leave_unmet_rays()
{
  bool any = false;
  for (unsigned int f = 0; f < frames.size(); ++f)
    any = frames[f].leave_unmet(force[f], rubbing[f]) || any;
  return any;
}

std::string RayEquations::why_not() const
{
  if (not_met == none)
    return equations.why_not();
  const ContactFrame<2> &frame = frames[not_met].layout();
  std::ostringstream text;
  text << "body '" << state.bodies[frame.body].name << "' and "
       << (frame.partner != none ? "body '" + state.bodies[frame.partner].name
           : frame.wall < state.walls.size()
               ? "wall '" + state.walls[frame.wall].description.name
               : "obstacle '" + state.obstacles[frame.wall - state.walls.size()].description.name)
       << "' turn away from where they press each other, near (" << frame.origin << ") m";
  return text.str();
}

/// What rays do to the nodes of a body.
Eigen::VectorXd RayEquations::contact_forces(const unsigned int b) const
{
  Eigen::VectorXd contact = at_rest[b];
  const auto add = [&](const unsigned int node, const FrameState<2>::Vector &value)
  {
    for (unsigned int d = 0; d < 2; ++d)
      contact[2 * node + d] += value[d];
  };
  for (const auto &[f, side] : system.frames_of[b])
  {
    const FrameState<2> &frame = frames[f];
    for (unsigned int k = 0; k < frame.n_rays(); ++k)
    {
      if (force[f][k] != 0.)
        frame.for_gradient(k, side, force[f][k], add);
      if (rubbing[f][k] != 0.)
        frame.for_slide(k, side, rubbing[f][k], add);
    }
    frame.for_mean(side, 0, -frame.tangential(force[f])[0], add);
  }
  return contact;
}

/// How far the rays of a frame are from their conditions.
void RayEquations::measure_frame(const unsigned int f, double &wrong_friction)
{
  const FrameState<2> &frame = frames[f];
  for (unsigned int k = 0; k < frame.n_rays(); ++k)
  {
    if (!frame.ray(k).met)
      continue;
    const double gap = frame.free_gap(k) + frame.ray_softness() * force[f][k];
    const bool closed = frame.closed(k, force[f][k]);
    deepest = std::max(deepest, closed ? std::abs(gap) : -gap);
    if (!frame.rubs(k) || !closed)
      continue;
    const double most = frame.most_friction(k, force[f][k]),
                 slide = frame.free_slide(k) + frame.ray_softness() * rubbing[f][k];
    wrong_friction = std::max(wrong_friction, std::abs(rubbing[f][k]) - most);
    // Friction below its bound holds.
    if (std::abs(rubbing[f][k]) < (1. - 1e-6) * most)
      deepest = std::max(deepest, std::abs(slide));
  }
}

/// Root of the sum of squares of the momentum of all nodes [N s/m].
double RayEquations::momentum_of_nodes(const Body<2> &body) const
{
  double sum = 0.;
  for (unsigned int i = 0; i < body.mass.size(); ++i)
    sum += (body.mass[i] * body.velocity.segment<2>(2 * i)).squaredNorm();
  return std::sqrt(sum);
}

void RayEquations::measure()
{
  double worst = 0., scale = 0., wrong_friction = 0.;
  deepest = 0.;
  for (unsigned int f = 0; f < frames.size(); ++f)
    measure_frame(f, wrong_friction);
  // Of every body what is unbalanced, and the largest force on it.
  const auto measured = work.share.numbers<2>(
      state.bodies,
      [&](const Body<2> &body)
      {
        const unsigned int b = body.index;
        const Eigen::VectorXd contact = contact_forces(b);
        double largest =
            std::max({contact.norm(), equations.internal[b].norm(), 1e-8 * body.law->wave_modulus() * h});
        if (inertia)
          largest =
              std::max({largest, 1e-6 / plan.dt * momentum_of_nodes(body), equations.external[b].norm()});
        return std::array<double, 2>{(equations.missing(b) / plan.dt + contact).norm(), largest};
      });
  for (const auto &[unbalanced, largest] : measured)
  {
    worst = std::max(worst, unbalanced);
    scale = std::max(scale, largest);
  }
  for (const FreeWay<2> &free : system.ways)
    scale = std::max(scale, std::abs(free.load));
  residual = std::max({worst, wrong_friction, unbalanced_free_walls()}) / scale;
}

bool RayEquations::at_rounding() const
{
  const auto beyond =
      work.share.numbers<1>(state.bodies,
                            [&](const Body<2> &body)
                            {
                              const unsigned int b = body.index;
                              const Eigen::VectorXd contact = plan.dt * contact_forces(b);
                              return std::array<double, 1>{(equations.missing(b) + contact).norm() -
                                                           equations.rounding(body, contact.norm())};
                            });
  return std::all_of(beyond.begin(), beyond.end(), [](const auto &of_body) { return of_body[0] <= 0.; });
}

void RayEquations::assemble()
{
  dealii::TimerOutput::Scope section(*work.timer, "assembly");
  work.share.for_mine(state.bodies,
                      [&](const Body<2> &body)
                      {
                        const unsigned int b = body.index;
                        equations.assemble_exact(body);
                        Eigen::MatrixXd block;
                        for (const auto &[f, side] : system.frames_of[b])
                          for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
                            if (force[f][k] != 0.)
                            {
                              const RaySide<2> &ray = frames[f].ray(k).side[side];
                              const double factor = (side == 0 ? 1. : -1.) * frames[f].bend() * force[f][k] *
                                                    theta * plan.dt * plan.dt;
                              ray.second_derivative(block);
                              work.matrices[b].add_cell<2>(
                                  ray.function.cell,
                                  [&](const unsigned int i, const unsigned int d, const unsigned int j,
                                      const unsigned int e) { return block(2 * i + d, 2 * j + e); },
                                  factor);
                            }
                      });
}

std::optional<unsigned int> RayEquations::factorise()
{
  dealii::TimerOutput::Scope section(*work.timer, "factorisation");
  constexpr double not_factorised = -1.;
  const auto told =
      work.share.numbers<1>(state.bodies,
                            [&](const Body<2> &body)
                            {
                              RankOneSolver &solver = *work.solvers[body.index];
                              solver.takes_indefinite = true;
                              return std::array<double, 1>{solver.factorize(work.matrices[body.index])
                                                               ? solver.n_negative().value_or(0)
                                                               : not_factorised};
                            });
  unsigned int sum = 0;
  for (const auto &[negative] : told)
  {
    if (negative == not_factorised)
      return std::nullopt;
    sum += static_cast<unsigned int>(negative);
  }
  return sum;
}

/// Walls under loads become unknowns.
void RayEquations::find_free_walls()
{
  const PeriodicCell<2> *repeats = cell ? &cell->cell : nullptr;
  for (const FreeWall<2> &free : work.contact.free_walls.list)
  {
    const Wall &wall = state.walls[free.wall];
    const unsigned int slab = wall.body == Wall::no_body ? FrameState<2>::none : wall.body;
    const PeriodicCell<2> *const side = wall.repeats() ? repeats : nullptr;
    if (inertia)
    {
      const double dt = plan.dt, begun = (1. - theta) * free.start_speed,
                   stiffness = free.mass / (theta * dt * dt),
                   farthest = free.stop > 0. ? dt * (std::abs(begun) + theta * free.stop)
                                             : std::numeric_limits<double>::max();
      system.ways.emplace_back(free, slab, side, 0., stiffness * dt * (begun + theta * free.free_speed),
                               farthest, stiffness);
      system.ways.back().at = dt * free.start_speed;
      continue;
    }
    const double load = free.slides() ? wall.slide_load : wall.load, net = load + wall.force * free.way;
    // The spring is that of bodies that resist no more than they must.
    system.ways.emplace_back(free, slab, side, std::abs(net) < 0.5 * std::abs(load) ? 0. : net, load,
                             problem.settings.wall_motion * h,
                             free.mass / (plan.dt * plan.dt) * problem.settings.regularisation /
                                 plan.regularisation);
  }
}

/// The largest force that a wall under a load lacks, those at their stops apart [N/m].
double RayEquations::unbalanced_free_walls() const
{
  double worst = 0.;
  for (const FreeWay<2> &way : system.ways)
  {
    if (way.stopped != 0)
      continue;
    double sum = way.load - way.stiffness * way.at;
    for (unsigned int f = 0; f < frames.size(); ++f)
    {
      const auto moves = way.moves(scene, frames[f]);
      for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
        if (force[f][k] != 0.)
          sum += force[f][k] * frames[f].gap_by(k, moves) + rubbing[f][k] * frames[f].slide_by(k, moves);
      sum -= frames[f].tangential(force[f]) * frames[f].motion_by(moves);
    }
    worst = std::max(worst, std::abs(sum));
  }
  return worst;
}
} // namespace softgrain::mpm
