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

  Successors(const std::vector<FrameStretch<dim>> &stretches,
             const std::vector<Frame> &named,
             FramesBefore<dim> &before)
      : stretches(stretches), named(named), before(before), chosen(stretches.size(), before.end())
  {
  }

  /// Joins what is left, the nearest first. @param cosine least one of the directions
  /// @param within largest distance [m] @param corners whether frames of corners are joined, too
  /// @param wide whether only contacts that have a width are
  void join(const double cosine, const double within, const bool corners, const bool wide)
  {
    std::vector<Pair> pairs;
    for (unsigned int s = 0; s < stretches.size(); ++s)
      if (chosen[s] == before.end() && (corners || named[s].corner == Frame::none))
        add_pairs(s, cosine, within, wide, pairs);
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

  void add_pairs(const unsigned int s,
                 const double cosine,
                 const double within,
                 const bool wide,
                 std::vector<Pair> &pairs)
  {
    const auto [first, end] = before.equal_range(key_of(named[s]));
    for (Old old = first; old != end; ++old)
    {
      const double distance = old->second.origin.distance(stretches[s].middle);
      if (is_pressed(old->second) && old->second.direction * stretches[s].direction >= cosine &&
          distance < within && (!wide || is_wide(old->second)))
        pairs.push_back({distance, s, old});
    }
  }
  bool is_taken(const Old old) const { return std::find(chosen.begin(), chosen.end(), old) != chosen.end(); }

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
                                            const std::vector<FrameStretch<dim>> &stretches,
                                            std::vector<ContactFrame<dim>> named,
                                            FramesBefore<dim> &before)
{
  Successors<dim> successors(stretches, named, before);
  successors.join(keeps_direction, std::numeric_limits<double>::max(), true, false);
  if (dim == 2 || scene.instants.inertia())
    successors.join(turns_direction, turns_within * scene.cell_size, false, !scene.instants.inertia());
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
                                                   const std::vector<FrameStretch<2>> &,
                                                   std::vector<ContactFrame<2>>,
                                                   FramesBefore<2> &);
template std::vector<ContactFrame<3>> start_frames(const FrameScene<3> &,
                                                   const std::vector<FrameStretch<3>> &,
                                                   std::vector<ContactFrame<3>>,
                                                   FramesBefore<3> &);
} // namespace softgrain::mpm
