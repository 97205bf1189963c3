// SPDX-License-Identifier: LGPL-2.1-or-later
// How MpmModel lays new grids under its bodies.
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/contact/frame_memory.h>
#include <softgrain/mpm/model/mpm_model.h>
#include <softgrain/mpm/stepping/stiffness.h>
#include <softgrain/mpm/stepping/stress.h>

#include <algorithm>

namespace softgrain::mpm
{
void MpmModel::refresh_forces(Body<2> &body)
{
  StepState<2> &s = work.trial[body.index];
  const auto n = body.points.size();
  s.grid_gradient.assign(n, dealii::Tensor<2, 2>({{1., 0.}, {0., 1.}}));
  s.gradient.resize(n);
  s.stress.resize(n);
  s.volume.resize(n);
  for (unsigned int p = 0; p < n; ++p)
  {
    const auto point = body.points[p];
    s.gradient[p] = point.gradient();
    s.stress[p] = point.stress();
    s.volume[p] = body.material.small_strain() ? point.volume() : point.rest_volume();
  }
  internal_force(body, s, body.nodes.internal_force);
}

void MpmModel::renew_grids()
{
  if (problem.settings.grid_update == GridUpdate::never)
    return;
  dealii::TimerOutput::Scope section(*timer, "grid update");
  std::vector<unsigned int> leaving;
  const std::vector<double> distortion = grid_distortions();
  for (Body<2> &body : state.bodies)
    if (problem.settings.grid_update == GridUpdate::every_step ||
        distortion[body.index] >= problem.settings.distortion_limit)
    {
      bring_into_cell(body); // so that the mesh need not reach where it goes
      leaving.push_back(body.index);
    }
  if (leaving.empty())
    return;
  if (state.repeats() && problem.settings.meets_by_rays())
  {
    BodyShare::Message message(work.share);
    for (const unsigned int b : leaving)
      if (!state.bodies[b].rigid.driven)
        message.add_outline(state.bodies[b]);
    message.send();
  }
  lay_grids_anew(leaving);
  for (const unsigned int b : leaving)
  {
    Body<2> &body = state.bodies[b];
    if (body.rigid.driven)
    {
      for (unsigned int i = 0; body.nodes.velocity.size() > 0 && i < body.field.n_independent(); ++i)
        for (unsigned int d = 0; d < 2; ++d)
          body.nodes.velocity[2 * i + d] = work.drive[b][d];
      continue;
    }
    lay_out_matrix(body);
  }
  work.share.for_mine(
      state.bodies,
      [&](Body<2> &body)
      {
        if (std::binary_search(leaving.begin(), leaving.end(), body.index))
          refresh_forces(body);
      },
      [&](BodyShare::Message &message)
      {
        for (const unsigned int b : leaving)
          if (Body<2> &body = state.bodies[b]; !body.rigid.driven)
          {
            body.nodes.internal_force.conservativeResize(body.field.n_dofs());
            message.add(b, body.nodes.internal_force.data(), body.nodes.internal_force.size());
          }
      });
  // Checkpoints tell where rays meet outlines by places on these.
  if (problem.settings.meets_by_rays() && !work.outlines.empty())
    renew_outlines(state.bodies, work.outlines, state.frames);
}

void MpmModel::lay_grids_anew(const std::vector<unsigned int> &bodies)
{
  const BuildContext context{*problem.lattice, *problem.shape, problem.settings, *state.points};
  const auto for_held = [&](const auto &work_on)
  {
    for (unsigned int i = 0; i < bodies.size(); ++i)
      if (work.share.holds(bodies[i]))
        work_on(state.bodies[bodies[i]], i);
  };
  // All are looked at before any changes, so that a body that has left the mesh ends the run with a good
  // state.
  std::vector<std::vector<dealii::Point<2>>> places(bodies.size());
  work.share.exchange.together(
      [&]()
      {
        for (unsigned int i = 0; i < bodies.size(); ++i)
        {
          const Body<2> &body = state.bodies[bodies[i]];
          if (work.share.holds(body.index))
            places[i] = places_reached(body, *problem.lattice);
          check_markers(body, *problem.lattice);
        }
      });
  share_trial_volumes(bodies);
  for (const unsigned int b : bodies)
    state.bodies[b].boundary.grid_position = state.bodies[b].boundary.position;
  work.share.exchange.together(
      [&]()
      {
        for_held([&](Body<2> &body, const unsigned int i)
                 { leave_grid(body, work.trial[body.index], places[i], context); });
        state.points->sort();
        state.order_points();
        for_held([&](Body<2> &body, unsigned int) { lay_grid(body, context); });
      });
  share_grids(bodies);
}

std::vector<double> MpmModel::grid_distortions() const
{
  std::vector<double> distortion(state.bodies.size(), 1.);
  if (problem.settings.grid_update != GridUpdate::distortion)
    return distortion;
  work.share.for_mine(
      state.bodies,
      [&](const Body<2> &body) { distortion[body.index] = grid_distortion(work.trial[body.index]); },
      [&](BodyShare::Message &message) { message.add(distortion); });
  return distortion;
}

void MpmModel::bring_into_cell(Body<2> &body) const
{
  if (!state.repeats())
    return;
  const PeriodicCell<2> cell = cell_of(state.walls);
  const PeriodicCell<2>::Image image = cell.image_of(body.center());
  if (image == PeriodicCell<2>::Image())
    return;
  for (unsigned int d = 0; d < 2; ++d)
    body.home[d] += image[d];
  body.translate(-cell.shift(image));
  if (body.field.markers().size() > 0)
    move_boundary(body);
}
} // namespace softgrain::mpm
