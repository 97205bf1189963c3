// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_following.h>
#include <softgrain/mpm/contact/obstacle_line.h>
#include <softgrain/mpm/contact/plane_compliance.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
using Frame = ContactFrame<2>;

constexpr double farthest = 0.5;     ///< by which a frame is moved in a step [cells]
constexpr double same_within = 1e-8; ///< gaps [cells]

/// The strongest ray becomes the ray 0. @return its places
std::array<SurfacePlace<2>, 2> number_from_strongest(Frame &frame)
{
  const Frame::RayPlace strongest = *std::max_element(frame.rays.begin(), frame.rays.end(),
                                                      [](const Frame::RayPlace &a, const Frame::RayPlace &b)
                                                      { return std::abs(a.force) < std::abs(b.force); });
  frame.origin += strongest.index[0] * frame.spacing * frame.across[0];
  for (Frame::RayPlace &ray : frame.rays)
    ray.index[0] -= strongest.index[0];
  return strongest.place;
}
} // namespace

/// @param place near where the ray meets
std::optional<FrameFollowing::Met>
FrameFollowing::meet_both(const Frame &frame, const When when, Places &place) const
{
  const bool wall = at_wall(frame);
  std::array<double, 2> height{};
  Met met;
  if (wall)
    height[0] = (scene.walls[frame.wall].point - frame.origin) * frame.direction;
  for (unsigned int side = wall ? 1 : 0; side < 2; ++side)
  {
    const unsigned int b = side == 0 ? frame.partner : frame.body;
    Vector away = side == 0 ? apart : Vector();
    if (when == When::halfway && b != Frame::none)
      away += half_carried(side, frame);
    const Ray<2> ray = ray_of(frame, dealii::Tensor<1, 1>(), away);
    const RaySide<2> found =
        b == Frame::none
            ? scene.line_of(frame)->meet(ray, when == When::now ? 0. : 0.5, place[side])
            : meet(ray, scene.outlines[b], scene.bodies[b].field,
                   when == When::now ? scene.bodies[b].displacement : (*scene.halfway)[b], place[side]);
    if (!found.met)
      return std::nullopt;
    const double sign = side == 0 ? -1. : 1.;
    const Vector &t = frame.across[0];
    place[side] = found.place;
    height[side] = found.height;
    met.normal += found.normal / found.normal.norm();
    met.slope -= sign * (found.normal * t);
    met.bend += sign * (t * (found.sliding_twice * t));
  }
  met.normal /= met.normal.norm();
  met.gap = height[1] - height[0];
  met.height = wall ? height[1] : 0.5 * (height[0] + height[1]);
  return met;
}

/// Moves a frame to where the gap is least, and turns it to the normals there. @return how the gap bends
/// there
std::optional<double> FrameFollowing::find_middle(Frame &frame, const When when, Places &place) const
{
  const dealii::Point<2> first = frame.origin;
  for (unsigned int iteration = 0; iteration < 6; ++iteration)
  {
    const std::optional<Met> met = meet_both(frame, when, place);
    if (!met || !(met->bend > 0.))
      return std::nullopt;
    const double way = std::clamp(-met->slope / met->bend, -scene.cell_size, scene.cell_size);
    frame.origin += way * frame.across[0];
    turn_about(*met, met->normal, frame);
    if (std::abs(way) < 1e-10 * scene.cell_size)
      return met->bend;
    if (frame.origin.distance(first) > 2. * scene.cell_size)
      return std::nullopt;
  }
  return std::nullopt;
}

/// Turns a frame about where its ray 0 meets surfaces; those of walls stay.
void FrameFollowing::turn_about(const Met &met, const Vector &direction, Frame &frame) const
{
  frame.origin += met.height * frame.direction;
  if (!at_wall(frame))
    frame.turn(direction);
}

/// By which a side moves beside what its nodes do until the step is half over [m].
FrameFollowing::Vector FrameFollowing::half_carried(const unsigned int side, const Frame &frame) const
{
  Vector way;
  if (!scene.carried.empty())
    way = 0.5 * scene.carried[side == 0 ? frame.partner : frame.body];
  if (side == 0 && scene.cell != nullptr)
    way += 0.5 * scene.dt * (scene.cell->gradient * apart);
  return way;
}

