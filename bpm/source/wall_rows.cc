// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Dynamics that meets walls.
#include <softgrain/bpm/dynamics.h>

namespace softgrain::bpm
{
std::vector<Dynamics::AtWall> Dynamics::find_at_walls(const std::vector<Wall<2>> &walls,
                                                      const std::size_t begin,
                                                      const std::size_t end) const
{
  std::vector<AtWall> at_walls;
  for (std::uint32_t w = 0; w < walls.size(); ++w)
  {
    const Wall<2> &wall = walls[w];
    if (is_side_of_cell(wall))
      continue;
    const dealii::Point<2> &start = wall.description.point;
    const std::array<double, 2> normal = {wall.normal()[0], wall.normal()[1]};
    const double offset = start[0] * normal[0] + start[1] * normal[1] + wall.travel, speed = wall.speed;
    for (std::uint32_t i = begin; i < end; ++i)
    {
      const double opening = primaries.position[i][0] * normal[0] + primaries.position[i][1] * normal[1] -
                             offset - primaries.radius[i];
      const std::array<double, 2> &v = primaries.velocity[i];
      if (inverse_mass[i] != 0. &&
          closes({v[0] - speed * normal[0], v[1] - speed * normal[1]}, normal, opening))
        at_walls.push_back({w, i, opening});
    }
  }
  return at_walls;
}

void Dynamics::add_wall_rows(const std::vector<Wall<2>> &walls, const std::vector<AtWall> &at_walls)
{
  std::size_t row = rows.size();
  resize_rows(row + at_walls.size());
  auto known_before = remembered.at_walls.begin();
  for (const AtWall &at : at_walls)
  {
    const std::uint32_t i = at.primary, number = primaries.number_of(i);
    const dealii::Tensor<1, 2> &normal = walls[at.wall].normal();
    // Both this loop and the memory run through walls and primaries in order.
    while (
        known_before != remembered.at_walls.end() &&
        (known_before->wall < at.wall || (known_before->wall == at.wall && known_before->primary < number)))
      ++known_before;
    const bool known = known_before != remembered.at_walls.end() && known_before->wall == at.wall &&
                       known_before->primary == number;
    set_row(row, i, primaries.size() + at.wall, {normal[0], normal[1]}, at.gap,
            settings.pairs.friction_at_wall(primaries.body[i], at.wall),
            primaries.radius[i] * settings.rolling_resistance,
            known ? known_before->impulse : contact::PairMemory::Impulses{});
    if (cell)
    {
      const dealii::Point<2> &center = center_of_body[primaries.body[i]];
      for (unsigned int d = 0; d < 2; ++d)
        rows.branch[row][d] =
            center[d] - (primaries.position[i][d] - (primaries.radius[i] + at.gap) * normal[d]);
    }
    ++row;
  }
}
} // namespace softgrain::bpm
