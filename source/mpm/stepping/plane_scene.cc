// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/moved_boundary.h>
#include <softgrain/mpm/stepping/plane_scene.h>

#include <algorithm>
#include <array>

namespace softgrain::mpm
{
PlaneScene::PlaneScene(const Problem &problem,
                       const State &state,
                       const Workspace &work,
                       const double dt,
                       const std::vector<WallMotion<2>> &motion)
    : problem(problem)
    , state(state)
    , work(work)
    , dt(dt)
    , motion(motion)
    , cell(state.cell_motion(motion))
    , lines(rays_of(state.obstacles, 0.5 * problem.lattice->cell_size()))
{
}

/// By which bodies move beside what their nodes do, see FrameWays::carried.
std::vector<PlaneScene::Vector> PlaneScene::ways_of_bodies() const
{
  std::vector<Vector> ways(state.bodies.size());
  for (const Body<2> &body : state.bodies)
    if (body.rigid.driven)
      ways[body.index] = dt * work.drive[body.index];
    else if (cell)
      ways[body.index] = dt * cell->velocity(body.center());
  return ways;
}

/// See FrameWays::own; those of driven bodies are in largest_way().
std::vector<double> PlaneScene::own_ways() const
{
  std::vector<double> ways;
  if (problem.settings.scheme.ends_in_balance())
    return ways;
  for (const auto &way : work.share.numbers<1>(
           state.bodies, [&](const Body<2> &body)
           { return std::array<double, 1>{dt * mpm::largest_way(body, body.nodes.velocity)}; }))
    ways.push_back(way[0]);
  return ways;
}

double PlaneScene::largest_way() const
{
  double way = 0.;
  for (const auto &line : lines)
    way = std::max(way, line->largest_way());
  for (const Body<2> &body : state.bodies)
    if (body.rigid.driven)
      way = std::max(way, dt * work.drive[body.index].norm());
  return way;
}

void PlaneScene::complete(FrameScene<2> &scene) const
{
  scene.pairs = &problem.pairs;
  scene.cell = cell ? &*cell : nullptr;
  scene.lines = &lines;
  scene.adhesion = problem.pairs.adhere() ? &state.adhesion : nullptr;
  scene.ways.carried = ways_of_bodies();
  scene.ways.own = own_ways();
}

void PlaneScene::renew(FrameScene<2> &scene)
{
  cell = state.cell_motion(motion);
  scene.ways.carried = ways_of_bodies();
}
} // namespace softgrain::mpm
