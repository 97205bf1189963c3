// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/contact/frame_layout.h>
#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/frame_stretches.h>
#include <softgrain/mpm/contact/frame_successors.h>
#include <softgrain/mpm/contact/frame_tasks.h>
#include <softgrain/mpm/contact/told_frames.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace softgrain::mpm
{
namespace
{
template <int dim>
using Frame = ContactFrame<dim>;

/// Finds the stretches of a pair.
template <int dim>
void look(const FrameScene<dim> &scene, const std::vector<SampledSurface<dim>> &samples, FrameTask<dim> &task)
{
  const SampledSurface<dim> &body = samples[task.named.body];
  if (const RigidRays<dim> *const line = scene.line_of(task.named))
  {
    task.image =
        std::make_unique<SampledSurface<dim>>(line->facing(body, task.near, reach_of(scene, task.named)));
    task.partner = task.image.get();
    if (!task.partner->samples.empty())
      task.stretches = stretches_between(*task.partner, body, reach_of(scene, task.named));
  }
  else if (task.named.partner == Frame<dim>::none)
    task.stretches = stretches_at_plane(body, scene.walls[task.named.wall], reach_of(scene, task.named));
  else
  {
    task.partner = &samples[task.named.partner];
    if (task.apart.norm_square() > 0.)
    {
      task.image = std::make_unique<SampledSurface<dim>>(*task.partner);
      for (auto &sample : task.image->samples)
        sample.position += task.apart;
      task.partner = task.image.get();
    }
    task.stretches = stretches_between(*task.partner, body, reach_of(scene, task.named),
                                       task.named.partner == task.named.body);
  }
  add_corners(task.partner, body, task.stretches);
}

/// What the frames for the stretches of a task have in common with those before.
template <int dim>
std::vector<Frame<dim>> named_frames(const FrameTask<dim> &task, const SampledSurface<dim> &body)
{
  std::vector<Frame<dim>> result(task.stretches.size(), task.named);
  for (unsigned int s = 0; s < result.size(); ++s)
    if (const unsigned int corner = result[s].corner = task.stretches[s].corner; corner != Frame<dim>::none)
    {
      const SampledSurface<dim> &with_corner = corner == 0 ? *task.partner : body;
      result[s].rays.resize(1);
      result[s].rays[0].place[corner] = with_corner.samples[task.stretches[s].facing.front()[corner]].place;
    }
  return result;
}

/// Rays of a frame that is new remember what has become of the material that they meet. @param before frames
/// that have no successor
template <int dim>
void inherit_memory(const FramesBefore<dim> &before, Frame<dim> &frame)
{
  const auto [first, end] = before.equal_range(key_of(frame));
  for (typename Frame<dim>::RayPlace &ray : frame.rays)
  {
    double nearest = 0.75 * frame.spacing;
    for (auto old = first; old != end; ++old)
      for (const typename Frame<dim>::RayPlace &other : old->second.rays)
        if (const double distance = other.place[1].position.distance(ray.place[1].position);
            distance < nearest)
        {
          nearest = distance;
          ray.memory = other.memory;
        }
  }
}

/// What all tasks have in common.
template <int dim>
struct LookedAt
{
  const FrameScene<dim> &scene;
  const std::vector<SampledSurface<dim>> &samples; ///< of bodies
};

/// Whether a frame that is kept has to be turned.
template <int dim>
bool turns(const Frame<dim> &frame, const FrameStretch<dim> &stretch)
{
  return frame.corner == Frame<dim>::none && frame.direction * stretch.direction < keeps_direction;
}

/// Finds the frames of some tasks. @param before frames of the step before that have no successor yet
template <int dim>
void find_here(const LookedAt<dim> &at, FramesBefore<dim> &before, const std::vector<FrameTask<dim> *> &tasks)
{
  parallel_for(tasks.size(), 4,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                   look(at.scene, at.samples, *tasks[i]);
               });
  for (FrameTask<dim> *const task : tasks)
    task->found =
        start_frames(at.scene, task->stretches, named_frames(*task, at.samples[task->named.body]), before);
  const bool remembers = at.scene.adhesion != nullptr && at.scene.adhesion->remembers();
  parallel_for(tasks.size(), 4,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                 {
                   FrameTask<dim> &task = *tasks[i];
                   const FrameLayout<dim> layout(at.scene, task.apart, task.partner,
                                                 at.samples[task.named.body]);
                   for (unsigned int s = 0; s < task.found.size(); ++s)
                   {
                     Frame<dim> &frame = task.found[s];
                     const FrameStretch<dim> &stretch = task.stretches[s];
                     if (frame.corner == Frame<dim>::none && frame.rays.empty())
                       layout.center(stretch, frame);
                     else if (turns(frame, stretch))
                       layout.turn(stretch.direction, frame);
                     layout.lay(stretch, frame);
                     if (remembers && frame.id == 0)
                       inherit_memory(before, frame);
                   }
                 }
               });
}

