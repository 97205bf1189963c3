// SPDX-License-Identifier: LGPL-2.1-or-later
// Where frames stand and how they are turned.
#include <softgrain/mpm/contact/frame_layout.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
/// To where slopes are 0, a cell at most.
template <int n>
dealii::Tensor<1, n>
way_to_nearest(const dealii::Tensor<1, n> &slope, const dealii::Tensor<2, n> &bend, const double cell_size)
{
  dealii::Tensor<1, n> way;
  if constexpr (n == 1)
    way[0] = std::clamp(-slope[0] / bend[0][0], -cell_size, cell_size);
  else
  {
    way = -1. * (invert(bend) * slope);
    way *= std::min(1., cell_size / std::max(way.norm(), 1e-300));
  }
  return way;
}

/// Whether a gap has one nearest place. Where it turns by no more than rounding over a cell, as of a flat
/// side along a wall, rounding alone would say where that is.
template <int n>
bool is_bowl(const dealii::Tensor<2, n> &bend, const double cell_size)
{
  const double flat = 1e-9 / cell_size;
  if constexpr (n == 1)
    return bend[0][0] > flat;
  else
    return bend[0][0] > flat && bend[1][1] > flat &&
           (bend[0][0] - flat) * (bend[1][1] - flat) > bend[0][1] * bend[1][0];
}

/// Where the forces of a frame have their middle, from its origin [m].
template <int dim>
dealii::Tensor<1, dim - 1> middle_of_forces(const ContactFrame<dim> &frame)
{
  dealii::Tensor<1, dim - 1> middle;
  double sum = 0.;
  for (const auto &ray : frame.rays)
  {
    middle += std::abs(ray.force) * frame.offset(ray.index);
    sum += std::abs(ray.force);
  }
  return sum > 0. ? middle / sum : middle;
}

/// Moves a frame across its rays. @param way [m]
template <int dim>
void move_across(const dealii::Tensor<1, dim - 1> &way, ContactFrame<dim> &frame)
{
  for (unsigned int m = 0; m < dim - 1; ++m)
    frame.origin += way[m] * frame.across[m];
}
} // namespace

template <int dim>
RaySide<dim> FrameLayout<dim>::meet_surface(const ContactFrame<dim> &frame,
                                            const unsigned int side,
                                            const Across &offset,
                                            const SurfacePlace<dim> &guess,
                                            const bool bends) const
{
  const Ray<dim> ray = ray_of(frame, offset, away(side));
  const unsigned int b = side == 0 ? frame.partner : frame.body;
  if (b == ContactFrame<dim>::none)
    return scene.line_of(frame)->meet(ray, 0., guess);
  return meet(ray, scene.outlines[b], scene.bodies[b].field, scene.bodies[b].nodes.displacement, guess,
              bends);
}

/// What the ray at the origin meets. @param place near where it does
template <int dim>
std::optional<typename FrameLayout<dim>::Met> FrameLayout<dim>::meet_both(const ContactFrame<dim> &frame,
                                                                          Places &place) const
{
  const bool wall = partner == nullptr;
  Met met;
  met.gap = wall ? (frame.origin - scene.walls[frame.wall].point) * frame.direction : 0.;
  for (unsigned int side = wall ? 1 : 0; side < 2; ++side)
  {
    const RaySide<dim> found = meet_surface(frame, side, Across(), place[side], true);
    if (!found.met)
      return std::nullopt;
    place[side] = found.place;
    const double sign = side == 0 ? -1. : 1.;
    for (unsigned int m = 0; m < dim - 1; ++m)
    {
      met.slope[m] -= sign * (found.normal * frame.across[m]);
      for (unsigned int n = 0; n < dim - 1; ++n)
        met.bend[m][n] += sign * (frame.across[m] * (found.sliding_twice * frame.across[n]));
    }
    met.height += (wall ? 1. : 0.5) * found.height;
    met.gap += sign * found.height;
    met.normal += found.normal / found.normal.norm();
  }
  return met;
}

/// Puts the origin of a frame to the middle of the samples that are nearest to each other. Of a side along a
/// wall all are. @return the places of those closest to it
template <int dim>
typename FrameLayout<dim>::Places FrameLayout<dim>::begin_at_samples(const FrameStretch<dim> &stretch,
                                                                     ContactFrame<dim> &frame) const
{
  const bool wall = partner == nullptr;
  const auto gap_of = [&](const auto &pair)
  {
    const dealii::Point<dim> &x = body.samples[pair[1]].position;
    return wall ? (x - scene.walls[frame.wall].point) * frame.direction
                : x.distance(partner->samples[pair[0]].position);
  };
  const auto middle_of = [&](const auto &pair)
  {
    const dealii::Point<dim> &x = body.samples[pair[1]].position;
    return wall ? x : x + 0.5 * (partner->samples[pair[0]].position - x);
  };
  double nearest = std::numeric_limits<double>::max();
  for (const auto &pair : stretch.facing)
    nearest = std::min(nearest, gap_of(pair));
  Vector sum;
  unsigned int n_nearest = 0;
  for (const auto &pair : stretch.facing)
    if (gap_of(pair) <= nearest + same_gap(scene))
    {
      sum += middle_of(pair) - dealii::Point<dim>();
      ++n_nearest;
    }
  frame.origin = dealii::Point<dim>(sum / n_nearest);
  Places places;
  double closest = std::numeric_limits<double>::max();
  for (const auto &pair : stretch.facing)
    if (const double way = middle_of(pair).distance(frame.origin);
        gap_of(pair) <= nearest + same_gap(scene) && way < closest)
    {
      closest = way;
      if (!wall)
        places[0] = partner->samples[pair[0]].place;
      places[1] = body.samples[pair[1]].place;
    }
  return places;
}

