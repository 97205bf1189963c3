// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/wall_position.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/wall.h>
#include <softgrain/geometry/box.h>
#include <softgrain/model/state_file.h>

namespace softgrain
{
namespace
{
constexpr std::size_t n_numbers = 8; // that the state of a wall is made of
}

WallState<2> Wall::state() const
{
  WallState<2> state;
  state.name = description.name;
  state.point = point();
  state.normal = normal();
  state.position = wall_position(state.point, state.normal);
  state.velocity = speed;
  state.normal_force = 0. - force * normal();
  state.tangential_force = force * tangent();
  return state;
}

std::vector<Wall> make_walls(const std::vector<WallDescription<2>> &descriptions)
{
  std::vector<Wall> walls;
  for (const WallDescription<2> &description : descriptions)
  {
    walls.emplace_back();
    walls.back().description = description;
  }
  return walls;
}

std::vector<WallState<2>> states_of(const std::vector<Wall> &walls)
{
  std::vector<WallState<2>> states;
  for (const Wall &wall : walls)
    states.push_back(wall.state());
  return states;
}

double pressed_length(const std::vector<Wall> &walls, const std::size_t w)
{
  return length_between_neighbours_2d(states_of(walls), w);
}

void save_walls(StateWriter &out, const std::string &name, const std::vector<Wall> &walls)
{
  std::vector<double> numbers;
  for (const Wall &wall : walls)
    numbers.insert(numbers.end(), {wall.travel, wall.speed, wall.force[0], wall.force[1], wall.impulse[0],
                                   wall.impulse[1], wall.carried[0], wall.carried[1]});
  out.write(name, numbers);
}

void load_walls(const StateReader &in, const std::string &name, std::vector<Wall> &walls)
{
  const std::vector<double> numbers = in.read_doubles(name);
  if (numbers.size() != n_numbers * walls.size())
    throw InputError("the checkpoint was made with another number of walls");
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    const double *v = &numbers[n_numbers * w];
    walls[w].travel = v[0];
    walls[w].speed = v[1];
    walls[w].force = dealii::Tensor<1, 2>({v[2], v[3]});
    walls[w].impulse = dealii::Tensor<1, 2>({v[4], v[5]});
    walls[w].carried = dealii::Tensor<1, 2>({v[6], v[7]});
  }
}
} // namespace softgrain
