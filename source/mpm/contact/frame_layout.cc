// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_layout.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
using Frame = ContactFrame<2>;
using Vector = dealii::Tensor<1, 2>;
using Point = dealii::Point<2>;

constexpr double steepest = 2.;         ///< slope of a surface over the lattice
constexpr double deepest = 0.5;         ///< overlap of surfaces that meet [cells]
constexpr double beside_corners = 0.05; ///< no new ray meets a side nearer to a corner [cells]
constexpr unsigned int tries = 4;       ///< places from which a ray looks for a surface
} // namespace

/// From a corner there is no way to the side beyond it, so it is a guess on both.
FrameLayout::Guesses
FrameLayout::guesses_of(const FrameStretch &stretch, const Frame &frame, const unsigned int side) const
{
  Guesses guesses;
  for (const auto &pair : stretch.facing)
    if (pair[side] != Frame::none)
    {
      const auto &sample = surface(side).samples[pair[side]];
      const double y = (sample.position - frame.origin) * frame.across[0];
      guesses.emplace_back(y, sample.place);
      if (sample.place.at_edge)
        guesses.emplace_back(y, scene.surface_of(frame, side).beyond_edge(sample.place));
    }
  return guesses;
}

/// Whether the ray meets the outside of the surface near a guess.
bool FrameLayout::meet_from(const SurfacePlace<2> &guess,
                            const Frame &frame,
                            const unsigned int side,
                            Frame::RayPlace &ray,
                            double &height) const
{
  const RaySide<2> found = meet_surface(frame, side, ray.index[0] * frame.spacing, guess);
  if (!found.met)
    return false;
  ray.place[side] = found.place;
  height = found.height;
  const double outwards = (side == 0 ? 1. : -1.) * (found.way[0] * frame.across[0]);
  return outwards > 0. && std::abs(found.normal * frame.across[0]) < steepest;
}

RaySide<2> FrameLayout::meet_surface(const Frame &frame,
                                     const unsigned int side,
                                     const double offset,
                                     const SurfacePlace<2> &guess) const
{
  const Ray<2> ray = ray_of(frame, offset, away(side));
  const unsigned int b = side == 0 ? frame.partner : frame.body;
  if (b == Frame::none)
    return scene.line_of(frame)->meet(ray, 0., guess);
  return meet(ray, scene.outlines[b], scene.bodies[b].field, scene.bodies[b].displacement, guess);
}

/// Where a ray meets a side. @param old the same ray before, if there was one
bool FrameLayout::meet_side(const FrameStretch &stretch,
                            const Frame &frame,
                            const unsigned int side,
                            const Guesses &guesses,
                            const Frame::RayPlace *old,
                            Frame::RayPlace &ray,
                            double &height) const
{
  if (side == 0 && partner == nullptr)
  {
    height = (scene.walls[frame.wall].point - frame.origin) * frame.direction;
    return true;
  }
  if (side == stretch.corner)
  {
    const auto &corner = surface(side).samples[stretch.facing.front()[side]];
    ray.place[side] = corner.place;
    height = (corner.position - frame.origin) * frame.direction;
    return true;
  }
  if (old != nullptr && meet_from(old->place[side], frame, side, ray, height))
    return true;
  const double offset = ray.index[0] * frame.spacing;
  Guesses by_distance = guesses;
  std::stable_sort(by_distance.begin(), by_distance.end(),
                   [&](const auto &x, const auto &y)
                   { return std::abs(x.first - offset) < std::abs(y.first - offset); });
  for (unsigned int i = 0; i < std::min<std::size_t>(tries, by_distance.size()); ++i)
    if (meet_from(by_distance[i].second, frame, side, ray, height) &&
        (stretch.corner != Frame::none || !near_corner(frame, side, ray.place[side])))
      return true;
  return false;
}

/// Corners have rays of their own.
bool FrameLayout::near_corner(const Frame &frame, const unsigned int side, const SurfacePlace<2> &place) const
{
  const RestSurface<2> &surface = scene.surface_of(frame, side);
  dealii::Tensor<1, 1> way;
  way[0] = beside_corners * scene.cell_size;
  return surface.move(place, way).at_edge || surface.move(place, -way).at_edge;
}