/// Places from which the middle is looked for: from a corner there is no way to the side beyond it, so there
/// they are on both.
template <int dim>
std::vector<typename FrameLayout<dim>::Places>
FrameLayout<dim>::on_both_sides_of_corners(const Places &places, const ContactFrame<dim> &frame) const
{
  std::vector<Places> starts(1, places);
  for (unsigned int side = partner == nullptr ? 1 : 0; side < 2; ++side)
    if (places[side].at_edge)
      for (unsigned int s = 0, n = starts.size(); s < n; ++s)
      {
        starts.push_back(starts[s]);
        starts.back()[side] = surface_of(scene, frame, side).beyond_edge(places[side]);
      }
  return starts;
}

template <int dim>
void FrameLayout<dim>::center(const FrameStretch<dim> &stretch, ContactFrame<dim> &frame) const
{
  const std::vector<Places> starts = on_both_sides_of_corners(begin_at_samples(stretch, frame), frame);
  if (starts.size() == 1)
  {
    find_middle(starts.front(), frame);
    return;
  }
  note_dent(starts.front(), frame);
  const ContactFrame<dim> at_samples = frame;
  double least = std::numeric_limits<double>::max();
  for (const Places &start : starts)
  {
    ContactFrame<dim> tried = at_samples;
    if (const std::optional<double> gap = find_middle(start, tried); gap && *gap < least)
    {
      least = *gap;
      frame = std::move(tried);
    }
  }
}

/// Moves a frame to where both are nearest, from places on both. @return the gap there, nothing if there is
/// none
template <int dim>
std::optional<double> FrameLayout<dim>::find_middle(Places place, ContactFrame<dim> &frame) const
{
  const bool wall = partner == nullptr;
  const dealii::Point<dim> first = frame.origin;
  note_dent(place, frame);
  double gap = 0.;
  for (unsigned int iteration = 0; iteration < 6; ++iteration)
  {
    const std::optional<Met> met = meet_both(frame, place);
    if (!met || !is_bowl(met->bend, scene.cell_size))
      return std::nullopt;
    gap = met->gap;
    const Across way = way_to_nearest(met->slope, met->bend, scene.cell_size);
    Vector moved = way[0] * frame.across[0];
    if constexpr (dim == 3)
      moved += way[1] * frame.across[1];
    frame.origin += moved + (wall ? 0. : met->height) * frame.direction;
    if (!wall)
      mpm::turn(frame, met->normal / met->normal.norm());
    note_dent(place, frame);
    if (way.norm() < 1e-10 * scene.cell_size)
      break;
    if (frame.origin.distance(first) > 2. * scene.cell_size)
      return std::nullopt;
  }
  return gap;
}

template <int dim>
void FrameLayout<dim>::turn(const Vector &direction, ContactFrame<dim> &frame) const
{
  const Across middle = middle_of_forces(frame);
  Places place = std::min_element(frame.rays.begin(), frame.rays.end(),
                                  [&](const auto &a, const auto &b) {
                                    return (frame.offset(a.index) - middle).norm() <
                                           (frame.offset(b.index) - middle).norm();
                                  })
                     ->place;
  move_across(middle, frame);
  if (const std::optional<Met> met = meet_both(frame, place))
    frame.origin += met->height * frame.direction;
  mpm::turn(frame, direction);
  move_across(-1. * middle, frame);
}

/// Where on the grids of both the frame begins.
template <int dim>
void FrameLayout<dim>::note_dent(const Places &place, ContactFrame<dim> &frame) const
{
  for (unsigned int side = 0; side < 2; ++side)
  {
    const unsigned int b = side == 0 ? frame.partner : frame.body;
    if (b != ContactFrame<dim>::none && SubgridLaw<dim>::is_round(scene.bodies[b]))
      frame.log_full_width[1 - side] = scene.subgrid.log_full_width(
          scene.bodies[b].material.law->poisson_ratio(), place[side].position, place[side].normal);
  }
}

template void FrameLayout<2>::center(const FrameStretch<2> &, ContactFrame<2> &) const;
template void FrameLayout<3>::center(const FrameStretch<3> &, ContactFrame<3> &) const;
template void FrameLayout<2>::turn(const Vector &, ContactFrame<2> &) const;
template void FrameLayout<3>::turn(const Vector &, ContactFrame<3> &) const;
template RaySide<2> FrameLayout<2>::meet_surface(
    const ContactFrame<2> &, unsigned int, const Across &, const SurfacePlace<2> &, bool) const;
template RaySide<3> FrameLayout<3>::meet_surface(
    const ContactFrame<3> &, unsigned int, const Across &, const SurfacePlace<3> &, bool) const;
} // namespace softgrain::mpm
