// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/frame_stretches.h>
#include <softgrain/mpm/contact/image_pairs.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

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
/// Of straight sides, which have no more shapes than there are cells along them.
constexpr double spacing_at_straight_sides = 0.85;
constexpr double straight = 1e-3;           ///< curvature at rest, per cell
constexpr double keeps_direction = 0.98163; ///< cosine of 11 degrees
constexpr double steepest = 2.;             ///< slope of a surface over the lattice

class Layout
{
public:
  /// @param partner samples of the image that the body meets; null: a wall
  Layout(const FrameScene &scene,
         const Vector &apart,
         const SampledSurface<2> *partner,
         const SampledSurface<2> &body)
      : scene(scene), apart(apart), partner(partner), body(body)
  {
  }

  /// Gives a frame the rays that a stretch wants; forces of rays that stay are kept.
  void lay(const FrameStretch &stretch, Frame &frame) const
  {
    const Vector t = frame.across[0];
    double lower = std::numeric_limits<double>::max(), upper = -lower;
    std::array<std::vector<std::pair<double, const SurfacePlace<2> *>>, 2> guesses;
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
      {
        const unsigned int b = side == 0 ? frame.partner : frame.body;
        if (b == Frame::none)
        {
          height[side] = (scene.walls[frame.wall].point - frame.origin) * frame.direction;
          continue;
        }
        if (side == stretch.corner)
        {
          const auto &corner = surface(side).samples[stretch.facing.front()[side]];
          place.place[side] = corner.place;
          height[side] = (corner.position - frame.origin) * frame.direction;
          continue;
        }
        const SurfacePlace<2> *guess = nullptr;
        if (old != frame.rays.end())
          guess = &old->place[side];
        else
        {
          double best = std::numeric_limits<double>::max();
          for (const auto &[y, at] : guesses[side])
            if (std::abs(y - k * frame.spacing) < best)
            {
              best = std::abs(y - k * frame.spacing);
              guess = at;
            }
        }
        if (guess == nullptr)
        {
          met = false;
          break;
        }
        const RaySide<2> found = meet(ray_of(frame, k * frame.spacing, away(side)), scene.outlines[b],
                                      scene.bodies[b].field, scene.bodies[b].displacement, *guess);
        met = found.met && std::abs(found.normal * t) < steepest;
        place.place[side] = found.place;
        height[side] = found.height;
      }
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

  /// Moves a new frame to where the two are nearest, and turns it to their normals there: a light contact is
  /// met at its middle.
  void center(const FrameStretch &stretch, Frame &frame) const
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

private:
  const SampledSurface<2> &surface(const unsigned int side) const { return side == 0 ? *partner : body; }
  Vector away(const unsigned int side) const { return side == 0 ? apart : Vector(); }

  /// Where on the grids of both the frame begins.
  void note_dent(const std::array<SurfacePlace<2>, 2> &place, Frame &frame) const
  {
    for (unsigned int side = 0; side < 2; ++side)
    {
      const unsigned int b = side == 0 ? frame.partner : frame.body;
      if (b != Frame::none && SubgridCompliance::is_round(scene.bodies[b]))
        frame.log_full_width[1 - side] = scene.subgrid.log_full_width(
            scene.bodies[b].law->poisson_ratio(), place[side].position, place[side].normal);
    }
  }

  const FrameScene &scene;
  const Vector &apart;
  const SampledSurface<2> *partner;
  const SampledSurface<2> &body;
};

/// A pair to be looked at, and what is found there.
struct Task
{
  Frame named;
  Vector apart;
  std::unique_ptr<SampledSurface<2>> image; ///< of the partner, where that is none of the body itself
  const SampledSurface<2> *partner = nullptr;
  std::vector<Frame> found;
  std::vector<FrameStretch> stretches;
};

/// Boxes around the outlines as they stand in the cell, grown by half the reach, and the copies in which the
/// bodies are.
struct Boxes
{
  std::vector<dealii::BoundingBox<2>> box;
  std::vector<PeriodicCell<2>::Image> fold;
};

Boxes boxes_of(const FrameScene &scene, const std::vector<SampledSurface<2>> &samples)
{
  Boxes boxes;
  for (unsigned int b = 0; b < samples.size(); ++b)
  {
    boxes.fold.emplace_back();
    Vector back;
    if (scene.cell != nullptr)
    {
      boxes.fold.back() = scene.cell->cell.image_of(scene.bodies[b].center());
      back = scene.cell->cell.shift(boxes.fold.back());
    }
    Point lower = samples[b].samples.front().position, upper = lower;
    for (const auto &s : samples[b].samples)
      for (unsigned int d = 0; d < 2; ++d)
      {
        lower[d] = std::min(lower[d], s.position[d] - 0.5 * scene.reach);
        upper[d] = std::max(upper[d], s.position[d] + 0.5 * scene.reach);
      }
    boxes.box.push_back(dealii::BoundingBox<2>({lower - back, upper - back}));
  }
  return boxes;
}

/// All that may touch, in an order that depends on nothing but the bodies.
std::vector<Task> find_tasks(const FrameScene &scene, const std::vector<SampledSurface<2>> &samples)
{
  const Boxes boxes = boxes_of(scene, samples);
  std::vector<Task> tasks;
  const auto add = [&](unsigned int body, unsigned int partner, PeriodicCell<2>::Image image)
  {
    const std::vector<Body<2>> &bodies = scene.bodies;
    if (bodies[body].driven && bodies[partner].driven)
      return;
    // A body that is driven is always the partner.
    if (bodies[body].driven || (!bodies[partner].driven && partner > body))
    {
      std::swap(body, partner);
      image = {{-image[0], -image[1]}};
    }
    Task task;
    task.named.body = body;
    task.named.partner = partner;
    for (unsigned int d = 0; d < 2; ++d)
      task.named.image[d] = image[d] + boxes.fold[body][d] - boxes.fold[partner][d] + bodies[body].home[d] -
                            bodies[partner].home[d];
    task.apart = scene.apart(task.named);
    tasks.push_back(std::move(task));
  };
  const auto tree = dealii::pack_rtree_of_indices(boxes.box);
  for (unsigned int b = 0; b < samples.size(); ++b)
  {
    for (unsigned int w = 0; w < scene.walls.size() && !scene.bodies[b].driven; ++w)
      if (scene.walls[w].plane)
      {
        Task task;
        task.named.body = b;
        task.named.wall = w;
        tasks.push_back(std::move(task));
      }
    std::vector<unsigned int> near;
    tree.query(boost::geometry::index::intersects(boxes.box[b]), std::back_inserter(near));
    std::sort(near.begin(), near.end());
    for (const unsigned int a : near)
      if (a < b)
        add(b, a, {});
  }
  if (scene.cell != nullptr)
    for (const ImagePair &pair : pairs_across(boxes.box, scene.cell->cell))
    {
      if (pair.a == pair.b)
        throw ComputationError("the cell that repeats has become too small: body '" +
                               scene.bodies[pair.a].name + "' meets itself");
      add(pair.a, pair.b, pair.image);
    }
  return tasks;
}

/// Finds the stretches of a pair.
void look(const FrameScene &scene, const std::vector<SampledSurface<2>> &samples, Task &task)
{
  const SampledSurface<2> &body = samples[task.named.body];
  if (task.named.partner == Frame::none)
    task.stretches = stretches_at_plane(body, scene.walls[task.named.wall], scene.reach);
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
    task.stretches = stretches_between(*task.partner, body, scene.reach);
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
                                     [](const Frame::RayPlace &ray) { return ray.force > 0.; });
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
  std::vector<Task> tasks = find_tasks(scene, samples);
  parallel_for(tasks.size(), 4,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                   look(scene, samples, tasks[i]);
               });
  for (Task &task : tasks)
    for (const FrameStretch &stretch : task.stretches)
    {
      Frame named = task.named;
      named.corner = stretch.corner;
      if (stretch.corner != Frame::none)
      {
        named.rays.resize(1);
        named.rays[0].place[stretch.corner] = (stretch.corner == 0 ? *task.partner : samples[named.body])
                                                  .samples[stretch.facing.front()[stretch.corner]]
                                                  .place;
      }
      task.found.push_back(start_frame(scene, stretch, named, before));
    }
  parallel_for(tasks.size(), 4,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                 {
                   const Layout layout(scene, tasks[i].apart, tasks[i].partner, samples[tasks[i].named.body]);
                   for (unsigned int s = 0; s < tasks[i].found.size(); ++s)
                   {
                     if (tasks[i].found[s].rays.empty() && tasks[i].found[s].corner == Frame::none)
                       layout.center(tasks[i].stretches[s], tasks[i].found[s]);
                     layout.lay(tasks[i].stretches[s], tasks[i].found[s]);
                   }
                 }
               });
  std::vector<Frame> result;
  for (Task &task : tasks)
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