void FrameLayout::lay(const FrameStretch &stretch, Frame &frame) const
{
  const Vector t = frame.across[0];
  double lower = std::numeric_limits<double>::max(), upper = -lower;
  std::array<Guesses, 2> guesses;
  for (unsigned int side = 0; side < 2; ++side)
    guesses[side] = guesses_of(stretch, frame, side);
  for (const auto &pair : stretch.facing)
    for (unsigned int side = 0; side < 2; ++side)
      if (pair[side] != Frame::none)
      {
        const auto &sample = surface(side).samples[pair[side]];
        const double y = (sample.position - frame.origin) * t;
        lower = std::min(lower, y);
        upper = std::max(upper, y);
      }
  std::vector<Frame::RayPlace> rays;
  const bool one = stretch.corner != Frame::none;
  const int first = one ? 0 : std::ceil(lower / frame.spacing - 0.5),
            last = one ? 0 : std::floor(upper / frame.spacing + 0.5);
  for (int k = first; k <= last; ++k)
  {
    Frame::RayPlace place;
    place.index[0] = k;
    const auto old = std::find_if(frame.rays.begin(), frame.rays.end(),
                                  [&](const Frame::RayPlace &r) { return r.index[0] == k; });
    bool met = true;
    std::array<double, 2> height{};
    for (unsigned int side = 0; side < 2 && met; ++side)
      met = meet_side(stretch, frame, side, guesses[side], old == frame.rays.end() ? nullptr : &*old, place,
                      height[side]);
    if (!met)
      continue;
    if (old != frame.rays.end())
    {
      place.force = old->force;
      place.friction = old->friction;
      place.memory = old->memory;
      place.pull = old->pull;
    }
    const double gap = height[1] - height[0];
    // No step ends with bodies as deep in each other: what looks so is the far side of a thin body.
    if ((gap > scene.reach_of(frame) || gap < -deepest * scene.cell_size) && place.force <= 0.)
      continue;
    rays.push_back(place);
  }
  frame.rays = std::move(rays);
}

void FrameLayout::center(const FrameStretch &stretch, Frame &frame) const
{
  const bool wall = partner == nullptr;
  std::array<const SurfacePlace<2> *, 2> guess{};
  double nearest = std::numeric_limits<double>::max();
  for (const auto &pair : stretch.facing)
  {
    const auto &of_body = body.samples[pair[1]];
    const double gap = wall ? (of_body.position - scene.walls[frame.wall].point) * frame.direction
                            : of_body.position.distance(partner->samples[pair[0]].position);
    if (gap >= nearest)
      continue;
    nearest = gap;
    guess = {{wall ? nullptr : &partner->samples[pair[0]].place, &of_body.place}};
    frame.origin = of_body.position;
    if (!wall)
      frame.origin += 0.5 * (partner->samples[pair[0]].position - of_body.position);
  }
  const Point first = frame.origin;
  std::array<SurfacePlace<2>, 2> place;
  for (unsigned int side = wall ? 1 : 0; side < 2; ++side)
    place[side] = *guess[side];
  note_dent(place, frame);
  for (unsigned int iteration = 0; iteration < 6; ++iteration)
  {
    const Vector &t = frame.across[0];
    double slope = 0., bend = 0., height = 0.;
    Vector normal;
    for (unsigned int side = wall ? 1 : 0; side < 2; ++side)
    {
      const RaySide<2> found = meet_surface(frame, side, 0., place[side]);
      if (!found.met)
        return;
      place[side] = found.place;
      const double sign = side == 0 ? -1. : 1.;
      slope -= sign * (found.normal * t);
      bend += sign * (t * (found.sliding_twice * t));
      height += (wall ? 1. : 0.5) * found.height;
      normal += found.normal / found.normal.norm();
    }
    if (!(bend > 0.))
      return;
    const double way = std::clamp(-slope / bend, -scene.cell_size, scene.cell_size);
    frame.origin += way * t + (wall ? 0. : height) * frame.direction;
    if (!wall)
    {
      frame.direction = normal / normal.norm();
      frame.across[0] = Vector({frame.direction[1], -frame.direction[0]});
    }
    note_dent(place, frame);
    if (std::abs(way) < 1e-10 * scene.cell_size)
      break;
    if (frame.origin.distance(first) > 2. * scene.cell_size)
      return;
  }
}

/// Where on the grids of both the frame begins.
void FrameLayout::note_dent(const std::array<SurfacePlace<2>, 2> &place, Frame &frame) const
{
  for (unsigned int side = 0; side < 2; ++side)
  {
    const unsigned int b = side == 0 ? frame.partner : frame.body;
    if (b != Frame::none && SubgridCompliance::is_round(scene.bodies[b]))
      frame.log_full_width[1 - side] = scene.subgrid.log_full_width(scene.bodies[b].law->poisson_ratio(),
                                                                    place[side].position, place[side].normal);
  }
}
} // namespace softgrain::mpm
