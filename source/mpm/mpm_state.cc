// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/body_builder.h>
#include <softgrain/mpm/mpm_model.h>
#include <softgrain/scene/state_file.h>

#include <algorithm>
#include <cstring>

namespace softgrain::mpm
{
namespace
{
/// Vectors of tensors, points and symmetric tensors as plain numbers; they hold nothing else.
template <typename T>
std::vector<double> flat(const std::vector<T> &values)
{
  static_assert(sizeof(T) % sizeof(double) == 0 && std::is_trivially_destructible<T>::value,
                "not a pack of doubles");
  std::vector<double> numbers(values.size() * sizeof(T) / sizeof(double));
  if (!numbers.empty())
    std::memcpy(numbers.data(), values.data(), numbers.size() * sizeof(double));
  return numbers;
}

template <typename T>
void unflat(const std::vector<double> &numbers, std::vector<T> &values)
{
  values.resize(numbers.size() * sizeof(double) / sizeof(T));
  if (!numbers.empty())
    std::memcpy(static_cast<void *>(values.data()), numbers.data(), numbers.size() * sizeof(double));
}

std::vector<double> flat(const Eigen::VectorXd &v)
{
  return {v.data(), v.data() + v.size()};
}

Eigen::VectorXd vector_of(const std::vector<double> &numbers)
{
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), numbers.size());
}
} // namespace

void MpmModel::save(StateWriter &out) const
{
  const Balance &b = world.balance;
  out.write("mpm/scalars", std::vector<double>{world.time, step_scale, last_dt});
  out.write("mpm/step", std::vector<std::uint64_t>{steps});
  out.write("mpm/balance",
            std::vector<double>{b.initial_momentum[0], b.initial_momentum[1], b.body_force_impulse[0],
                                b.body_force_impulse[1], b.wall_impulse[0], b.wall_impulse[1],
                                b.largest_momentum, b.wall_work, b.body_force_work, b.contact_loss,
                                b.law_loss, b.carried_load[0], b.carried_load[1]});
  std::vector<double> walls;
  for (const Wall &wall : world.walls)
    walls.insert(walls.end(), {wall.travel, wall.speed, wall.force[0], wall.force[1], wall.impulse[0],
                               wall.impulse[1], wall.carried[0], wall.carried[1]});
  out.write("mpm/walls", walls);

  // Sorted by key, so that equal states give equal files.
  std::vector<std::pair<std::uint64_t, std::array<double, 2>>> memory(world.contact.memory().begin(),
                                                                      world.contact.memory().end());
  std::sort(memory.begin(), memory.end());
  std::vector<std::uint64_t> keys;
  std::vector<double> impulses;
  for (const auto &[key, impulse] : memory)
  {
    keys.push_back(key);
    impulses.insert(impulses.end(), impulse.begin(), impulse.end());
  }
  out.write("mpm/contact/keys", keys);
  out.write("mpm/contact/impulses", impulses);

  for (const Body<2> &body : world.bodies)
  {
    const std::string at = "mpm/bodies/" + body.name + "/";
    const PointData<2> &points = body.points;
    out.write(at + "id", std::vector<std::uint64_t>(points.id.begin(), points.id.end()));
    out.write(at + "position", flat(points.position));
    out.write(at + "volume", points.volume);
    out.write(at + "rest_volume", points.rest_volume);
    out.write(at + "mass", points.mass);
    out.write(at + "half_extent", points.half_extent);
    out.write(at + "gradient", flat(points.gradient));
    out.write(at + "velocity", flat(points.velocity));
    out.write(at + "acceleration", flat(points.acceleration));
    out.write(at + "affine", flat(points.affine));
    out.write(at + "history", points.history);
    out.write(at + "stress", flat(points.stress));
    out.write(at + "out_of_plane_stress", points.out_of_plane_stress);
    out.write(at + "boundary_grid_position", flat(body.boundary.grid_position));
    out.write(at + "boundary_position", flat(body.boundary.position));
    out.write(at + "nodes/displacement", flat(body.displacement));
    out.write(at + "nodes/velocity", flat(body.velocity));
    out.write(at + "nodes/velocity_of_points", flat(body.velocity_of_points));
    out.write(at + "nodes/acceleration", flat(body.acceleration));
    out.write(at + "nodes/internal_force", flat(body.internal_force));
    out.write(at + "elastic_energy", std::vector<double>{body.elastic_energy});
  }
}

