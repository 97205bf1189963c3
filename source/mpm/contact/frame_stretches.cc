// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/folded_surface.h>
#include <softgrain/mpm/contact/frame_stretches.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int none = ContactFrame<2>::none;
constexpr double facing_plane = 0.5; ///< least cosine between an outline's normal and what it faces
constexpr double another_direction = 0.70710678118654752; ///< cosine of 45 degrees
constexpr double beyond_corner = 0.26;                    ///< 15 degrees [rad]
} // namespace

SampledSurface<2> sample_surface(const Body<2> &body, const OutlineSurface &outline)
{
  SampledSurface<2> surface;
  const Boundary<2> &boundary = body.boundary;
  const unsigned int stride = std::max(1u, boundary.stride);
  for (unsigned int l = 0; l < boundary.n_loops(); ++l)
  {
    const unsigned int begin = boundary.loop_start[l], end = boundary.loop_start[l + 1],
                       first = surface.samples.size();
    for (unsigned int m = begin; m < end; ++m)
    {
      if ((m - begin) % stride != 0 && !boundary.corner[m])
        continue;
      const dealii::Point<2> &x = boundary.position[m];
      dealii::Tensor<1, 2> before = x - boundary.position[boundary.previous(m)],
                           after = boundary.position[boundary.next(m)] - x;
      before /= before.norm();
      after /= after.norm();
      dealii::Tensor<1, 2> t = before + after;
      t /= t.norm();
      SampledSurface<2>::Sample s;
      s.position = x;
      s.normal = dealii::Tensor<1, 2>({t[1], -t[0]});
      // What is a dent has no cone of normals.
      if (boundary.corner[m] && before[0] * after[1] > before[1] * after[0])
        s.corner = 0.5 * std::acos(std::clamp(before * after, -1., 1.));
      s.place = outline.at_vertex(m);
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

SampledSurface<3> sample_surface(const Body<3> &body, const SolidSurface &solid)
{
  SampledSurface<3> surface;
  const Boundary<3> &boundary = body.boundary;
  surface.samples.resize(boundary.position.size());
  for (const auto &[a, b, c] : solid.triangles)
  {
    const dealii::Point<3> &x = boundary.position[a];
    const dealii::Tensor<1, 3> area =
        dealii::cross_product_3d(boundary.position[b] - x, boundary.position[c] - x);
    for (const unsigned int m : {a, b, c})
      surface.samples[m].normal += area;
    // Every side belongs to two triangles, which run against each other along it.
    for (const auto &[i, j] : {std::make_pair(a, b), std::make_pair(b, c), std::make_pair(c, a)})
      if (i < j)
      {
        surface.neighbours.emplace_back(i, j);
        surface.spacing = std::max(surface.spacing, boundary.position[i].distance(boundary.position[j]));
      }
  }
  for (unsigned int m = 0; m < surface.samples.size(); ++m)
  {
    auto &sample = surface.samples[m];
    sample.position = boundary.position[m];
    sample.normal /= sample.normal.norm();
    sample.place = solid.at(boundary.grid_position[m]);
  }
  return surface;
}

template <int dim>
std::vector<FrameStretch<dim>>
stretches_at_plane(const SampledSurface<dim> &surface, const WallMotion<dim> &wall, const double reach)
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
  std::map<unsigned int, FrameStretch<dim>> stretches;
  for (unsigned int i = 0; i < near.size(); ++i)
    if (near[i])
      stretches[of(i)].facing.push_back({{none, i}});
  std::vector<FrameStretch<dim>> result;
  for (auto &[first, stretch] : stretches)
  {
    stretch.direction = wall.normal;
    double nearest = std::numeric_limits<double>::max();
    for (const auto &pair : stretch.facing)
    {
      const dealii::Point<dim> &x = surface.samples[pair[1]].position;
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

template <int dim>
std::vector<FrameStretch<dim>> stretches_between(const SampledSurface<dim> &partner,
                                                 const SampledSurface<dim> &body,
                                                 const double reach,
                                                 const bool itself)
{
  std::vector<NearStretch<dim>> all;
  if constexpr (dim == 2)
    if (itself)
      all = stretches_of_fold(body, reach);
  if (!itself)
    all = near_stretches(partner, body, reach);
  std::vector<FrameStretch<dim>> result;
  for (const NearStretch<dim> &near : all)
  {
    FrameStretch<dim> stretch;
    stretch.direction = near.direction;
    stretch.middle = near.middle;
    for (const auto &[i, j] : near.facing)
      stretch.facing.push_back({{i, j}});
    result.push_back(std::move(stretch));
  }
  return result;
}

namespace
{
/// A corner with one of the samples that it faces.
template <int dim>
struct CornerFacing
{
  double distance = 0.; ///< [m]
  double turned = 0.;   ///< of the other normal against the middle of the corner's [rad]
  double beyond = 0.;   ///< of it against the corner's nearest normal [rad]
  FrameStretch<dim> stretch;
};

/// The nearest, and those that are as good as touched too, in another direction: a tip in a dent meets both
/// of its sides. Of what is as near, as both sides of a line are, the one counts that the corner faces more.
/// @param near distance up to which there are others [m]
template <int dim>
void choose(std::vector<CornerFacing<dim>> all, const double near, std::vector<FrameStretch<dim>> &stretches)
{
  const double same = 1e-9 * near;
  std::vector<dealii::Tensor<1, dim>> taken;
  while (!all.empty())
  {
    const auto best = std::min_element(all.begin(), all.end(),
                                       [](const auto &a, const auto &b) { return a.distance < b.distance; });
    const double least = best->distance + same;
    const auto first = std::min_element(all.begin(), all.end(),
                                        [&](const auto &a, const auto &b)
                                        {
                                          if ((a.distance <= least) != (b.distance <= least))
                                            return a.distance <= least;
                                          return a.turned < b.turned;
                                        });
    taken.push_back(first->stretch.direction);
    stretches.push_back(std::move(first->stretch));
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](const auto &other)
                             {
                               return other.distance > near || other.beyond > beyond_corner ||
                                      other.stretch.direction * taken.back() > another_direction;
                             }),
              all.end());
  }
}
} // namespace

template <int dim>
void add_corners(const SampledSurface<dim> *partner,
                 const SampledSurface<dim> &body,
                 std::vector<FrameStretch<dim>> &stretches)
{
  std::map<std::pair<unsigned int, unsigned int>, std::vector<CornerFacing<dim>>> corners; // by side, sample
  for (const FrameStretch<dim> &stretch : stretches)
    for (const auto &pair : stretch.facing)
      for (unsigned int side = partner == nullptr ? 1 : 0; side < 2; ++side)
      {
        const typename SampledSurface<dim>::Sample &own = (side == 0 ? *partner : body).samples[pair[side]];
        if (own.corner == 0.)
          continue;
        CornerFacing<dim> facing;
        FrameStretch<dim> &corner = facing.stretch;
        corner.direction = stretch.direction;
        corner.middle = own.position;
        // The ray may meet what lies beside the sample that is nearest.
        corner.facing = stretch.facing;
        std::swap(corner.facing.front(), *std::find(corner.facing.begin(), corner.facing.end(), pair));
        corner.corner = side;
        if (partner != nullptr)
        {
          const typename SampledSurface<dim>::Sample &other =
              (side == 0 ? body : *partner).samples[pair[1 - side]];
          facing.distance = own.position.distance(other.position);
          facing.turned = std::acos(std::clamp(-(own.normal * other.normal), -1., 1.));
          facing.beyond = facing.turned - own.corner - other.corner;
          if (other.corner == 0.)
            corner.direction = side == 0 ? -other.normal : other.normal;
        }
        corners[std::make_pair(side, pair[side])].push_back(std::move(facing));
      }
  const double near = partner == nullptr ? body.spacing : std::max(body.spacing, partner->spacing);
  for (auto &[at, facing] : corners)
    choose(std::move(facing), near, stretches);
}

SampledSurface<2> part_in(const dealii::BoundingBox<2> &box, const SampledSurface<2> &surface)
{
  SampledSurface<2> part;
  part.spacing = surface.spacing;
  std::vector<unsigned int> here(surface.samples.size(), none); // number in the part
  for (unsigned int i = 0; i < here.size(); ++i)
    if (box.point_inside(surface.samples[i].position))
    {
      here[i] = part.samples.size();
      part.samples.push_back(surface.samples[i]);
    }
  for (const auto &[i, j] : surface.neighbours)
    if (here[i] != none && here[j] != none)
      part.neighbours.emplace_back(here[i], here[j]);
  return part;
}

template std::vector<FrameStretch<2>>
stretches_at_plane(const SampledSurface<2> &, const WallMotion<2> &, double);
template std::vector<FrameStretch<3>>
stretches_at_plane(const SampledSurface<3> &, const WallMotion<3> &, double);
template std::vector<FrameStretch<2>>
stretches_between(const SampledSurface<2> &, const SampledSurface<2> &, double, bool);
template std::vector<FrameStretch<3>>
stretches_between(const SampledSurface<3> &, const SampledSurface<3> &, double, bool);
template void
add_corners(const SampledSurface<2> *, const SampledSurface<2> &, std::vector<FrameStretch<2>> &);
template void
add_corners(const SampledSurface<3> *, const SampledSurface<3> &, std::vector<FrameStretch<3>> &);
} // namespace softgrain::mpm
