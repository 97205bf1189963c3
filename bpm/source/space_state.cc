// SPDX-License-Identifier: LGPL-2.1-or-later
// What checkpoints keep of SpaceModel.
#include <softgrain/bpm/space_model.h>
#include <softgrain/model/state_file.h>

#include <algorithm>

namespace softgrain::bpm
{
namespace
{
using Vectors = std::vector<std::array<double, 3>>;

std::vector<double> flat(const Vectors &vectors)
{
  std::vector<double> numbers;
  numbers.reserve(3 * vectors.size());
  for (const std::array<double, 3> &one : vectors)
    numbers.insert(numbers.end(), one.begin(), one.end());
  return numbers;
}

void take(const StateReader &in, const std::string &name, Vectors &vectors)
{
  const std::vector<double> numbers = in.read_doubles(name, 3 * vectors.size());
  for (std::size_t i = 0; i < vectors.size(); ++i)
    std::copy_n(&numbers[3 * i], 3, vectors[i].begin());
}
} // namespace

void SpaceModel::save(StateWriter &out) const
{
  const Balls &balls = dynamics->balls();
  out.write("bpm/scalars", std::vector<double>{now, step_control.scale, last_dt, contact_loss,
                                               largest_momentum, impulse[0], impulse[1], impulse[2]});
  out.write("bpm/step", std::vector<std::uint64_t>{steps, fallbacks});
  load_work.save(out, "bpm/loads");
  out.write("bpm/radius", balls.radius);
  out.write("bpm/position", flat(balls.position));
  out.write("bpm/velocity", flat(balls.velocity));
  out.write("bpm/angular_velocity", flat(balls.angular_velocity));
  out.write("bpm/start_position", flat(balls.start));
  save_walls(out, "bpm/walls", moving_walls);
  out.write("bpm/volume_at_start", volume_at_start);
  // The volume was measured after the list was made: it is the same after a restart only if it is kept.
  const bool measured = volume_of_list == dynamics->present().lists_made();
  out.write("bpm/solid_volume", std::vector<double>{measured ? volume_now : -1.});
  out.write("bpm/neighbours/build_position", flat(dynamics->neighbours().build_positions()));
  out.write("bpm/neighbours/memory", dynamics->neighbours().all_memories());
  std::vector<std::uint64_t> indices;
  std::vector<double> impulses;
  for (const BallDynamics::WallMemory &memory : dynamics->wall_memory())
  {
    indices.insert(indices.end(), {memory.wall, memory.ball});
    impulses.insert(impulses.end(), memory.impulse.begin(), memory.impulse.end());
  }
  out.write("bpm/wall_contacts/indices", indices);
  out.write("bpm/wall_contacts/memory", impulses);
}

void SpaceModel::load(StateReader &in)
{
  Balls &balls = dynamics->balls();
  if (in.read_doubles("bpm/radius", balls.size()) != balls.radius)
    in.refuse("bpm/radius", "the run has other primaries");
  const std::vector<double> scalars = in.read_doubles("bpm/scalars", 8);
  now = scalars[0];
  step_control.scale = scalars[1];
  last_dt = scalars[2];
  contact_loss = scalars[3];
  largest_momentum = scalars[4];
  impulse = dealii::Tensor<1, 3>({scalars[5], scalars[6], scalars[7]});
  const std::vector<std::uint64_t> counts = in.read_integers("bpm/step", 2);
  steps = counts[0];
  fallbacks = counts[1];
  load_work.load(in, "bpm/loads");
  load_walls(in, "bpm/walls", moving_walls);
  volume_at_start = in.read_doubles("bpm/volume_at_start", scene.bodies.size());
  // The same places give the same list in the same order, so that every sum is formed as if never stopped.
  take(in, "bpm/neighbours/build_position", balls.position);
  contact::BallList &list = dynamics->neighbours();
  list.build(balls.position);
  list.all_memories() = in.read_doubles("bpm/neighbours/memory", list.n_pairs() * list.n_numbers());
  take(in, "bpm/position", balls.position);
  take(in, "bpm/velocity", balls.velocity);
  take(in, "bpm/angular_velocity", balls.angular_velocity);
  take(in, "bpm/start_position", balls.start);
  const char *const name = "bpm/wall_contacts/indices";
  const std::vector<std::uint64_t> indices = in.read_integers(name, ListSize::rows_of(2));
  const std::vector<double> impulses = in.read_doubles("bpm/wall_contacts/memory", 2 * indices.size());
  std::vector<BallDynamics::WallMemory> &memory = dynamics->wall_memory();
  memory.clear();
  for (std::size_t k = 0; k < indices.size() / 2; ++k)
  {
    if (indices[2 * k] >= moving_walls.size() || indices[2 * k + 1] >= balls.size())
      in.refuse(name, "there is no such wall or primary");
    memory.push_back(
        {static_cast<std::uint32_t>(indices[2 * k]), static_cast<std::uint32_t>(indices[2 * k + 1]), {}});
    std::copy_n(&impulses[4 * k], 4, memory.back().impulse.begin());
  }
  dynamics->detect(moving_walls);
  volume_now = in.read_doubles("bpm/solid_volume", 1)[0];
  volume_of_list = dynamics->present().lists_made();
}
} // namespace softgrain::bpm
