// SPDX-License-Identifier: LGPL-2.1-or-later
// What checkpoints keep of walls.
#include <softgrain/driving/wall.h>
#include <softgrain/model/state_file.h>

#include <algorithm>

namespace softgrain
{
namespace
{
template <int dim>
bool keeps_slide(const Wall<dim> &wall)
{
  return wall.slide_speed != 0. || wall.offset != 0.;
}

// In the order of the file. Of a wall in space it has the force on the bodies.
void add_numbers(const Wall<2> &wall, std::vector<double> &numbers)
{
  numbers.insert(numbers.end(), {wall.travel, wall.speed, wall.book.force[0], wall.book.force[1],
                                 wall.book.impulse[0], wall.book.impulse[1], wall.free.pressure_before,
                                 wall.driven_since.time, wall.driven_since.travel, wall.book.work});
}

void add_numbers(const Wall<3> &wall, std::vector<double> &numbers)
{
  const dealii::Tensor<1, 3> on_bodies = dealii::Tensor<1, 3>() - wall.book.force;
  numbers.insert(numbers.end(),
                 {wall.travel, wall.speed, wall.slide_speed, wall.driven_since.time, wall.driven_since.travel,
                  wall.book.work, on_bodies[0], on_bodies[1], on_bodies[2]});
}

void take_numbers(const double *const v, Wall<2> &wall)
{
  wall.travel = v[0];
  wall.speed = v[1];
  wall.book.force = dealii::Tensor<1, 2>({v[2], v[3]});
  wall.book.impulse = dealii::Tensor<1, 2>({v[4], v[5]});
  wall.free.pressure = wall.free.pressure_before = v[6];
  wall.driven_since.time = v[7];
  wall.driven_since.travel = v[8];
  wall.book.work = v[9];
}

void take_numbers(const double *const v, Wall<3> &wall)
{
  wall.travel = v[0];
  wall.speed = v[1];
  wall.slide_speed = v[2];
  wall.driven_since.time = v[3];
  wall.driven_since.travel = v[4];
  wall.book.work = v[5];
  wall.book.force = dealii::Tensor<1, 3>() - dealii::Tensor<1, 3>({v[6], v[7], v[8]});
}

/// Whether numbers_of() leaves out how walls slide, so that a list of its own has it where one does.
template <int dim>
constexpr bool slides_apart = dim == 2;
} // namespace

template <int dim>
std::vector<double> numbers_of(const std::vector<Wall<dim>> &walls)
{
  std::vector<double> numbers;
  for (const Wall<dim> &wall : walls)
    add_numbers(wall, numbers);
  return numbers;
}

template <int dim>
void take_numbers(const std::vector<double> &numbers, std::vector<Wall<dim>> &walls)
{
  for (std::size_t w = 0; w < walls.size(); ++w)
    take_numbers(&numbers[n_wall_numbers<dim> * w], walls[w]);
}

template <int dim>
void save_walls(StateWriter &out, const std::string &name, const std::vector<Wall<dim>> &walls)
{
  out.write(name, numbers_of(walls));
  if (!slides_apart<dim> || std::none_of(walls.begin(), walls.end(), keeps_slide<dim>))
    return;
  std::vector<double> sliding;
  for (const Wall<dim> &wall : walls)
    sliding.insert(sliding.end(), {wall.slide_speed, wall.offset});
  out.write(name + "_sliding", sliding);
}

template <int dim>
void load_walls(const StateReader &in, const std::string &name, std::vector<Wall<dim>> &walls)
{
  take_numbers(in.read_doubles(name, n_wall_numbers<dim> * walls.size()), walls);
  if (!slides_apart<dim> || !in.contains(name + "_sliding"))
    return;
  const std::vector<double> sliding = in.read_doubles(name + "_sliding", 2 * walls.size());
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    walls[w].slide_speed = sliding[2 * w];
    walls[w].offset = sliding[2 * w + 1];
  }
}

template std::vector<double> numbers_of(const std::vector<Wall<2>> &);
template void take_numbers(const std::vector<double> &, std::vector<Wall<2>> &);
template void save_walls(StateWriter &, const std::string &, const std::vector<Wall<2>> &);
template void load_walls(const StateReader &, const std::string &, std::vector<Wall<2>> &);
template std::vector<double> numbers_of(const std::vector<Wall<3>> &);
template void take_numbers(const std::vector<double> &, std::vector<Wall<3>> &);
template void save_walls(StateWriter &, const std::string &, const std::vector<Wall<3>> &);
template void load_walls(const StateReader &, const std::string &, std::vector<Wall<3>> &);
} // namespace softgrain
