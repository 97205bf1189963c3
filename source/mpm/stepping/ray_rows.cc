// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_adhesion.h>
#include <softgrain/mpm/contact/told_rays.h>
#include <softgrain/mpm/stepping/ray_rows.h>

#include <deal.II/base/timer.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
constexpr double margin = 0.05; ///< gap beyond what bodies close up to which a ray has a row [cells]
} // namespace

RayRows::RayRows(const Problem &problem,
                 const State &state,
                 Workspace &work,
                 const double dt,
                 const std::vector<WallMotion<2>> &motion)
    : state(state)
    , work(work)
    , dt(dt)
    , h(problem.lattice->cell_size())
    , plane(problem, state, work, dt, motion)
    , scene{state.bodies, work.outlines, motion, h, problem.subgrid(), 0.5 * h}
{
  scene.dt = dt;
  scene.instants.met_at = 0.5;
  plane.complete(scene);
  double walls_way = plane.largest_way(), bodies_way = 0.;
  for (const WallMotion<2> &wall : motion)
    walls_way =
        std::max(walls_way, dt * (std::max(std::abs(wall.velocity), wall.fastest) + std::abs(wall.slide)));
  for (const double way : scene.ways.own)
    bodies_way = std::max(bodies_way, way);
  scene.reach += 2. * walls_way + (problem.pairs.adhere() ? state.adhesion.reach() : 0.);
  within = margin * h + walls_way + 2. * bodies_way;
  scene.looking = &work.share;
}

void RayRows::meet(const std::vector<Eigen::VectorXd> &way)
{
  std::vector<Eigen::VectorXd> displacement;
  for (const Body<2> &body : state.bodies)
  {
    displacement.push_back(body.nodes.displacement + scene.instants.met_at * way[body.index]);
    path = std::max(path, h + way[body.index].lpNorm<Eigen::Infinity>());
  }
  meet_frames(work.share, scene, force, displacement, way, path, within, frames);
}

void RayRows::find()
{
  {
    dealii::TimerOutput::Scope section(*work.timer, "contact search");
    for (const ContactFrame<2> &frame : find_frames(scene, state.frames))
    {
      frames.emplace_back(frame, scene);
      force.emplace_back();
      for (const ContactFrame<2>::RayPlace &of_ray : frame.rays)
        force.back().push_back(of_ray.force);
    }
  }
  dealii::TimerOutput::Scope section(*work.timer, "contact rays");
  std::vector<Eigen::VectorXd> way;
  for (const Body<2> &body : state.bodies)
    way.push_back(Eigen::VectorXd::Zero(body.field.n_dofs()));
  meet(way);
  for (FrameState<2> &frame : frames)
    FrameAdhesion<2>::find_pulls(frame, scene, false);
  for (const Body<2> &body : state.bodies)
    if (!body.rigid.driven)
      way[body.index] = dt * body.nodes.velocity;
  meet(way);
  std::vector<ContactRow<2>> rows;
  ray.clear();
  for (unsigned int f = 0; f < frames.size(); ++f)
    for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
      add_row(f, k, rows);
  work.contact.reinit(std::move(rows), work.share, true, state.bodies, dt, state.memory);
}

void RayRows::add_row(const unsigned int f, const unsigned int k, std::vector<ContactRow<2>> &rows)
{
  const FrameState<2> &frame = frames[f];
  const FrameState<2>::RayHere &here = frame.ray(k);
  if (!here.met || !here.near || !(here.gap < within || force[f][k] != 0. || here.held.pull > 0.))
    return;
  ContactRow<2> row = row_of_ray(scene, frame, k);
  tell_row(scene, frame, k, row);
  ray.emplace_back(f, k);
  rows.push_back(std::move(row));
}

std::vector<ContactFrame<2>> RayRows::frames_after() const
{
  RayForces normal;
  RayFriction<2> rubbing;
  for (const FrameState<2> &frame : frames)
  {
    normal.emplace_back(frame.n_rays(), 0.);
    rubbing.emplace_back(frame.n_rays());
  }
  const std::vector<double> &P = work.contact.impulses();
  const unsigned int components = work.contact.n_components();
  for (unsigned int r = 0; r < ray.size(); ++r)
  {
    const auto [f, k] = ray[r];
    normal[f][k] = P[r * components] / (dt * frames[f].derivatives().resultant(k).norm());
    if (components > 1)
      rubbing[f][k][0] = P[r * components + 1] / dt;
  }
  std::vector<ContactFrame<2>> result;
  for (unsigned int f = 0; f < frames.size(); ++f)
    result.push_back(frames[f].after(scene, normal[f], rubbing[f]));
  return result;
}
} // namespace softgrain::mpm
