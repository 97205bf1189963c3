// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/contact/contact_tasks.h>
#include <softgrain/mpm/contact/image_pairs.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
PeriodicCell<2>::Image opposite(const PeriodicCell<2>::Image &image)
{
  return {{-image[0], -image[1]}};
}

/// Lists a pair once: as a task of its first body, or of the second where the first is driven.
/// @param image of @p b, that @p a meets
void share_out(const OutlineScene &scene,
               const unsigned int a,
               const unsigned int b,
               const PeriodicCell<2>::Image &image,
               std::vector<std::vector<ContactTask>> &tasks)
{
  if (!scene.bodies[a].rigid.driven)
    tasks[a].push_back({b, image});
  else if (!scene.bodies[b].rigid.driven)
    tasks[b].push_back({a, opposite(image)});
}
} // namespace

std::vector<std::vector<ContactTask>> find_tasks(const OutlineScene &scene,
                                                 const std::vector<MovedBoundary> &boundaries)
{
  // Grown by this each, boxes overlap whenever bodies may meet on their ways.
  double walls_way = 0.;
  for (const WallMotion<2> &wall : scene.walls)
    walls_way = std::max(walls_way, scene.dt * wall.fastest);
  std::vector<dealii::BoundingBox<2>> boxes;
  for (const MovedBoundary &boundary : boundaries)
  {
    dealii::BoundingBox<2> box = boundary.box();
    box.extend(0.05 * scene.cell_size + 0.5 * walls_way + boundary.travel.norm() + boundary.spread);
    boxes.push_back(box);
  }
  const auto tree = dealii::pack_rtree_of_indices(boxes);
  std::vector<std::vector<ContactTask>> tasks(boxes.size());
  const auto looks = [&scene](const std::size_t b)
  { return scene.looking == nullptr || scene.looking->mine(static_cast<unsigned int>(b)); };
  for (unsigned int b = 0; b < boxes.size(); ++b)
    if (looks(b))
      for (const std::size_t a :
           tree | boost::geometry::index::adaptors::queried(boost::geometry::index::intersects(boxes[b])))
        // Once for a pair, of which one body at least looks here.
        if (a < b || (a > b && !looks(a)))
          share_out(scene, std::min<unsigned int>(a, b), std::max<unsigned int>(a, b), {}, tasks);
  if (scene.cell != nullptr)
    for (const ImagePair<2> &pair : pairs_across(boxes, scene.cell->cell))
    {
      if (pair.a == pair.b)
        throw ComputationError("the cell that repeats has become too small: body '" +
                               scene.bodies[pair.a].name + "' meets itself");
      // As for those inside: who looks does not depend on where the sides are.
      if (pair.a < pair.b)
        share_out(scene, pair.a, pair.b, pair.image, tasks);
      else
        share_out(scene, pair.b, pair.a, opposite(pair.image), tasks);
    }
  for (std::vector<ContactTask> &list : tasks)
    std::sort(list.begin(), list.end());
  return tasks;
}

MovedBoundary
image_of(const MovedBoundary &boundary, const PeriodicCell<2>::Image &image, const OutlineScene &scene)
{
  const dealii::Tensor<1, 2> way = scene.cell->cell.shift(image);
  MovedBoundary moved = boundary;
  moved.shift(way, scene.dt * (scene.cell->gradient * way), scene.share);
  return moved;
}

/// Brings bodies into the cell. @return the copy of the cell each was in; empty when nothing repeats
std::vector<PeriodicCell<2>::Image> fold_into_cell(const OutlineScene &scene,
                                                   std::vector<MovedBoundary> &boundaries)
{
  std::vector<PeriodicCell<2>::Image> folds;
  if (scene.cell == nullptr)
    return folds;
  for (MovedBoundary &boundary : boundaries)
  {
    folds.push_back(scene.cell->cell.image_of(boundary.start));
    fold_back(scene, folds.back(), boundary);
  }
  return folds;
}

void fold_back(const OutlineScene &scene, const PeriodicCell<2>::Image &fold, MovedBoundary &boundary)
{
  if (fold != PeriodicCell<2>::Image())
    boundary = image_of(boundary, opposite(fold), scene);
}
} // namespace softgrain::mpm
