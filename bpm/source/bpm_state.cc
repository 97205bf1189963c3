// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/bpm_model.h>
#include <softgrain/model/state_file.h>

#include <cstring>

namespace softgrain::bpm
{
namespace
{
template <std::size_t n>
std::vector<double> flat(const std::vector<std::array<double, n>> &values)
{
  std::vector<double> numbers;
  numbers.reserve(n * values.size());
  for (const auto &value : values)
    numbers.insert(numbers.end(), value.begin(), value.end());
  return numbers;
}

template <std::size_t n>
std::vector<std::array<double, n>> unflat(const std::vector<double> &numbers)
{
  std::vector<std::array<double, n>> values(numbers.size() / n);
  for (std::size_t i = 0; i < values.size(); ++i)
    std::memcpy(values[i].data(), numbers.data() + n * i, n * sizeof(double));
  return values;
}
} // namespace

void BpmModel::save(StateWriter &out) const
{
  const Primaries &disks = dynamics->disks();
  out.write("bpm/scalars", std::vector<double>{now, step_scale, last_dt});
  out.write("bpm/step", std::vector<std::uint64_t>{steps, fallbacks});
  out.write("bpm/books",
            std::vector<double>{books.initial_momentum[0], books.initial_momentum[1], books.wall_impulse[0],
                                books.wall_impulse[1], books.body_force_impulse[0],
                                books.body_force_impulse[1], books.largest_momentum, books.wall_work,
                                books.body_force_work, books.contact_loss, books.damping_loss});
  out.write("bpm/position", flat(disks.position));
  out.write("bpm/velocity", flat(disks.velocity));
  out.write("bpm/radius", disks.radius);
  out.write("bpm/angular_velocity", disks.angular_velocity);
  out.write("bpm/start_position", flat(start_position));
  out.write("bpm/area_at_start", area_at_start);
  // The area was measured when the list was made: it is the same after a restart only if it is kept.
  out.write("bpm/solid_area", std::vector<double>{solid_area()});
  std::vector<double> walls;
  for (const MovingWall &wall : moving_walls)
    walls.insert(walls.end(), {wall.travel, wall.velocity, wall.normal_impulse, wall.tangential_impulse});
  out.write("bpm/walls", walls);

  const contact::NeighbourList &list = dynamics->neighbours();
  out.write("bpm/neighbours/build_position", flat(list.build_positions()));
  out.write("bpm/neighbours/memory", flat(list.memory()));
  std::vector<std::uint64_t> indices;
  std::vector<std::array<double, 3>> impulses;
  for (const Dynamics::WallMemory &memory : dynamics->wall_memory())
  {
    indices.insert(indices.end(), {memory.wall, memory.primary});
    impulses.push_back(memory.impulse);
  }
  out.write("bpm/wall_contacts/indices", indices);
  out.write("bpm/wall_contacts/memory", flat(impulses));
}

void BpmModel::load(StateReader &in)
{
  Primaries &disks = dynamics->disks();
  if (in.read_doubles("bpm/radius") != disks.radius ||
      in.read_doubles("bpm/angular_velocity").size() != disks.angular_velocity.size() ||
      in.read_doubles("bpm/walls").size() != 4 * moving_walls.size())
    throw InputError("the checkpoint was made with other primaries, walls or frictions");
  const std::vector<double> scalars = in.read_doubles("bpm/scalars"), b = in.read_doubles("bpm/books"),
                            walls = in.read_doubles("bpm/walls");
  now = scalars.at(0);
  step_scale = scalars.at(1);
  last_dt = scalars.at(2);
  steps = in.read_integers("bpm/step").at(0);
  fallbacks = in.read_integers("bpm/step").at(1);
  books = {dealii::Tensor<1, 2>({b.at(0), b.at(1)}),
           dealii::Tensor<1, 2>({b.at(2), b.at(3)}),
           dealii::Tensor<1, 2>({b.at(4), b.at(5)}),
           b.at(6),
           b.at(7),
           b.at(8),
           b.at(9),
           b.at(10)};
  disks.position = unflat<2>(in.read_doubles("bpm/position"));
  disks.velocity = unflat<2>(in.read_doubles("bpm/velocity"));
  disks.angular_velocity = in.read_doubles("bpm/angular_velocity");
  start_position = unflat<2>(in.read_doubles("bpm/start_position"));
  area_at_start = in.read_doubles("bpm/area_at_start");
  for (std::size_t w = 0; w < moving_walls.size(); ++w)
  {
    moving_walls[w].travel = walls[4 * w];
    moving_walls[w].velocity = walls[4 * w + 1];
    moving_walls[w].normal_impulse = walls[4 * w + 2];
    moving_walls[w].tangential_impulse = walls[4 * w + 3];
  }
  // The same places give the same list in the same order, so that every sum is formed as if never stopped.
  contact::NeighbourList &list = dynamics->neighbours();
  list.build(unflat<2>(in.read_doubles("bpm/neighbours/build_position")));
  list.memory() = unflat<3>(in.read_doubles("bpm/neighbours/memory"));
  const std::vector<std::uint64_t> indices = in.read_integers("bpm/wall_contacts/indices");
  const auto impulses = unflat<3>(in.read_doubles("bpm/wall_contacts/memory"));
  dynamics->wall_memory().clear();
  for (std::size_t k = 0; k < impulses.size(); ++k)
    dynamics->wall_memory().push_back({static_cast<std::uint32_t>(indices.at(2 * k)),
                                       static_cast<std::uint32_t>(indices.at(2 * k + 1)), impulses[k]});
  dynamics->detect(moving_walls);
  area_now = in.read_doubles("bpm/solid_area").at(0);
  area_of_list = dynamics->lists_made();
}
} // namespace softgrain::bpm
