// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_stretches.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace softgrain::mpm
{
namespace
{
using Frame = ContactFrame<2>;
using Vector = dealii::Tensor<1, 2>;
using Point = dealii::Point<2>;

constexpr double facing_plane = 0.5; ///< least cosine between an outline's normal and what it faces
} // namespace

SampledSurface<2> sample_outline(const Body<2> &body, const OutlineSurface &outline)
{
  SampledSurface<2> surface;
  const Boundary<2> &boundary = body.boundary;
  const unsigned int stride = std::max(1u, boundary.contact_stride);
  for (unsigned int l = 0; l < boundary.n_loops(); ++l)
  {
    const unsigned int begin = boundary.loop_start[l], end = boundary.loop_start[l + 1],
                       first = surface.samples.size();
    for (unsigned int m = begin; m < end; ++m)
    {
      if ((m - begin) % stride != 0 && !boundary.corner[m])
        continue;
      const Point &x = boundary.position[m];
      Vector before = x - boundary.position[boundary.previous(m)],
             after = boundary.position[boundary.next(m)] - x;
      before /= before.norm();
      after /= after.norm();
      Vector t = before + after;
      t /= t.norm();
      SampledSurface<2>::Sample s;
      s.position = x;
      s.normal = Vector({t[1], -t[0]});
      // What is a dent has no cone of normals.
      if (boundary.corner[m] && before[0] * after[1] > before[1] * after[0])
        s.corner = 0.5 * std::acos(std::clamp(before * after, -1., 1.));
      s.place = outline.at(m, 0.);
      surface.samples.push_back(s);
    }
    for (unsigned int i = first; i < surface.samples.size(); ++i)
    {
      const unsigned int j = i + 1 < surface.samples.size() ? i + 1 : first;
      surface.neighbours.emplace_back(i, j);
      surface.spacing =
          std::max(surface.spacing, surface.samples[i].position.distance(surface.samples[j].position));
    }
  }
  return surface;
}

std::vector<FrameStretch>
stretches_at_plane(const SampledSurface<2> &surface, const WallMotion<2> &wall, const double reach)
{
  std::vector<char> near(surface.samples.size(), 0);
  for (unsigned int i = 0; i < near.size(); ++i)
    near[i] = (surface.samples[i].position - wall.point) * wall.normal < reach &&
              -(surface.samples[i].normal * wall.normal) >
                  std::cos(std::acos(facing_plane) + surface.samples[i].corner);
  std::vector<unsigned int> group(near.size());
  for (unsigned int i = 0; i < group.size(); ++i)
    group[i] = i;
  const auto of = [&](unsigned int i)
  {
    while (group[i] != i)
      i = group[i];
    return i;
  };
  for (const auto &[i, j] : surface.neighbours)
    if (near[i] && near[j])
      group[std::max(of(i), of(j))] = std::min(of(i), of(j));
  std::map<unsigned int, FrameStretch> stretches;
  for (unsigned int i = 0; i < near.size(); ++i)
    if (near[i])
      stretches[of(i)].facing.push_back({{Frame::none, i}});
  std::vector<FrameStretch> result;
  for (auto &[first, stretch] : stretches)
  {
    stretch.direction = wall.normal;
    double nearest = std::numeric_limits<double>::max();
    for (const auto &pair : stretch.facing)
    {
      const Point &x = surface.samples[pair[1]].position;
      if ((x - wall.point) * wall.normal < nearest)
      {
        nearest = (x - wall.point) * wall.normal;
        stretch.middle = x;
      }
    }
    result.push_back(std::move(stretch));
  }
  return result;
}

std::vector<FrameStretch>
stretches_between(const SampledSurface<2> &partner, const SampledSurface<2> &body, const double reach)
{
  std::vector<FrameStretch> result;
  for (const NearStretch<2> &near : near_stretches(partner, body, reach))
  {
    FrameStretch stretch;
    stretch.direction = near.direction;
    stretch.middle = near.middle;
    for (const auto &[i, j] : near.facing)
      stretch.facing.push_back({{i, j}});
    result.push_back(std::move(stretch));
  }
  return result;
}

void add_corners(const SampledSurface<2> *partner,
                 const SampledSurface<2> &body,
                 std::vector<FrameStretch> &stretches)
{
  std::map<std::pair<unsigned int, unsigned int>, FrameStretch> corners; // by side and sample
  std::map<std::pair<unsigned int, unsigned int>, double> nearest;
  for (const FrameStretch &stretch : stretches)
    for (const auto &pair : stretch.facing)
      for (unsigned int side = partner == nullptr ? 1 : 0; side < 2; ++side)
      {
        const SampledSurface<2>::Sample &own = (side == 0 ? *partner : body).samples[pair[side]];
        if (own.corner == 0.)
          continue;
        FrameStretch corner;
        corner.direction = stretch.direction;
        corner.middle = own.position;
        // The ray may meet what lies beside the sample that is nearest.
        corner.facing = stretch.facing;
        std::swap(corner.facing.front(), *std::find(corner.facing.begin(), corner.facing.end(), pair));
        corner.corner = side;
        double distance = 0.;
        if (partner != nullptr)
        {
          const SampledSurface<2>::Sample &other = (side == 0 ? body : *partner).samples[pair[1 - side]];
          distance = own.position.distance(other.position);
          if (other.corner == 0.)
            corner.direction = side == 0 ? -other.normal : other.normal;
        }
        const auto at = std::make_pair(side, pair[side]);
        const auto known = nearest.find(at);
        if (known != nearest.end() && known->second <= distance)
          continue;
        nearest[at] = distance;
        corners[at] = corner;
      }
  for (auto &[at, corner] : corners)
    stretches.push_back(std::move(corner));
}

SampledSurface<2> part_in(const dealii::BoundingBox<2> &box, const SampledSurface<2> &surface)
{
  SampledSurface<2> part;
  part.spacing = surface.spacing;
  std::vector<unsigned int> here(surface.samples.size(), Frame::none); // number in the part
  for (unsigned int i = 0; i < here.size(); ++i)
    if (box.point_inside(surface.samples[i].position))
    {
      here[i] = part.samples.size();
      part.samples.push_back(surface.samples[i]);
    }
  for (const auto &[i, j] : surface.neighbours)
    if (here[i] != Frame::none && here[j] != Frame::none)
      part.neighbours.emplace_back(here[i], here[j]);
  return part;
}
} // namespace softgrain::mpm
