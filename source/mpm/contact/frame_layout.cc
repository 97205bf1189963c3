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

/// Of straight sides, which have no more shapes than there are cells along them.
constexpr double spacing_at_straight_sides = 0.85;
constexpr double straight = 1e-3; ///< curvature at rest, per cell
///< cosine of 11 degrees
constexpr double steepest = 2.; ///< slope of a surface over the lattice
} // namespace

/// Where a ray meets a side. @param old the same ray before, if there was one
bool FrameLayout::meet_side(const FrameStretch &stretch,
                            const Frame &frame,
                            const unsigned int side,
                            const Guesses &guesses,
                            const Frame::RayPlace *old,
                            Frame::RayPlace &ray,
                            double &height) const
{
  const unsigned int b = side == 0 ? frame.partner : frame.body;
  if (b == Frame::none)
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
  const double offset = ray.index[0] * frame.spacing;
  const SurfacePlace<2> *guess = old == nullptr ? nullptr : &old->place[side];
  if (guess == nullptr)
  {
    double best = std::numeric_limits<double>::max();
    for (const auto &[y, at] : guesses)
      if (std::abs(y - offset) < best)
      {
        best = std::abs(y - offset);
        guess = at;
      }
  }
  if (guess == nullptr)
    return false;
  const RaySide<2> found = meet(ray_of(frame, offset, away(side)), scene.outlines[b], scene.bodies[b].field,
                                scene.bodies[b].displacement, *guess);
  ray.place[side] = found.place;
  height = found.height;
  return found.met && std::abs(found.normal * frame.across[0]) < steepest;
}

void FrameLayout::lay(const FrameStretch &stretch, Frame &frame) const
{
  const Vector t = frame.across[0];
  double lower = std::numeric_limits<double>::max(), upper = -lower;
  std::array<Guesses, 2> guesses;
  for (const auto &pair : stretch.facing)
    for (unsigned int side = 0; side < 2; ++side)
      if (pair[side] != Frame::none)
      {
        const auto &sample = surface(side).samples[pair[side]];
        const double y = (sample.position - frame.origin) * t;
        lower = std::min(lower, y);
        upper = std::max(upper, y);
        // From a corner there is no way to the other side of it.
        if (sample.corner == 0.)
          guesses[side].emplace_back(y, &sample.place);
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
    }
    if (height[1] - height[0] > scene.reach && place.force == 0.)
      continue;
    rays.push_back(place);
  }
  frame.rays = std::move(rays);
}

void FrameLayout::center(const FrameStretch &stretch, Frame &frame) const
{
  const bool wall = frame.partner == Frame::none;
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
  if (std::all_of(place.begin() + (wall ? 1 : 0), place.end(),
                  [&](const SurfacePlace<2> &p)
                  { return std::abs(p.bend[0][0]) * scene.cell_size < straight; }))
    frame.spacing = spacing_at_straight_sides * scene.cell_size;
  for (unsigned int iteration = 0; iteration < 6; ++iteration)
  {
    const Vector &t = frame.across[0];
    double slope = 0., bend = 0., height = 0.;
    Vector normal;
    for (unsigned int side = wall ? 1 : 0; side < 2; ++side)
    {
      const unsigned int b = side == 0 ? frame.partner : frame.body;
      const RaySide<2> found = meet(ray_of(frame, 0., away(side)), scene.outlines[b], scene.bodies[b].field,
                                    scene.bodies[b].displacement, place[side]);
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
