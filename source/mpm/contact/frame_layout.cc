// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_layout.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace softgrain::mpm
{
namespace
{
constexpr double steepest = 2.;         ///< slope of a surface over the lattice
constexpr double deepest = 0.5;         ///< overlap of surfaces that meet [cells]
constexpr double beside_corners = 0.05; ///< no new ray meets a side nearer to a corner [cells]
constexpr double same_gap = 1e-6;       ///< up to which gaps are the same [cells]
constexpr unsigned int tries = 4;       ///< places from which a ray looks for a surface
} // namespace

namespace
{
/// Where a place lies across the rays, from the origin [m].
template <int dim>
dealii::Tensor<1, dim - 1> across_of(const ContactFrame<dim> &frame, const dealii::Point<dim> &x)
{
  dealii::Tensor<1, dim - 1> y;
  for (unsigned int m = 0; m < dim - 1; ++m)
    y[m] = (x - frame.origin) * frame.across[m];
  return y;
}

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

/// Those of the lattice that stand near places of the stretch, in ascending order.
std::vector<std::array<int, 1>> lattice_near(const ContactFrame<2> &frame,
                                             const std::vector<dealii::Tensor<1, 1>> &places)
{
  double lower = std::numeric_limits<double>::max(), upper = -lower;
  for (const auto &y : places)
  {
    lower = std::min(lower, y[0]);
    upper = std::max(upper, y[0]);
  }
  const int first = std::ceil(lower / frame.spacing - 0.5), last = std::floor(upper / frame.spacing + 0.5);
  std::vector<std::array<int, 1>> list;
  for (int k = first; k <= last; ++k)
    list.push_back({{k}});
  return list;
}

std::vector<std::array<int, 2>> lattice_near(const ContactFrame<3> &frame,
                                             const std::vector<dealii::Tensor<1, 2>> &places)
{
  std::set<std::array<int, 2>> list;
  for (const auto &y : places)
  {
    const int j = std::lround(y[1] / (0.86602540378443864676 * frame.spacing));
    for (int row = j - 1; row <= j + 1; ++row)
    {
      const int i = std::lround(y[0] / frame.spacing - 0.5 * row);
      for (int k = i - 1; k <= i + 1; ++k)
        if ((frame.offset({{k, row}}) - y).norm() < 0.75 * frame.spacing)
          list.insert({{k, row}});
    }
  }
  return {list.begin(), list.end()};
}
} // namespace

/// From a corner there is no way to the side beyond it, so it is a guess on both.
template <int dim>
typename FrameLayout<dim>::Guesses FrameLayout<dim>::guesses_of(const FrameStretch<dim> &stretch,
                                                                const ContactFrame<dim> &frame,
                                                                const unsigned int side) const
{
  Guesses guesses;
  for (const auto &pair : stretch.facing)
    if (pair[side] != ContactFrame<dim>::none)
    {
      const auto &sample = surface(side).samples[pair[side]];
      const Across y = across_of(frame, sample.position);
      guesses.emplace_back(y, sample.place);
      if (sample.place.at_edge)
        guesses.emplace_back(y, scene.surface_of(frame, side).beyond_edge(sample.place));
    }
  return guesses;
}

/// Whether the ray meets the outside of the surface near a guess.
template <int dim>
bool FrameLayout<dim>::meet_from(const SurfacePlace<dim> &guess,
                                 const ContactFrame<dim> &frame,
                                 const unsigned int side,
                                 typename ContactFrame<dim>::RayPlace &ray,
                                 double &height) const
{
  const RaySide<dim> found = meet_surface(frame, side, frame.offset(ray.index), guess);
  if (!found.met)
    return false;
  ray.place[side] = found.place;
  height = found.height;
  if constexpr (dim == 2)
  {
    const double outwards = (side == 0 ? 1. : -1.) * (found.way[0] * frame.across[0]);
    return outwards > 0. && std::abs(found.normal * frame.across[0]) < steepest;
  }
  else
  {
    // Tangents of the surface run as those across the rays do where it is seen from outside.
    dealii::Tensor<2, 2> ways;
    for (unsigned int m = 0; m < 2; ++m)
      for (unsigned int n = 0; n < 2; ++n)
        ways[m][n] = found.way[m] * frame.across[n];
    return (side == 0 ? 1. : -1.) * determinant(ways) > 0. &&
           found.normal.norm_square() - 1. < steepest * steepest;
  }
}

template <int dim>
RaySide<dim> FrameLayout<dim>::meet_surface(const ContactFrame<dim> &frame,
                                            const unsigned int side,
                                            const Across &offset,
                                            const SurfacePlace<dim> &guess) const
{
  const Ray<dim> ray = ray_of(frame, offset, away(side));
  const unsigned int b = side == 0 ? frame.partner : frame.body;
  if constexpr (dim == 2)
    if (b == ContactFrame<dim>::none)
      return scene.line_of(frame)->meet(ray, 0., guess);
  return meet(ray, scene.outlines[b], scene.bodies[b].field, scene.bodies[b].displacement, guess);
}

/// Where a ray meets a side. @param old the same ray before, if there was one
template <int dim>
bool FrameLayout<dim>::meet_side(const FrameStretch<dim> &stretch,
                                 const ContactFrame<dim> &frame,
                                 const unsigned int side,
                                 const Guesses &guesses,
                                 const typename ContactFrame<dim>::RayPlace *old,
                                 typename ContactFrame<dim>::RayPlace &ray,
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
  const Across offset = frame.offset(ray.index);
  Guesses by_distance = guesses;
  std::stable_sort(by_distance.begin(), by_distance.end(),
                   [&](const auto &x, const auto &y)
                   { return (x.first - offset).norm() < (y.first - offset).norm(); });
  for (unsigned int i = 0; i < std::min<std::size_t>(tries, by_distance.size()); ++i)
    if (meet_from(by_distance[i].second, frame, side, ray, height) &&
        (stretch.corner != ContactFrame<dim>::none || !near_corner(frame, side, ray.place[side])))
      return true;
  return false;
}

/// Corners have rays of their own.
template <int dim>
bool FrameLayout<dim>::near_corner(const ContactFrame<dim> &frame,
                                   const unsigned int side,
                                   const SurfacePlace<dim> &place) const
{
  const RestSurface<dim> &surface = scene.surface_of(frame, side);
  for (unsigned int m = 0; m < dim - 1; ++m)
  {
    Across way;
    way[m] = beside_corners * scene.cell_size;
    if (surface.move(place, way).at_edge || surface.move(place, -way).at_edge)
      return true;
  }
  return false;
}

template <int dim>
void FrameLayout<dim>::lay(const FrameStretch<dim> &stretch, ContactFrame<dim> &frame) const
{
  std::array<Guesses, 2> guesses;
  for (unsigned int side = 0; side < 2; ++side)
    guesses[side] = guesses_of(stretch, frame, side);
  std::vector<std::array<int, dim - 1>> lattice(1);
  if (stretch.corner == ContactFrame<dim>::none)
  {
    std::vector<Across> places;
    for (const auto &pair : stretch.facing)
      for (unsigned int side = 0; side < 2; ++side)
        if (pair[side] != ContactFrame<dim>::none)
          places.push_back(across_of(frame, surface(side).samples[pair[side]].position));
    lattice = lattice_near(frame, places);
  }
  std::vector<typename ContactFrame<dim>::RayPlace> rays;
  for (const auto &index : lattice)
  {
    typename ContactFrame<dim>::RayPlace place;
    place.index = index;
    const auto old =
        std::find_if(frame.rays.begin(), frame.rays.end(), [&](const auto &r) { return r.index == index; });
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

template <int dim>
void FrameLayout<dim>::center(const FrameStretch<dim> &stretch, ContactFrame<dim> &frame) const
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
  // Of a side along a wall all samples are nearest: the frame begins in their middle.
  Vector sum;
  unsigned int n_nearest = 0;
  for (const auto &pair : stretch.facing)
    if (gap_of(pair) <= nearest + same_gap * scene.cell_size)
    {
      sum += middle_of(pair) - dealii::Point<dim>();
      ++n_nearest;
    }
  frame.origin = dealii::Point<dim>(sum / n_nearest);
  std::array<const SurfacePlace<dim> *, 2> guess{};
  double closest = std::numeric_limits<double>::max(); // of these to that middle
  for (const auto &pair : stretch.facing)
    if (const double way = middle_of(pair).distance(frame.origin);
        gap_of(pair) <= nearest + same_gap * scene.cell_size && way < closest)
    {
      closest = way;
      guess = {{wall ? nullptr : &partner->samples[pair[0]].place, &body.samples[pair[1]].place}};
    }
  // From a corner there is no way to the side beyond it, so the middle is looked for from both.
  std::vector<Places> starts(1);
  for (unsigned int side = wall ? 1 : 0; side < 2; ++side)
    for (unsigned int s = 0, n = starts.size(); s < n; ++s)
    {
      starts[s][side] = *guess[side];
      if (guess[side]->at_edge)
      {
        starts.push_back(starts[s]);
        starts.back()[side] = scene.surface_of(frame, side).beyond_edge(*guess[side]);
      }
    }
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
    Across slope;
    dealii::Tensor<2, dim - 1> bend;
    double height = 0.;
    Vector normal;
    gap = wall ? (frame.origin - scene.walls[frame.wall].point) * frame.direction : 0.;
    for (unsigned int side = wall ? 1 : 0; side < 2; ++side)
    {
      const RaySide<dim> found = meet_surface(frame, side, Across(), place[side]);
      if (!found.met)
        return std::nullopt;
      place[side] = found.place;
      const double sign = side == 0 ? -1. : 1.;
      for (unsigned int m = 0; m < dim - 1; ++m)
      {
        slope[m] -= sign * (found.normal * frame.across[m]);
        for (unsigned int n = 0; n < dim - 1; ++n)
          bend[m][n] += sign * (frame.across[m] * (found.sliding_twice * frame.across[n]));
      }
      height += (wall ? 1. : 0.5) * found.height;
      gap += sign * found.height;
      normal += found.normal / found.normal.norm();
    }
    if (!(bend[0][0] > 0.) || !(determinant(bend) > 0.))
      return std::nullopt;
    const Across way = way_to_nearest(slope, bend, scene.cell_size);
    Vector moved = way[0] * frame.across[0];
    if constexpr (dim == 3)
      moved += way[1] * frame.across[1];
    frame.origin += moved + (wall ? 0. : height) * frame.direction;
    if (!wall)
      frame.turn(normal / normal.norm());
    note_dent(place, frame);
    if (way.norm() < 1e-10 * scene.cell_size)
      break;
    if (frame.origin.distance(first) > 2. * scene.cell_size)
      return std::nullopt;
  }
  return gap;
}

/// Where on the grids of both the frame begins.
template <int dim>
void FrameLayout<dim>::note_dent(const Places &place, ContactFrame<dim> &frame) const
{
  for (unsigned int side = 0; side < 2; ++side)
  {
    const unsigned int b = side == 0 ? frame.partner : frame.body;
    if (b != ContactFrame<dim>::none && SubgridLaw<dim>::is_round(scene.bodies[b]))
      frame.log_full_width[1 - side] = scene.subgrid.log_full_width(scene.bodies[b].law->poisson_ratio(),
                                                                    place[side].position, place[side].normal);
  }
}

template class FrameLayout<2>;
template class FrameLayout<3>;
} // namespace softgrain::mpm
