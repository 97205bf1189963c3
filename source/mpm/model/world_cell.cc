// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/model/world.h>

#include <algorithm>

namespace softgrain::mpm
{
bool World::repeats() const
{
  return std::any_of(walls.begin(), walls.end(), [](const Wall &wall) { return wall.repeats(); });
}

std::optional<CellMotion> World::cell_motion(const std::vector<WallMotion<2>> &motion) const
{
  if (!repeats())
    return std::nullopt;
  CellMotion cell;
  cell.cell = cell_of(walls);
  for (unsigned int w = 0; w < walls.size(); ++w)
    if (walls[w].repeats())
      cell.add_side(motion[w].normal,
                    motion[w].velocity * motion[w].normal + motion[w].slide * motion[w].tangent());
  return cell;
}

dealii::Tensor<2, 2> World::cell_gradient(const std::vector<WallMotion<2>> &motion) const
{
  const std::optional<CellMotion> cell = cell_motion(motion);
  return cell ? cell->gradient : dealii::Tensor<2, 2>();
}

void World::bring_into_cell(Body<2> &body) const
{
  if (!repeats())
    return;
  const PeriodicCell cell = cell_of(walls);
  const PeriodicCell::Image image = cell.image_of(body.center());
  if (image == PeriodicCell::Image())
    return;
  for (unsigned int d = 0; d < 2; ++d)
    body.home[d] += image[d];
  body.translate(-cell.shift(image));
  move_boundary(body);
}
} // namespace softgrain::mpm
