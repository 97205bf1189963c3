// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/contact/folded_surface.h>
#include <softgrain/mpm/contact/frame_tasks.h>
#include <softgrain/mpm/contact/image_pairs.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <utility>

namespace softgrain::mpm
{
namespace
{
/// Boxes around the outlines as they stand in the cell, grown by half the reach, and the copies in which the
/// bodies are.
template <int dim>
struct Boxes
{
  std::vector<dealii::BoundingBox<dim>> box;
  std::vector<typename PeriodicCell<dim>::Image> fold;
};

template <int dim>
Boxes<dim> boxes_of(const FrameScene<dim> &scene, const std::vector<SampledSurface<dim>> &samples)
{
  Boxes<dim> boxes;
  for (unsigned int b = 0; b < samples.size(); ++b)
  {
    boxes.fold.emplace_back();
    dealii::Tensor<1, dim> back;
    if (scene.cell != nullptr)
    {
      boxes.fold.back() = scene.cell->cell.image_of(scene.bodies[b].center());
      back = scene.cell->cell.shift(boxes.fold.back());
    }
    const double reach = 0.5 * scene.reach + scene.ways.own_of(b);
    dealii::Point<dim> lower = samples[b].samples.front().position, upper = lower;
    for (const auto &s : samples[b].samples)
      for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = std::min(lower[d], s.position[d] - reach);
        upper[d] = std::max(upper[d], s.position[d] + reach);
      }
    boxes.box.push_back(dealii::BoundingBox<dim>({lower - back, upper - back}));
  }
  return boxes;
}

/// All tasks, as they are found.
template <int dim>
class TaskList
{
public:
  using Image = typename PeriodicCell<dim>::Image;

  TaskList(const FrameScene<dim> &scene, const std::vector<SampledSurface<dim>> &samples)
      : scene(scene), samples(samples), boxes(boxes_of(scene, samples))
  {
  }

  const std::vector<dealii::BoundingBox<dim>> &box() const { return boxes.box; }

  /// Adds a pair of bodies, if one of them can move.
  void add_pair(unsigned int body, unsigned int partner, Image image)
  {
    const std::vector<Body<dim>> &bodies = scene.bodies;
    if (bodies[body].rigid.driven && bodies[partner].rigid.driven)
      return;
    // A body that is driven is always the partner.
    if (bodies[body].rigid.driven || (!bodies[partner].rigid.driven && partner > body))
    {
      std::swap(body, partner);
      for (int &n : image)
        n = -n;
    }
    FrameTask<dim> &task = add(body);
    task.named.partner = partner;
    for (unsigned int d = 0; d < dim; ++d)
      task.named.image[d] = image[d] + boxes.fold[body][d] - boxes.fold[partner][d] + bodies[body].home[d] -
                            bodies[partner].home[d];
    task.apart = apart_of(scene, task.named);
  }

  /// Adds body @p b, which can move, with walls, obstacles and itself where it may have folded.
  void add_alone(const unsigned int b)
  {
    for (unsigned int w = 0; w < scene.walls.size(); ++w)
      if (scene.walls[w].plane)
        add(b).named.wall = w;
    for (unsigned int o = 0; scene.lines != nullptr && o < scene.lines->size(); ++o)
    {
      FrameTask<dim> &task = add(b);
      task.named.wall = PartnerNumbers(scene.walls.size()).of_obstacle(o);
      task.near = boxes.box[b];
      task.near.extend(0.5 * scene.reach + scene.cell_size);
    }
    if constexpr (dim == 2)
      if (is_folded(samples[b]))
        add(b).named.partner = b;
  }

  std::vector<FrameTask<dim>> tasks;

private:
  FrameTask<dim> &add(const unsigned int body)
  {
    tasks.emplace_back();
    tasks.back().named.body = body;
    return tasks.back();
  }

  const FrameScene<dim> &scene;
  const std::vector<SampledSurface<dim>> &samples;
  const Boxes<dim> boxes;
};
} // namespace

template <int dim>
std::vector<FrameTask<dim>> find_frame_tasks(const FrameScene<dim> &scene,
                                             const std::vector<SampledSurface<dim>> &samples)
{
  TaskList<dim> list(scene, samples);
  const auto tree = dealii::pack_rtree_of_indices(list.box());
  for (unsigned int b = 0; b < samples.size(); ++b)
  {
    if (!scene.bodies[b].rigid.driven)
      list.add_alone(b);
    std::vector<unsigned int> near;
    tree.query(boost::geometry::index::intersects(list.box()[b]), std::back_inserter(near));
    std::sort(near.begin(), near.end());
    for (const unsigned int a : near)
      if (a < b)
        list.add_pair(b, a, {});
  }
  if (scene.cell != nullptr)
    for (const ImagePair<dim> &pair : pairs_across(list.box(), scene.cell->cell))
    {
      if (pair.a == pair.b)
        throw ComputationError("the cell that repeats has become too small: body '" +
                               scene.bodies[pair.a].name + "' meets itself");
      list.add_pair(pair.a, pair.b, pair.image);
    }
  return std::move(list.tasks);
}

template std::vector<FrameTask<2>> find_frame_tasks(const FrameScene<2> &,
                                                    const std::vector<SampledSurface<2>> &);
template std::vector<FrameTask<3>> find_frame_tasks(const FrameScene<3> &,
                                                    const std::vector<SampledSurface<3>> &);
} // namespace softgrain::mpm
