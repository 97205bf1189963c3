// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_rows.h>

#include <cstdint>
#include <utility>

namespace softgrain::mpm
{
namespace
{
/// Where a row is in the cell that repeats.
void place_in_cell(const FrameScene<2> &scene, const FrameState<2> &frame, ContactRow<2> &row)
{
  const Body<2> &body = scene.bodies[row.body];
  const dealii::Point<2> center = body.center();
  row.cell.branch = frame.body(0) == FrameState<2>::none
                        ? center - row.place
                        : center - (scene.bodies[row.partner].center() + frame.image_shift());
  row.cell.image = frame.layout().image;
  const PeriodicCell<2>::Image fold = scene.cell->cell.image_of(center);
  row.place -= scene.cell->cell.shift(fold);
  for (unsigned int d = 0; d < 2; ++d)
    row.cell.fold[d] = fold[d] + body.home[d];
}
} // namespace

template <int dim>
std::shared_ptr<const NodeWeights> weights_of(const PlaceFunctions<dim> &function)
{
  NodeWeights weights;
  weights.node.assign(function.node.begin(), function.node.end());
  weights.weight.assign(function.value.begin(), function.value.end());
  return std::move(weights).shared();
}

template <int dim>
void tell_row(const FrameScene<dim> &scene,
              const FrameState<dim> &frame,
              const unsigned int k,
              ContactRow<dim> &row)
{
  const dealii::Tensor<1, dim> resultant = frame.derivatives().resultant(k);
  row.gap = frame.ray(k).at_start / resultant.norm();
  row.law.softness = frame.conditions().ray_softness() / resultant.norm_square();
  row.law.friction = frame.conditions().rubs(k) ? frame.conditions().friction_coefficient() : 0.;
  for (const unsigned int side : {0, 1})
    if (const unsigned int b = frame.unknown(side); b != FrameState<dim>::none)
    {
      // Who owns neither knows the place only.
      const RaySide<dim> &there = frame.ray(k).side[side];
      (side == 0 ? row.weights.partner : row.weights.body) =
          weights_of(there.function.node.empty() ? scene.bodies[b].field.functions_at(there.place.position)
                                                 : there.function);
    }
}

ContactRow<2> row_of_ray(const FrameScene<2> &scene, const FrameState<2> &frame, const unsigned int k)
{
  const ContactFrame<2> &layout = frame.layout();
  const FrameState<2>::RayHere &ray = frame.ray(k);
  ContactRow<2> row;
  row.body = layout.body;
  row.partner = layout.partner;
  row.wall = layout.wall;
  if (const RigidRays<2> *line = scene.line_of(frame.layout()))
    row.velocity_of_place = line->way_of(ray.side[0].place) / scene.dt;
  if (layout.partner != FrameState<2>::none && scene.bodies[layout.partner].rigid.driven)
    row.wall = scene.bodies[layout.partner].rigid.wall;
  const dealii::Tensor<1, 2> resultant = frame.derivatives().resultant(k);
  const double length = resultant.norm();
  row.normal = resultant / length;
  row.law.pull = ray.held.pull * length;
  const double offset = layout.rays[k].index[0] * layout.spacing + frame.derivatives().motion()[0];
  row.place = layout.origin + offset * layout.across[0] + ray.side[1].height * layout.direction;
  row.length = layout.spacing * length; // of outline
  if (scene.cell != nullptr)
    place_in_cell(scene, frame, row);
  // Rows of a frame have all but their place in common.
  row.key = (layout.id << 40) + (static_cast<std::uint64_t>(layout.rays[k].index[0] & 0xffff) << 24);
  return row;
}

std::vector<ContactRow<2>> rows_of_frames(const FrameScene<2> &scene,
                                          const std::vector<FrameState<2>> &frames,
                                          const RayForces &force,
                                          const RayFriction<2> &rubbing,
                                          ContactMemory<2> &memory)
{
  std::vector<ContactRow<2>> rows;
  for (unsigned int f = 0; f < frames.size(); ++f)
  {
    const FrameState<2> &frame = frames[f];
    for (unsigned int k = 0; k < frame.n_rays(); ++k)
    {
      if (force[f][k] == 0.)
        continue;
      const FrameState<2>::RayHere &ray = frame.ray(k);
      ContactRow<2> row = row_of_ray(scene, frame, k);
      dealii::Tensor<1, 2> given = force[f][k] * frame.derivatives().resultant(k);
      row.gap = ray.at_start;
      row.beyond.work = force[f][k] * ray.beyond;
      row.beyond.pull = -ray.held.pull * ray.beyond;
      if (frame.conditions().rubs(k))
      {
        // Friction does its work between the places that it holds together.
        row.normal = dealii::Tensor<1, 2>({-ray.rub.e[0][1], ray.rub.e[0][0]});
        row.law.friction = frame.conditions().friction_coefficient();
        if (const RigidRays<2> *line = scene.line_of(frame.layout()))
          row.velocity_of_place = line->way_of(ray.rub.start[0]) / scene.dt;
        given += frame.ray(k).rub.in_space(rubbing[f][k]);
      }
      row.weights.body = weights_of(frame.conditions().rubs(k) ? ray.rub.hold[1] : ray.side[1].function);
      if (frame.unknown(0) != FrameState<2>::none)
        row.weights.partner = weights_of(frame.conditions().rubs(k) ? ray.rub.hold[0] : ray.side[0].function);
      memory.impulses[row.key] = {
          {given * direction_of(row, 0) * memory.step, given * direction_of(row, 1) * memory.step}};
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

template std::shared_ptr<const NodeWeights> weights_of(const PlaceFunctions<2> &);
template std::shared_ptr<const NodeWeights> weights_of(const PlaceFunctions<3> &);
template void tell_row(const FrameScene<2> &, const FrameState<2> &, unsigned int, ContactRow<2> &);
template void tell_row(const FrameScene<3> &, const FrameState<3> &, unsigned int, ContactRow<3> &);
} // namespace softgrain::mpm
