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
/// Slope of a surface over the lattice: a stretch turns by 57 degrees at most, and a frame by 11 before it is
/// turned or laid anew.
constexpr double steepest = 2.5;
constexpr double deepest = 0.5;         ///< overlap of surfaces that meet [cells]
constexpr double beside_corners = 0.05; ///< no new ray meets a side nearer to a corner [cells]
constexpr double thin_from = 0.04;      ///< overlap that may be the thickness of something thin [cells]
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
        guesses.emplace_back(y, surface_of(scene, frame, side).beyond_edge(sample.place));
    }
  return guesses;
}

/// Whether a ray has met the outside of a surface. Then it learns where.
template <int dim>
bool FrameLayout<dim>::meets_outside(const RaySide<dim> &found,
                                     const ContactFrame<dim> &frame,
                                     const unsigned int side,
                                     typename ContactFrame<dim>::RayPlace &ray,
                                     double &height) const
{
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
  const Across offset = frame.offset(ray.index);
  const auto meet_from = [&](const SurfacePlace<dim> &guess)
  { return meets_outside(meet_surface(frame, side, offset, guess, false), frame, side, ray, height); };
  if (old != nullptr && meet_from(old->place[side]))
    return true;
  std::vector<std::pair<double, unsigned int>> nearest; // distance and number of a guess
  nearest.reserve(guesses.size());
  for (unsigned int i = 0; i < guesses.size(); ++i)
    nearest.emplace_back((guesses[i].first - offset).norm(), i);
  const std::size_t n = std::min<std::size_t>(tries, nearest.size());
  std::partial_sort(nearest.begin(), nearest.begin() + n, nearest.end());
  for (unsigned int i = 0; i < n; ++i)
    if (meet_from(guesses[nearest[i].second].second) &&
        (stretch.corner != ContactFrame<dim>::none || !near_corner(frame, side, ray.place[side])))
      return true;
  if constexpr (dim == 2)
    if (const unsigned int b = side == 0 ? frame.partner : frame.body;
        stretch.corner != ContactFrame<dim>::none && b != ContactFrame<dim>::none)
      for (unsigned int i = 0; i < n; ++i)
        if (const SurfacePlace<dim> &end = guesses[nearest[i].second].second;
            end.at_edge &&
            meets_outside(meet_past_end(ray_of(frame, offset, away(side)), scene.bodies[b].field,
                                        scene.bodies[b].nodes.displacement, end, past_ends(scene)),
                          frame, side, ray, height))
          return true;
  return false;
}

/// Corners have rays of their own.
template <int dim>
bool FrameLayout<dim>::near_corner(const ContactFrame<dim> &frame,
                                   const unsigned int side,
                                   const SurfacePlace<dim> &place) const
{
  const RestSurface<dim> &surface = surface_of(scene, frame, side);
  for (unsigned int m = 0; m < dim - 1; ++m)
  {
    Across way;
    way[m] = beside_corners * scene.cell_size;
    if (surface.move(place, way).at_edge || surface.move(place, -way).at_edge)
      return true;
  }
  return false;
}

/// Whether a ray, from where it has met the body, or the partner, leaves it again before both are as far
/// beyond as they seem to be deep in each other. Then what overlaps is no matter, but the far side of
/// something thin: of a sharp tip that stands on the near side of a line.
template <int dim>
bool FrameLayout<dim>::far_side(const ContactFrame<dim> &frame,
                                const Across &offset,
                                const std::array<double, 2> &height) const
{
  const double overlap = height[0] - height[1], beside = 0.5 * thin_from * scene.cell_size;
  if (dim == 3 || partner == nullptr || frame.partner == frame.body || overlap < 2. * beside)
    return false; // of a body and itself the other side lies in between
  const auto leaves = [&](const unsigned int side, const double from, const double to)
  {
    const std::vector<typename SampledSurface<dim>::Sample> &samples = surface(side).samples;
    for (const auto &[i, j] : surface(side).neighbours)
    {
      const Vector first = samples[i].position - frame.origin, second = samples[j].position - frame.origin;
      const double a = first * frame.across[0] - offset[0], b = second * frame.across[0] - offset[0];
      if ((a < 0.) == (b < 0.))
        continue;
      const double at = (first * frame.direction * b - second * frame.direction * a) / (b - a),
                   outwards = (samples[i].normal + samples[j].normal) * frame.direction;
      if (at > from && at < to && (side == 0 ? outwards < 0. : outwards > 0.))
        return true;
    }
    return false;
  };
  return leaves(1, height[1] + beside, height[0] + overlap) ||
         (scene.line_of(frame) == nullptr && leaves(0, height[1] - overlap, height[0] - beside));
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
    if ((gap > reach_of(scene, frame) || gap < -deepest * scene.cell_size) && place.force <= 0.)
      continue;
    if (place.force <= 0. && far_side(frame, frame.offset(index), height))
      continue;
    rays.push_back(place);
  }
  frame.rays = std::move(rays);
}

template void FrameLayout<2>::lay(const FrameStretch<2> &, ContactFrame<2> &) const;
template void FrameLayout<3>::lay(const FrameStretch<3> &, ContactFrame<3> &) const;
} // namespace softgrain::mpm
