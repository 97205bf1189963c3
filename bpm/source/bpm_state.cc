// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/bpm_model.h>
#include <softgrain/bpm/strips_in_files.h>
#include <softgrain/model/state_file.h>

#include <cstring>

namespace softgrain::bpm
{
namespace
{
const char *const memory_name = "bpm/neighbours/memory";

const double *numbers_of(const std::vector<double> &values)
{
  return values.data();
}
const double *numbers_of(const std::vector<std::array<double, 2>> &values)
{
  return values.data()->data();
}

template <std::size_t n>
std::vector<double> flat(const std::vector<std::array<double, n>> &values)
{
  std::vector<double> numbers;
  numbers.reserve(n * values.size());
  for (const auto &value : values)
    numbers.insert(numbers.end(), value.begin(), value.end());
  return numbers;
}

} // namespace

template <class T>
void BpmModel::write(StateWriter &out, const std::string &name, const std::vector<T> &values) const
{
  constexpr std::size_t width = sizeof(T) / sizeof(double);
  const StripShare *const share = dynamics->strips();
  const auto fill = [&](const std::size_t begin, const std::size_t end, double *const rows)
  {
    if (share == nullptr)
      std::memcpy(rows, values.data() + begin, (end - begin) * sizeof(T));
    else
      bring_rows(*share, numbers_of(values), width, dynamics->disks(), begin, end, rows);
  };
  out.write_rows(name, share == nullptr ? values.size() : share->n_all(), width, fill);
}

void BpmModel::save(StateWriter &out) const
{
  const Primaries &disks = dynamics->disks();
  out.write("bpm/scalars", std::vector<double>{now, step_control.scale, last_dt});
  out.write("bpm/step", std::vector<std::uint64_t>{steps, fallbacks});
  balance.save(out, "bpm/balance");
  write(out, "bpm/position", disks.position);
  write(out, "bpm/velocity", disks.velocity);
  write(out, "bpm/radius", disks.radius);
  if (is_graded)
    write(out, "bpm/strength", disks.strength);
  out.write("bpm/first_of_body", std::vector<std::uint64_t>(first_of_body.begin(), first_of_body.end()));
  if (rotates)
    write(out, "bpm/angular_velocity", disks.angular_velocity);
  else
    out.write("bpm/angular_velocity", std::vector<double>());
  if (is_loaded)
    write(out, "bpm/start_position", disks.start);
  else
    out.write("bpm/start_position", std::vector<double>());
  out.write("bpm/area_at_start", area_at_start);
  // The area was measured after the list was made: it is the same after a restart only if it is kept. One
  // that nobody has asked for since is not measured for a checkpoint.
  const bool measured = area_of_list == dynamics->present().lists_made();
  out.write("bpm/solid_area", std::vector<double>{measured ? area_now : -1.});
  save_walls(out, "bpm/walls", moving_walls);
  save_obstacles(out, "bpm/obstacles", moving_obstacles);

  const contact::NeighbourList &list = dynamics->present().neighbours();
  write(out, "bpm/neighbours/build_position", list.origin().positions);
  save_memory(*dynamics, out, memory_name);
  const contact::ImageLattice &built = list.origin().lattice;
  if (built.repeats())
    out.write("bpm/neighbours/build_cell",
              std::vector<double>{built.lower[0], built.lower[1], built.length[0], built.length[1],
                                  built.offset, 1. * built.periodic[0], 1. * built.periodic[1]});
  std::vector<std::uint64_t> indices;
  std::vector<std::array<double, 3>> impulses;
  for (const WallMemory &memory : dynamics->memories().at_walls)
  {
    indices.insert(indices.end(), {memory.wall, memory.primary});
    impulses.push_back(memory.impulse);
  }
  out.write("bpm/wall_contacts/indices", indices);
  out.write("bpm/wall_contacts/memory", flat(impulses));
  dynamics->memories().adhesion.save(out, "bpm/adhesion");
}

template <class T>
void BpmModel::read(const StateReader &in, const std::string &name, std::vector<T> &here) const
{
  constexpr std::size_t width = sizeof(T) / sizeof(double);
  in.read_rows(name, n_all(*dynamics), width,
               [&](const std::size_t begin, const std::size_t end, const double *const rows)
               {
                 for_numbers(*dynamics, begin, end,
                             [&](const std::size_t i, const std::size_t number)
                             { std::memcpy(&here[i], rows + (number - begin) * width, sizeof(T)); });
               });
}

void BpmModel::read_wall_contacts(const StateReader &in)
{
  const char *const name = "bpm/wall_contacts/indices";
  std::size_t n_surfaces = moving_walls.size();
  for (const Obstacle<2> &obstacle : moving_obstacles)
    n_surfaces += obstacle.description.pieces.size();
  const std::vector<std::uint64_t> indices = in.read_integers(name, ListSize::rows_of(2));
  const std::size_t n = indices.size() / 2;
  const std::vector<double> impulses = in.read_doubles("bpm/wall_contacts/memory", 3 * n);
  std::vector<WallMemory> &memory = dynamics->memories().at_walls;
  memory.clear();
  for (std::size_t k = 0; k < n; ++k)
  {
    const std::uint64_t surface = indices[2 * k], primary = indices[2 * k + 1];
    if (surface >= n_surfaces || primary >= n_all(*dynamics))
      in.refuse(name,
                "there is no wall " + std::to_string(surface) + " with a primary " + std::to_string(primary));
    memory.push_back({static_cast<std::uint32_t>(surface),
                      static_cast<std::uint32_t>(primary),
                      {impulses[3 * k], impulses[3 * k + 1], impulses[3 * k + 2]}});
  }
}

void BpmModel::load(StateReader &in)
{
  Primaries &disks = dynamics->disks();
  std::vector<double> radius(disks.size());
  read(in, "bpm/radius", radius);
  if (exchange.any(radius != disks.radius))
    in.refuse("bpm/radius", "the run has other primaries");
  load_walls(in, "bpm/walls", moving_walls);
  const std::vector<double> scalars = in.read_doubles("bpm/scalars", 3);
  now = scalars[0];
  load_obstacles(in, "bpm/obstacles", now, moving_obstacles);
  step_control.scale = scalars[1];
  last_dt = scalars[2];
  const std::vector<std::uint64_t> counts = in.read_integers("bpm/step", 2);
  steps = counts[0];
  fallbacks = counts[1];
  balance.load(in, "bpm/balance");
  area_at_start = in.read_doubles("bpm/area_at_start", scene.bodies.size());
  // The same places give the same list in the same order, so that every sum is formed as if never stopped.
  contact::ImageLattice built;
  if (in.contains("bpm/neighbours/build_cell"))
  {
    const std::vector<double> v = in.read_doubles("bpm/neighbours/build_cell", 7);
    built = {{{v[5] > 0., v[6] > 0.}}, {{v[0], v[1]}}, {{v[2], v[3]}}, v[4]};
  }
  read(in, "bpm/neighbours/build_position", disks.position);
  dynamics->build_list(built, in, memory_name);
  read(in, "bpm/position", disks.position);
  read(in, "bpm/velocity", disks.velocity);
  if (rotates)
    read(in, "bpm/angular_velocity", disks.angular_velocity);
  else
    in.read_doubles("bpm/angular_velocity", 0);
  if (is_loaded)
    read(in, "bpm/start_position", disks.start);
  else
    in.read_doubles("bpm/start_position", 0);
  read_wall_contacts(in);
  dynamics->memories().adhesion.load(in, "bpm/adhesion");
  dynamics->detect(moving_walls);
  area_now = in.read_doubles("bpm/solid_area", 1)[0];
  area_of_list = dynamics->present().lists_made();
}
} // namespace softgrain::bpm
