// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/contact/frame_layout.h>
#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/frame_stretches.h>
#include <softgrain/mpm/contact/frame_tasks.h>
#include <softgrain/mpm/contact/told_frames.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace softgrain::mpm
{
namespace
{
using Frame = ContactFrame<2>;
using Vector = dealii::Tensor<1, 2>;
using Point = dealii::Point<2>;

constexpr double spacing_in_cells = 0.5;
constexpr double keeps_direction = 0.98163;
/// Finds the stretches of a pair. @param lines samples of the obstacles
void look(const FrameScene &scene,
          const std::vector<SampledSurface<2>> &samples,
          const std::vector<SampledSurface<2>> &lines,
          FrameTask &task)
{
  const SampledSurface<2> &body = samples[task.named.body];
  if (scene.line_of(task.named) != nullptr)
  {
    // Long lines have but a part near a body.
    task.image =
        std::make_unique<SampledSurface<2>>(part_in(task.near, lines[task.named.wall - scene.walls.size()]));
    task.partner = task.image.get();
    if (!task.partner->samples.empty())
      task.stretches = stretches_between(*task.partner, body, scene.reach_of(task.named));
  }
  else if (task.named.partner == Frame::none)
    task.stretches = stretches_at_plane(body, scene.walls[task.named.wall], scene.reach_of(task.named));
  else
  {
    task.partner = &samples[task.named.partner];
    if (task.apart.norm_square() > 0.)
    {
      task.image = std::make_unique<SampledSurface<2>>(*task.partner);
      for (auto &sample : task.image->samples)
        sample.position += task.apart;
      task.partner = task.image.get();
    }
    task.stretches = stretches_between(*task.partner, body, scene.reach_of(task.named));
  }
  add_corners(task.partner, body, task.stretches);
}

/// Frames of the step before, by what they have in common with their successors: moved with bodies that have
/// been brought into the cell since then.
std::multimap<Frame::Key, Frame> by_key(const FrameScene &scene, std::vector<Frame> frames)
{
  std::multimap<Frame::Key, Frame> result;
  for (Frame &frame : frames)
  {
    const Body<2> &body = scene.bodies[frame.body];
    if (scene.cell != nullptr && frame.home != body.home)
    {
      frame.origin -= scene.cell->cell.shift({{body.home[0] - frame.home[0], body.home[1] - frame.home[1]}});
      frame.home = body.home;
    }
    result.emplace(frame.key(), std::move(frame));
  }
  return result;
}

/// A frame for a stretch, or the one of those before that covers it.
Frame start_frame(const FrameScene &scene,
                  const FrameStretch &stretch,
                  const Frame &named,
                  std::multimap<Frame::Key, Frame> &before)
{
  const auto [first, end] = before.equal_range(named.key());
  auto best = end;
  double nearest = std::numeric_limits<double>::max();
  for (auto old = first; old != end; ++old)
  {
    const bool pressed = std::any_of(old->second.rays.begin(), old->second.rays.end(),
                                     [](const Frame::RayPlace &ray) { return ray.force != 0.; });
    if (!pressed || old->second.direction * stretch.direction < keeps_direction)
      continue;
    const double distance = old->second.origin.distance(stretch.middle);
    if (distance < nearest)
    {
      nearest = distance;
      best = old;
    }
  }
  if (best != end)
  {
    Frame kept = std::move(best->second);
    before.erase(best);
    return kept;
  }
  Frame frame = named;
  frame.rays.clear();
  frame.home = scene.bodies[frame.body].home;
  frame.direction = stretch.direction;
  frame.across[0] = Vector({stretch.direction[1], -stretch.direction[0]});
  frame.origin = stretch.middle;
  frame.spacing = spacing_in_cells * scene.cell_size;
  return frame;
}

/// Rays of a frame that is new remember what has become of the material that they meet. @param before frames
/// that have no successor
void inherit_memory(const std::multimap<Frame::Key, Frame> &before, Frame &frame)
{
  const auto [first, end] = before.equal_range(frame.key());
  for (Frame::RayPlace &ray : frame.rays)
  {
    double nearest = 0.75 * frame.spacing;
    for (auto old = first; old != end; ++old)
      for (const Frame::RayPlace &other : old->second.rays)
        if (const double distance = other.place[1].position.distance(ray.place[1].position);
            distance < nearest)
        {
          nearest = distance;
          ray.memory = other.memory;
        }
  }
}

/// What all tasks have in common.
struct LookedAt
{
  const FrameScene &scene;
  const std::vector<SampledSurface<2>> &samples, &lines; ///< of bodies and of obstacles
};

/// Finds the frames of some tasks. @param before frames of the step before that have no successor yet
void find_here(const LookedAt &at,
               std::multimap<Frame::Key, Frame> &before,
               const std::vector<FrameTask *> &tasks)
{
  parallel_for(tasks.size(), 4,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                   look(at.scene, at.samples, at.lines, *tasks[i]);
               });
  for (FrameTask *const task : tasks)
    for (const FrameStretch &stretch : task->stretches)
    {
      Frame named = task->named;
      named.corner = stretch.corner;
      if (stretch.corner != Frame::none)
      {
        named.rays.resize(1);
        named.rays[0].place[stretch.corner] = (stretch.corner == 0 ? *task->partner : at.samples[named.body])
                                                  .samples[stretch.facing.front()[stretch.corner]]
                                                  .place;
      }
      task->found.push_back(start_frame(at.scene, stretch, named, before));
    }
  const bool remembers = at.scene.adhesion != nullptr && at.scene.adhesion->remembers();
  parallel_for(tasks.size(), 4,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                 {
                   FrameTask &task = *tasks[i];
                   const FrameLayout layout(at.scene, task.apart, task.partner, at.samples[task.named.body]);
                   for (unsigned int s = 0; s < task.found.size(); ++s)
                   {
                     if (task.found[s].rays.empty() && task.found[s].corner == Frame::none)
                       layout.center(task.stretches[s], task.found[s]);
                     layout.lay(task.stretches[s], task.found[s]);
                     if (remembers && task.found[s].id == 0)
                       inherit_memory(before, task.found[s]);
                   }
                 }
               });
}