/// Of the frame across its rays until the step is half over, by the velocities of the bodies [m].
double FrameFollowing::half_motion(const Frame &frame, const Places &place) const
{
  const bool known = frame.partner == Frame::none || scene.bodies[frame.partner].driven;
  double motion = 0.;
  for (unsigned int side = known ? 1 : 0; side < 2; ++side)
  {
    const Body<2> &of_side = scene.bodies[side == 0 ? frame.partner : frame.body];
    const PlaceFunctions<2> function = of_side.field.functions_at(place[side].position);
    const Vector way = function.at((*scene.halfway)[of_side.index]) - function.at(of_side.displacement) +
                       half_carried(side, frame);
    motion += (known ? 1. : 0.5) * (way * frame.across[0]);
  }
  return motion;
}

/// Whether a contact of a round body is narrower than the distance of rays, by Hertz's law:
/// a = √(4 F / π E* κ). A side that is pressed flat has no middle.
bool FrameFollowing::is_narrow(const Frame &frame, const double curvature) const
{
  double force = 0., compliance = 0.;
  bool round = false;
  for (const Frame::RayPlace &ray : frame.rays)
    force += std::max(0., ray.force);
  for (const unsigned int b : {frame.body, frame.partner})
    if (b != Frame::none)
    {
      round = round || SubgridCompliance::is_round(scene.bodies[b]);
      compliance += plane_compliance(scene.bodies[b]);
    }
  return round && 4. * force * compliance < M_PI * curvature * 0.25 * frame.spacing * frame.spacing;
}

void FrameFollowing::follow(Frame &frame) const
{
  Frame moved = frame;
  Places place = number_from_strongest(moved), place_now = place, place_halfway = place;
  const Vector t = frame.across[0];
  Frame now = moved, halfway = moved;
  halfway.origin += half_motion(halfway, place) * t;
  const std::optional<double> curvature = find_middle(now, When::now, place_now);
  if (!curvature || !is_narrow(now, *curvature) || !find_middle(halfway, When::halfway, place_halfway))
    return;
  const double other = 2. * (now.origin - moved.origin) * t,
               wanted = (halfway.origin - moved.origin) * t - half_motion(halfway, place_halfway),
               near = farthest * scene.cell_size;
  std::optional<Met> met = meet_both(moved, When::now, place);
  if (!met || std::abs(other) > near || std::abs(wanted) > near)
    return;
  if (std::abs(wanted - other) < std::abs(wanted))
    go_to_gap(other, place, moved, *met);
  turn_about(*met, halfway.direction, moved);
  frame = std::move(moved);
}

/// Moves a frame to where the gap is the same on the other side of where it is least: surfaces that are round
/// are as far from there as before.
/// @param guess of the way [m]
void FrameFollowing::go_to_gap(const double guess, Places place, Frame &frame, Met &met) const
{
  Frame there = frame;
  double way = guess;
  for (unsigned int attempt = 0; attempt < 4; ++attempt)
  {
    there.origin = frame.origin + way * frame.across[0];
    const std::optional<Met> found = meet_both(there, When::now, place);
    if (!found)
      return;
    if (std::abs(found->gap - met.gap) < same_within * scene.cell_size)
    {
      frame = std::move(there);
      met = *found;
      // The lattice is the mirror image of what it was.
      for (Frame::RayPlace &ray : frame.rays)
        ray.index[0] *= -1;
      std::reverse(frame.rays.begin(), frame.rays.end());
      return;
    }
    way -= (found->gap - met.gap) / found->slope;
    if (!(std::abs(way - guess) < 0.5 * std::abs(guess)))
      return;
  }
}

void FrameFollowing::turn(const Vector &direction, Frame &frame) const
{
  Places place = number_from_strongest(frame);
  for (unsigned int iteration = 0; iteration < 3; ++iteration)
  {
    const std::optional<Met> met = meet_both(frame, When::now, place);
    turn_about(met.value_or(Met()), iteration == 0 || !met ? direction : met->normal, frame);
  }
}
} // namespace softgrain::mpm
