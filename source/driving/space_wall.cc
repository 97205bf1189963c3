// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/wall_position.h>
#include <softgrain/driving/space_wall.h>
#include <softgrain/model/state_file.h>

namespace softgrain
{
void SpaceWall::plan(const double time, const double dt)
{
  const WallStep step{time - drive_begin, dt, travel - travel_before};
  speed = description.drive->demand(step).velocity;
  slide = description.drive->slide_velocity(step);
}

void SpaceWall::go(const double dt, const dealii::Tensor<1, 3> &impulse)
{
  force = impulse / dt;
  work += impulse * velocity();
  travel += dt * speed;
}

WallState<3> SpaceWall::state() const
{
  WallState<3> state;
  state.name = description.name;
  state.point = point();
  state.normal = normal();
  state.position = wall_position(state.point, state.normal);
  state.velocity = speed;
  state.slide_velocity = slide;
  state.normal_force = force * normal();
  state.tangential_force = 0. - force * tangent();
  return state;
}

std::vector<SpaceWall> make_walls(const Scene<3> &scene)
{
  std::vector<SpaceWall> walls;
  for (const WallDescription<3> &description : scene.walls)
  {
    walls.emplace_back();
    walls.back().description = description;
  }
  return walls;
}

void take_drives(std::vector<SpaceWall> &walls,
                 const std::vector<std::shared_ptr<const WallDrive>> &drives,
                 const double time)
{
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (drives[w])
    {
      walls[w].description.drive = drives[w];
      walls[w].drive_begin = time;
      walls[w].travel_before = walls[w].travel;
    }
}

void save_walls(StateWriter &out, const std::string &name, const std::vector<SpaceWall> &walls)
{
  std::vector<double> numbers;
  for (const SpaceWall &wall : walls)
    numbers.insert(numbers.end(), {wall.travel, wall.speed, wall.slide, wall.drive_begin, wall.travel_before,
                                   wall.work, wall.force[0], wall.force[1], wall.force[2]});
  out.write(name, numbers);
}

void load_walls(const StateReader &in, const std::string &name, std::vector<SpaceWall> &walls)
{
  const std::vector<double> numbers = in.read_doubles(name, 9 * walls.size());
  const double *from = numbers.data();
  for (SpaceWall &wall : walls)
  {
    for (double *const number :
         {&wall.travel, &wall.speed, &wall.slide, &wall.drive_begin, &wall.travel_before, &wall.work})
      *number = *from++;
    for (unsigned int d = 0; d < 3; ++d)
      wall.force[d] = *from++;
  }
}
} // namespace softgrain
