// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_successors.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace softgrain::mpm
{
namespace
{
/// In space a field has fewer shapes for the forces of rays.
template <int dim>
constexpr double spacing_in_cells = dim == 2 ? 0.5 : 0.6;
/// Cosine and distance [cells] up to which a frame is turned in place of laying another one.
constexpr double turns_direction = 0.5, turns_within = 2.;

template <int dim>
bool is_pressed(const ContactFrame<dim> &frame)
{
  return std::any_of(frame.rays.begin(), frame.rays.end(), [](const auto &ray) { return ray.force != 0.; });
}

/// Rays from which on a contact has a width: what is narrower is met at its middle, which may have gone on.
constexpr unsigned int least_wide = 3;

template <int dim>
bool is_wide(const ContactFrame<dim> &frame)
{
  return std::count_if(frame.rays.begin(), frame.rays.end(),
                       [](const auto &ray) { return ray.force != 0.; }) >= static_cast<long>(least_wide);
}

/// Which frames of before go on in the stretches of a pair.
template <int dim>
class Successors
{
public:
  using Frame = ContactFrame<dim>;
  using Old = typename FramesBefore<dim>::iterator;

  Successors(const StretchesOfPair<dim> &pair, const std::vector<Frame> &named, FramesBefore<dim> &before)
      : pair(pair)
      , stretches(pair.stretches)
      , named(named)
      , before(before)
      , chosen(stretches.size(), before.end())
  {
  }

  /// Joins what is left, the nearest first. @param cosine least one of the directions
  /// @param within largest distance [m] @param corners whether frames of corners are joined, too
  void join(const double cosine, const double within, const bool corners)
  {
    std::vector<Pair> pairs;
    for (unsigned int s = 0; s < stretches.size(); ++s)
      if (chosen[s] == before.end() && (corners || named[s].corner == Frame::none))
        add_pairs(s, cosine, within, pairs);
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair &a, const Pair &b) { return a.distance < b.distance; });
    for (const Pair &next : pairs)
      if (chosen[next.stretch] == before.end() && !is_taken(next.old))
        chosen[next.stretch] = next.old;
  }

  /// The frame of before for a stretch, which is taken out there; nothing if there is none.
  bool take(const unsigned int s, Frame &frame)
  {
    if (chosen[s] == before.end())
      return false;
    frame = std::move(chosen[s]->second);
    before.erase(chosen[s]);
    return true;
  }

private:
  struct Pair
  {
    double distance; ///< [m]
    unsigned int stretch;
    Old old;
  };

  void add_pairs(const unsigned int s, const double cosine, const double within, std::vector<Pair> &pairs)
  {
    const auto [first, end] = before.equal_range(key_of(named[s]));
    for (Old old = first; old != end; ++old)
    {
      const double distance = old->second.origin.distance(stretches[s].middle);
      if (is_pressed(old->second) && distance < within && fits(old->second, stretches[s], cosine))
        pairs.push_back({distance, s, old});
    }
  }

  /// Whether a frame has the direction of a stretch, or of the normals where it presses: these may be at one
  /// end of a long stretch.
  bool fits(const Frame &frame, const FrameStretch<dim> &stretch, const double cosine) const
  {
    if (frame.direction * stretch.direction >= cosine)
      return true;
    if (pair.partner == nullptr || stretch.corner != Frame::none || !is_wide(frame))
      return false;
    dealii::Tensor<1, dim> sum;
    for (const auto &[i, j] : stretch.facing)
      if (is_under_pressed_ray(frame, pair.body.samples[j].position))
        sum += pair.partner->samples[i].normal - pair.body.samples[j].normal;
    return frame.direction * sum > cosine * sum.norm();
  }

  static bool is_under_pressed_ray(const Frame &frame, const dealii::Point<dim> &x)
  {
    dealii::Tensor<1, dim - 1> across;
    for (unsigned int m = 0; m < dim - 1; ++m)
      across[m] = (x - frame.origin) * frame.across[m];
    return std::any_of(frame.rays.begin(), frame.rays.end(),
                       [&](const auto &ray) {
                         return ray.force != 0. && (frame.offset(ray.index) - across).norm() < frame.spacing;
                       });
  }

  bool is_taken(const Old old) const { return std::find(chosen.begin(), chosen.end(), old) != chosen.end(); }

  const StretchesOfPair<dim> &pair;
  const std::vector<FrameStretch<dim>> &stretches;
  const std::vector<Frame> &named;
  FramesBefore<dim> &before;
  std::vector<Old> chosen; ///< of every stretch, the end of before where there is none
};
} // namespace

template <int dim>
FramesBefore<dim> frames_before(const FrameScene<dim> &scene, std::vector<ContactFrame<dim>> frames)
{
  FramesBefore<dim> result;
  for (ContactFrame<dim> &frame : frames)
  {
    const Body<dim> &body = scene.bodies[frame.body];
    if (scene.cell != nullptr && frame.home != body.home)
    {
      typename PeriodicCell<dim>::Image moved = body.home;
      for (unsigned int d = 0; d < dim; ++d)
        moved[d] -= frame.home[d];
      frame.origin -= scene.cell->cell.shift(moved);
      frame.home = body.home;
    }
    result.emplace(key_of(frame), std::move(frame));
  }
  return result;
}

template <int dim>
std::vector<ContactFrame<dim>> start_frames(const FrameScene<dim> &scene,
                                            const StretchesOfPair<dim> &pair,
                                            std::vector<ContactFrame<dim>> named,
                                            FramesBefore<dim> &before)
{
  const std::vector<FrameStretch<dim>> &stretches = pair.stretches;
  Successors<dim> successors(pair, named, before);
  successors.join(keeps_direction, std::numeric_limits<double>::max(), true);
  if (scene.instants.inertia())
    successors.join(turns_direction, turns_within * scene.cell_size, false);
  std::vector<ContactFrame<dim>> result(stretches.size());
  for (unsigned int s = 0; s < stretches.size(); ++s)
  {
    if (successors.take(s, result[s]))
      continue;
    ContactFrame<dim> &frame = result[s] = named[s];
    frame.rays.clear();
    frame.home = scene.bodies[frame.body].home;
    turn(frame, stretches[s].direction);
    frame.origin = stretches[s].middle;
    frame.spacing = spacing_in_cells<dim> * scene.cell_size;
  }
  return result;
}

template FramesBefore<2> frames_before(const FrameScene<2> &, std::vector<ContactFrame<2>>);
template FramesBefore<3> frames_before(const FrameScene<3> &, std::vector<ContactFrame<3>>);
template std::vector<ContactFrame<2>> start_frames(const FrameScene<2> &,
                                                   const StretchesOfPair<2> &,
                                                   std::vector<ContactFrame<2>>,
                                                   FramesBefore<2> &);
template std::vector<ContactFrame<3>> start_frames(const FrameScene<3> &,
                                                   const StretchesOfPair<3> &,
                                                   std::vector<ContactFrame<3>>,
                                                   FramesBefore<3> &);
} // namespace softgrain::mpm