/// Finds the frames of all tasks, those of other ranks' bodies by asking these.
void find_in_tasks(const LookedAt &at,
                   std::multimap<Frame::Key, Frame> &before,
                   std::vector<FrameTask> &tasks)
{
  const BodyShare *const share = at.scene.looking;
  std::vector<FrameTask *> here, elsewhere;
  for (FrameTask &task : tasks)
    (share == nullptr || share->mine(task.named.body) ? here : elsewhere).push_back(&task);
  if (share == nullptr)
    return find_here(at, before, here);
  std::vector<std::vector<double>> told(at.scene.bodies.size());
  share->share_lists(
      [&]()
      {
        find_here(at, before, here);
        for (const FrameTask *const task : here)
          if (!share->alone())
            tell_frames(task->found, told[task->named.body]);
      },
      told);
  std::vector<const double *> next;
  for (const std::vector<double> &of_body : told)
    next.push_back(of_body.data());
  for (FrameTask *const task : elsewhere)
    task->found = take_frames(task->named, next[task->named.body]);
}
} // namespace

dealii::Tensor<1, 2> FrameScene::apart(const ContactFrame<2> &frame) const
{
  if (cell == nullptr || frame.partner == Frame::none)
    return dealii::Tensor<1, 2>();
  PeriodicCell<2>::Image here = frame.image;
  for (unsigned int d = 0; d < 2; ++d)
    here[d] += bodies[frame.partner].home[d] - bodies[frame.body].home[d];
  return cell->cell.shift(here);
}

Ray<2> ray_of(const ContactFrame<2> &frame, const double offset, const dealii::Tensor<1, 2> &away)
{
  Ray<2> ray;
  ray.origin = frame.origin - away;
  ray.direction = frame.direction;
  ray.across = frame.across;
  ray.offset[0] = offset;
  return ray;
}

std::vector<ContactFrame<2>> find_frames(const FrameScene &scene, std::vector<ContactFrame<2>> frames)
{
  std::uint64_t next_id = 1;
  for (const Frame &frame : frames)
    next_id = std::max(next_id, frame.id + 1);
  std::multimap<Frame::Key, Frame> before = by_key(scene, std::move(frames));
  std::vector<SampledSurface<2>> samples(scene.bodies.size());
  parallel_for(samples.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   samples[b] = sample_outline(scene.bodies[b], scene.outlines[b]);
               });
  std::vector<SampledSurface<2>> lines;
  for (unsigned int o = 0; scene.lines != nullptr && o < scene.lines->size(); ++o)
    lines.push_back((*scene.lines)[o].samples(0.5 * scene.cell_size));
  std::vector<FrameTask> tasks = find_frame_tasks(scene, samples);
  find_in_tasks({scene, samples, lines}, before, tasks);
  std::vector<Frame> result;
  for (FrameTask &task : tasks)
    for (Frame &frame : task.found)
      if (!frame.rays.empty())
      {
        if (frame.id == 0)
          frame.id = next_id++;
        result.push_back(std::move(frame));
      }
  return result;
}
} // namespace softgrain::mpm
