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

void World::measure_against_cell(const CellMotion &cell, const double dt)
{
  dealii::Tensor<2, 2> stretch = dt * cell.gradient;
  for (unsigned int d = 0; d < 2; ++d)
    stretch[d][d] += 1.;
  const dealii::Tensor<2, 2> after = cell.gradient * invert(stretch);
  for (Body<2> &body : bodies)
  {
    const double mass = body.mass.sum();
    const dealii::Tensor<1, 2> momentum = body.momentum(), change = -dt / mass * (after * momentum);
    for (unsigned int i = 0; i < body.mass.size(); ++i)
      for (unsigned int d = 0; d < 2; ++d)
        body.velocity[2 * i + d] += change[d];
    balance.body_force_impulse += mass * change;
    balance.body_force_work += (momentum + 0.5 * mass * change) * change;
  }
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