void MpmModel::load(StateReader &in)
{
  const std::vector<double> scalars = in.read_doubles("mpm/scalars"), walls = in.read_doubles("mpm/walls");
  if (walls.size() != 8 * world.walls.size())
    throw InputError("the checkpoint was made with another number of walls");
  world.time = scalars.at(0);
  step_scale = scalars.at(1);
  last_dt = scalars.at(2);
  steps = in.read_integers("mpm/step").at(0);
  const std::vector<double> b = in.read_doubles("mpm/balance");
  world.balance = {dealii::Tensor<1, 2>({b.at(0), b.at(1)}),
                   dealii::Tensor<1, 2>({b.at(2), b.at(3)}),
                   dealii::Tensor<1, 2>({b.at(4), b.at(5)}),
                   b.at(6),
                   b.at(7),
                   b.at(8),
                   b.at(9),
                   b.at(10),
                   dealii::Tensor<1, 2>({b.at(11), b.at(12)})};
  for (unsigned int w = 0; w < world.walls.size(); ++w)
  {
    const double *v = &walls[8 * w];
    world.walls[w].travel = v[0];
    world.walls[w].speed = v[1];
    world.walls[w].force = dealii::Tensor<1, 2>({v[2], v[3]});
    world.walls[w].impulse = dealii::Tensor<1, 2>({v[4], v[5]});
    world.walls[w].carried = dealii::Tensor<1, 2>({v[6], v[7]});
  }
  const std::vector<std::uint64_t> keys = in.read_integers("mpm/contact/keys");
  const std::vector<double> impulses = in.read_doubles("mpm/contact/impulses");
  for (std::size_t k = 0; k < keys.size(); ++k)
    world.contact.memory()[keys[k]] = {{impulses.at(2 * k), impulses.at(2 * k + 1)}};

  const BuildContext context{*world.lattice, *world.shape, world.settings};
  for (Body<2> &body : world.bodies)
  {
    const std::string at = "mpm/bodies/" + body.name + "/";
    PointData<2> &points = body.points;
    const auto ids = in.read_integers(at + "id");
    if (ids.size() != points.size())
      throw InputError("the checkpoint was made with another number of points in body '" + body.name + "'");
    points.id.assign(ids.begin(), ids.end());
    unflat(in.read_doubles(at + "position"), points.position);
    points.volume = in.read_doubles(at + "volume");
    points.rest_volume = in.read_doubles(at + "rest_volume");
    points.mass = in.read_doubles(at + "mass");
    points.half_extent = in.read_doubles(at + "half_extent");
    unflat(in.read_doubles(at + "gradient"), points.gradient);
    unflat(in.read_doubles(at + "velocity"), points.velocity);
    unflat(in.read_doubles(at + "acceleration"), points.acceleration);
    unflat(in.read_doubles(at + "affine"), points.affine);
    points.history = in.read_doubles(at + "history");
    unflat(in.read_doubles(at + "stress"), points.stress);
    points.out_of_plane_stress = in.read_doubles(at + "out_of_plane_stress");
    unflat(in.read_doubles(at + "boundary_grid_position"), body.boundary.grid_position);
    lay_grid(body, context);
    unflat(in.read_doubles(at + "boundary_position"), body.boundary.position);
    body.displacement = vector_of(in.read_doubles(at + "nodes/displacement"));
    body.velocity = vector_of(in.read_doubles(at + "nodes/velocity"));
    body.velocity_of_points = vector_of(in.read_doubles(at + "nodes/velocity_of_points"));
    body.acceleration = vector_of(in.read_doubles(at + "nodes/acceleration"));
    body.internal_force = vector_of(in.read_doubles(at + "nodes/internal_force"));
    body.elastic_energy = in.read_doubles(at + "elastic_energy").at(0);
    if (world.settings.scheme.implicit && !body.driven)
      world.matrices[body.index].reinit(body.field);
  }
}
} // namespace softgrain::mpm