/// Finds the frames of all tasks, those of others' bodies by asking their owners.
template <int dim>
void find_in_tasks(const LookedAt<dim> &at, FramesBefore<dim> &before, std::vector<FrameTask<dim>> &tasks)
{
  const BodyShare *const share = at.scene.looking;
  std::vector<FrameTask<dim> *> here, elsewhere;
  for (FrameTask<dim> &task : tasks)
    (share == nullptr || share->mine(task.named.body) ? here : elsewhere).push_back(&task);
  if (share == nullptr)
    return find_here(at, before, here);
  std::vector<std::vector<double>> told(at.scene.bodies.size());
  share->share_lists(
      [&]()
      {
        find_here(at, before, here);
        for (const FrameTask<dim> *const task : here)
          if (!share->alone())
            tell_frames(task->found, told[task->named.body]);
      },
      told);
  std::vector<const double *> next;
  for (const std::vector<double> &of_body : told)
    next.push_back(of_body.data());
  for (FrameTask<dim> *const task : elsewhere)
    task->found = take_frames(task->named, next[task->named.body]);
}
} // namespace

template <int dim>
dealii::Tensor<1, dim> apart_of(const FrameScene<dim> &scene, const ContactFrame<dim> &frame)
{
  if (scene.cell == nullptr || frame.partner == Frame<dim>::none)
    return dealii::Tensor<1, dim>();
  typename PeriodicCell<dim>::Image here = frame.image;
  for (unsigned int d = 0; d < dim; ++d)
    here[d] += scene.bodies[frame.partner].home[d] - scene.bodies[frame.body].home[d];
  return scene.cell->cell.shift(here);
}

template <int dim>
Ray<dim> ray_of(const ContactFrame<dim> &frame,
                const dealii::Tensor<1, dim - 1> &offset,
                const dealii::Tensor<1, dim> &away)
{
  Ray<dim> ray;
  ray.origin = frame.origin - away;
  ray.direction = frame.direction;
  ray.across = frame.across;
  ray.offset = offset;
  return ray;
}

template <int dim>
std::vector<ContactFrame<dim>> find_frames(const FrameScene<dim> &scene,
                                           std::vector<ContactFrame<dim>> frames)
{
  const bool any_lines = scene.lines != nullptr && !scene.lines->empty();
  if (scene.bodies.size() < 2 && scene.walls.empty() && !any_lines && scene.cell == nullptr)
    return {}; // nothing meets anything; folds of a body alone are left to the check of outlines
  std::uint64_t next_id = 1;
  for (const Frame<dim> &frame : frames)
    next_id = std::max(next_id, frame.id + 1);
  FramesBefore<dim> before = frames_before(scene, std::move(frames));
  std::vector<SampledSurface<dim>> samples(scene.bodies.size());
  parallel_for(samples.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   samples[b] = sample_surface(scene.bodies[b], scene.outlines[b]);
               });
  std::vector<FrameTask<dim>> tasks = find_frame_tasks(scene, samples);
  find_in_tasks(LookedAt<dim>{scene, samples}, before, tasks);
  std::vector<Frame<dim>> result;
  for (FrameTask<dim> &task : tasks)
    for (Frame<dim> &frame : task.found)
      if (!frame.rays.empty())
      {
        if (frame.id == 0)
          frame.id = next_id++;
        result.push_back(std::move(frame));
      }
  return result;
}

template dealii::Tensor<1, 2> apart_of(const FrameScene<2> &, const ContactFrame<2> &);
template dealii::Tensor<1, 3> apart_of(const FrameScene<3> &, const ContactFrame<3> &);
template Ray<2> ray_of(const ContactFrame<2> &, const dealii::Tensor<1, 1> &, const dealii::Tensor<1, 2> &);
template Ray<3> ray_of(const ContactFrame<3> &, const dealii::Tensor<1, 2> &, const dealii::Tensor<1, 3> &);
template std::vector<ContactFrame<2>> find_frames(const FrameScene<2> &, std::vector<ContactFrame<2>>);
template std::vector<ContactFrame<3>> find_frames(const FrameScene<3> &, std::vector<ContactFrame<3>>);
} // namespace softgrain::mpm
