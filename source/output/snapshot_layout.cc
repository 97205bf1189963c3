// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/output/hdf5_reader.h>
#include <softgrain/output/hdf5_writer.h>
#include <softgrain/output/snapshot_arrays.h>
#include <softgrain/output/snapshot_layout.h>
#include <softgrain/output/snapshot_outlines.h>
#include <softgrain/output/snapshot_rows.h>
#include <softgrain/output/units.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace softgrain
{
using namespace snapshot_arrays;
using namespace snapshot_rows;

namespace
{
const std::string file_format = "softgrain snapshot 1", dimension_name = "dimension";

/// Names of arrays that files of 0.2.0 have otherwise, where history.csv and fields.pvd had these already.
const std::vector<std::pair<std::string, std::string>> old_names = {
    {"points/area_m2", "points/size_m2"},
    {"energies/kinetic_energy_J_per_m", "energies/kinetic_J_per_m"},
    {"energies/elastic_energy_J_per_m", "energies/elastic_J_per_m"},
    {"energies/dissipated_energy_J_per_m", "energies/dissipated_J_per_m"}};

/// The name of an array as a file has it.
std::string name_in(const Hdf5Reader &file, const std::string &group, const std::string &name)
{
  if (!file.contains(group + name))
    for (const auto &[now, before] : old_names)
      if (now == name && file.contains(group + before))
        return group + before;
  return group + name;
}

/// What only a cell that repeats needs to be told of walls and contacts.
template <typename Action>
void for_each_cell_array(const Action &action)
{
  action(
      "walls/offset_m", [](auto &wall) -> auto & { return wall.offset; });
  action(
      "walls/slide_velocity_m_per_s", [](auto &wall) -> auto & { return wall.slide_velocity; });
}

bool slides(const std::vector<WallState<2>> &walls)
{
  return std::any_of(walls.begin(), walls.end(),
                     [](const WallState<2> &wall) { return wall.repeats || wall.slide_velocity != 0.; });
}

void write_cell(const Hdf5Group &file, const Snapshot<2> &snapshot)
{
  if (!slides(snapshot.walls))
    return;
  write_indices(file, "walls/repeats", snapshot.walls, [](const auto &wall) { return wall.repeats; });
  for_each_cell_array([&](const std::string &name, const auto &member)
                      { write_rows(file, name, snapshot.walls, member); });
  write_rows(file, "contacts/image_m", snapshot.contacts, [](const auto &contact) { return contact.image; });
}

void read_cell(const Hdf5Reader &file, const std::string &group, Snapshot<2> &snapshot)
{
  if (!file.contains(group + "walls/repeats"))
    return;
  const std::vector<std::uint64_t> repeats = file.read_integers(group + "walls/repeats");
  for (std::size_t w = 0; w < repeats.size() && w < snapshot.walls.size(); ++w)
    snapshot.walls[w].repeats = repeats[w] != 0;
  for_each_cell_array([&](const std::string &name, const auto &member)
                      { read_rows(file, group + name, snapshot.walls, member); });
  read_rows(
      file, group + "contacts/image_m", snapshot.contacts,
      [](auto &contact) -> auto & { return contact.image; });
}

/// What the width of a contact of round bodies is made of.
template <typename Action>
void for_each_width_array(const Action &action)
{
  action(
      "bodies/curvature_per_m", [](auto &body) -> auto & { return body.curvature; });
  action(
      "bodies/compliance_per_Pa", [](auto &body) -> auto & { return body.compliance; });
}

void write_widths(const Hdf5Group &file, const std::vector<BodyState<2>> &bodies)
{
  if (std::any_of(bodies.begin(), bodies.end(), [](const auto &body) { return body.curvature > 0.; }))
    for_each_width_array([&](const std::string &name, const auto &member)
                         { write_rows(file, name, bodies, member); });
}

void read_widths(const Hdf5Reader &file, const std::string &group, std::vector<BodyState<2>> &bodies)
{
  if (file.contains(group + "bodies/curvature_per_m"))
    for_each_width_array([&](const std::string &name, const auto &member)
                         { read_rows(file, group + name, bodies, member); });
}

template <int dim, typename Action>
void for_each_obstacle_array(const Action &action)
{
  const bool plane = dim == 2;
  action(
      "obstacles/pivot_m", [](auto &obstacle) -> auto & { return obstacle.pivot; });
  action(
      "obstacles/angle_rad", [](auto &obstacle) -> auto & { return obstacle.angle; });
  action(
      plane ? "obstacles/force_N_per_m" : "obstacles/force_N",
      [](auto &obstacle) -> auto & { return obstacle.force; });
  action(
      plane ? "obstacles/torque_N" : "obstacles/torque_N_m",
      [](auto &obstacle) -> auto & { return obstacle.torque; });
}

template <int dim>
void write_points(const Hdf5Group &file, const PointStates<dim> &points)
{
  for_each_point_array<dim>(points, [&](const std::string &name, const auto &values)
                            { write_rows(file, name, values); });
  write_indices(file, "points/body", points.body, [](const unsigned int body) { return body; });
  std::vector<std::string> names;
  for (const NamedField &field : points.extra)
  {
    names.push_back(field.name);
    file.write("points/extra/" + field.name, field.values);
  }
  file.write("points/extra_names", names);
}

template <int dim>
void read_points(const Hdf5Reader &file, const std::string &group, PointStates<dim> &points)
{
  if (!file.contains(group + "points"))
    return;
  for_each_point_array<dim>(points, [&](const std::string &name, auto &values)
                            { read_rows(file, name_in(file, group, name), values); });
  read_indices(
      file, group + "points/body", points.body, [](unsigned int &body) -> auto & { return body; });
  for (const std::string &name : file.read_texts(group + "points/extra_names"))
    points.extra.push_back({name, file.read_doubles(group + "points/extra/" + name)});
}

template <typename Item>
std::vector<std::string> names_of(const std::vector<Item> &items)
{
  std::vector<std::string> names;
  for (const Item &item : items)
    names.push_back(item.name);
  return names;
}

template <int dim>
void write_obstacles(const Hdf5Group &file, const std::vector<ObstacleState<dim>> &obstacles)
{
  if (obstacles.empty())
    return;
  file.write("obstacles/name", names_of(obstacles));
  for_each_obstacle_array<dim>([&](const std::string &name, const auto &member)
                               { write_rows(file, name, obstacles, member); });
  write_lines(file, obstacles);
}

/// @param items in the order of the names
template <typename Item>
void read_names(const Hdf5Reader &file, const std::string &name, std::vector<Item> &items)
{
  const std::vector<std::string> names = file.read_texts(name);
  for (std::size_t i = 0; i < names.size() && i < items.size(); ++i)
    items[i].name = names[i];
}

template <int dim>
void read_obstacles(const Hdf5Reader &file,
                    const std::string &group,
                    std::vector<ObstacleState<dim>> &obstacles)
{
  if (!file.contains(group + "obstacles"))
    return;
  for_each_obstacle_array<dim>([&](const std::string &name, const auto &member)
                               { read_rows(file, group + name, obstacles, member); });
  read_names(file, group + "obstacles/name", obstacles);
  read_lines(file, group, obstacles);
}
} // namespace

template <int dim>
void write_snapshot(Hdf5Writer &whole_file,
                    const Snapshot<dim> &snapshot,
                    const bool points,
                    const std::string &group)
{
  const Hdf5Group file{whole_file, group};
  if (points)
    write_points(file, snapshot.points);
  file.write("bodies/name", names_of(snapshot.bodies));
  for_each_body_array<dim>([&](const std::string &name, const auto &member)
                           { write_rows(file, name, snapshot.bodies, member); });
  if constexpr (dim == 2)
    write_widths(file, snapshot.bodies);
  write_outlines(file, snapshot.bodies);
  for_each_contact_array<dim>([&](const std::string &name, const auto &member)
                              { write_rows(file, name, snapshot.contacts, member); });
  for_each_contact_index([&](const std::string &name, const auto &member)
                         { write_indices(file, name, snapshot.contacts, member); });
  file.write("walls/name", names_of(snapshot.walls));
  for_each_wall_array<dim>([&](const std::string &name, const auto &member)
                           { write_rows(file, name, snapshot.walls, member); });
  if constexpr (dim == 2)
    write_cell(file, snapshot);
  write_obstacles(file, snapshot.obstacles);
  for_each_energy<dim>([&](const std::string &name, const auto &member)
                       { file.write(name, std::vector<double>{member(snapshot.energies)}); });
  const std::string object = group.empty() ? "/" : group;
  whole_file.write_attribute(object, "format", file_format);
  if (dim == 3)
    whole_file.write_attribute(object, dimension_name, std::uint64_t(dim));
  whole_file.write_attribute(object, "time_s", snapshot.time);
  whole_file.write_attribute(object, "step", snapshot.step);
  if (group.empty())
    write_units(whole_file);
}

unsigned int dimension_of_snapshot(const Hdf5Reader &file, const std::string &group)
{
  return file.has_attribute(group, dimension_name) ? file.read_integer_attribute(group, dimension_name) : 2;
}

template <int dim>
Snapshot<dim> read_snapshot_group(const Hdf5Reader &file, const std::string &group)
{
  if (const unsigned int dimension = dimension_of_snapshot(file, group); dimension != dim)
    throw InputError("cannot read '" + group + "' from " + file.name() + ": it is a snapshot in " +
                     std::to_string(dimension) + " dimensions, not in " + std::to_string(dim));
  Snapshot<dim> snapshot;
  snapshot.time = file.read_double_attribute(group, "time_s");
  snapshot.step = file.read_integer_attribute(group, "step");
  read_points(file, group, snapshot.points);
  const auto read_into = [&](auto &items)
  {
    return [&](const std::string &name, const auto &member) { read_rows(file, group + name, items, member); };
  };
  for_each_body_array<dim>(read_into(snapshot.bodies));
  if constexpr (dim == 2)
    read_widths(file, group, snapshot.bodies);
  read_outlines(file, group, snapshot.bodies);
  for_each_contact_array<dim>(read_into(snapshot.contacts));
  for_each_contact_index([&](const std::string &name, const auto &member)
                         { read_indices(file, group + name, snapshot.contacts, member); });
  for_each_wall_array<dim>(read_into(snapshot.walls));
  read_names(file, group + "bodies/name", snapshot.bodies);
  read_names(file, group + "walls/name", snapshot.walls);
  if constexpr (dim == 2)
    read_cell(file, group, snapshot);
  read_obstacles(file, group, snapshot.obstacles);
  for_each_energy<dim>(
      [&](const std::string &name, const auto &member)
      {
        const std::vector<double> values = file.read_doubles(name_in(file, group, name));
        member(snapshot.energies) = values.empty() ? 0. : values[0];
      });
  return snapshot;
}

template void write_snapshot<2>(Hdf5Writer &, const Snapshot<2> &, bool, const std::string &);
template void write_snapshot<3>(Hdf5Writer &, const Snapshot<3> &, bool, const std::string &);
template Snapshot<2> read_snapshot_group<2>(const Hdf5Reader &, const std::string &);
template Snapshot<3> read_snapshot_group<3>(const Hdf5Reader &, const std::string &);
} // namespace softgrain
