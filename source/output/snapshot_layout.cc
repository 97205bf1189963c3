// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/output/hdf5_file.h>
#include <softgrain/output/snapshot_layout.h>
#include <softgrain/output/snapshot_rows.h>
#include <softgrain/output/units.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace softgrain
{
using namespace snapshot_rows;

namespace
{
const std::string file_format = "softgrain snapshot 1";

/// Names of arrays that files of 0.2.0 have otherwise, where history.csv and fields.pvd had these already.
const std::vector<std::pair<std::string, std::string>> old_names = {
    {"points/area_m2", "points/size_m2"},
    {"energies/kinetic_energy_J_per_m", "energies/kinetic_J_per_m"},
    {"energies/elastic_energy_J_per_m", "energies/elastic_J_per_m"},
    {"energies/dissipated_energy_J_per_m", "energies/dissipated_J_per_m"}};

/// The name of an array as a file has it.
std::string name_in(const Hdf5File &file, const std::string &group, const std::string &name)
{
  if (!file.contains(group + name))
    for (const auto &[now, before] : old_names)
      if (now == name && file.contains(group + before))
        return group + before;
  return group + name;
}

/// Pairs of array name and member: one list serves writing and reading, so that they cannot differ.
template <typename Action>
void for_each_body_array(const Action &action)
{
  action(
      "bodies/area_m2", [](auto &body) -> auto & { return body.area; });
  action(
      "bodies/reference_area_m2", [](auto &body) -> auto & { return body.reference_area; });
  action(
      "bodies/mass_kg_per_m", [](auto &body) -> auto & { return body.mass; });
  action(
      "bodies/center_m", [](auto &body) -> auto & { return body.center; });
  action(
      "bodies/velocity_m_per_s", [](auto &body) -> auto & { return body.velocity; });
  action(
      "bodies/angular_momentum_kg_m_per_s", [](auto &body) -> auto & { return body.angular_momentum; });
  action(
      "bodies/mean_stress_Pa", [](auto &body) -> auto & { return body.mean_stress; });
}

template <typename Action>
void for_each_contact_array(const Action &action)
{
  action(
      "contacts/place_m", [](auto &contact) -> auto & { return contact.place; });
  action(
      "contacts/normal", [](auto &contact) -> auto & { return contact.normal; });
  action(
      "contacts/force_N_per_m", [](auto &contact) -> auto & { return contact.force; });
  action(
      "contacts/length_m", [](auto &contact) -> auto & { return contact.length; });
  action(
      "contacts/gap_m", [](auto &contact) -> auto & { return contact.gap; });
}

template <typename Action>
void for_each_contact_index(const Action &action)
{
  action(
      "contacts/body_a", [](auto &contact) -> auto & { return contact.body_a; });
  action(
      "contacts/body_b", [](auto &contact) -> auto & { return contact.body_b; });
  action(
      "contacts/wall", [](auto &contact) -> auto & { return contact.wall; });
}

template <typename Action>
void for_each_wall_array(const Action &action)
{
  action(
      "walls/point_m", [](auto &wall) -> auto & { return wall.point; });
  action(
      "walls/normal", [](auto &wall) -> auto & { return wall.normal; });
  action(
      "walls/position_m", [](auto &wall) -> auto & { return wall.position; });
  action(
      "walls/velocity_m_per_s", [](auto &wall) -> auto & { return wall.velocity; });
  action(
      "walls/normal_force_N_per_m", [](auto &wall) -> auto & { return wall.normal_force; });
  action(
      "walls/tangential_force_N_per_m", [](auto &wall) -> auto & { return wall.tangential_force; });
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

void read_cell(const Hdf5File &file, const std::string &group, Snapshot<2> &snapshot)
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

void read_widths(const Hdf5File &file, const std::string &group, std::vector<BodyState<2>> &bodies)
{
  if (file.contains(group + "bodies/curvature_per_m"))
    for_each_width_array([&](const std::string &name, const auto &member)
                         { read_rows(file, group + name, bodies, member); });
}

template <typename Action>
void for_each_obstacle_array(const Action &action)
{
  action(
      "obstacles/pivot_m", [](auto &obstacle) -> auto & { return obstacle.pivot; });
  action(
      "obstacles/angle_rad", [](auto &obstacle) -> auto & { return obstacle.angle; });
  action(
      "obstacles/force_N_per_m", [](auto &obstacle) -> auto & { return obstacle.force; });
  action(
      "obstacles/torque_N", [](auto &obstacle) -> auto & { return obstacle.torque; });
}

/// Points, by their member vectors.
template <typename Points, typename Action>
void for_each_point_array(Points &points, const Action &action)
{
  action("points/position_m", points.position);
  action("points/area_m2", points.size);
  action("points/velocity_m_per_s", points.velocity);
  action("points/stress_Pa", points.stress);
  action("points/out_of_plane_stress_Pa", points.out_of_plane_stress);
  action("points/deformation_gradient", points.deformation_gradient);
}

void write_points(const Hdf5Group &file, const PointStates<2> &points)
{
  for_each_point_array(points,
                       [&](const std::string &name, const auto &values) { write_rows(file, name, values); });
  write_indices(file, "points/body", points.body, [](const unsigned int body) { return body; });
  std::vector<std::string> names;
  for (const NamedField &field : points.extra)
  {
    names.push_back(field.name);
    file.write("points/extra/" + field.name, field.values);
  }
  file.write("points/extra_names", names);
}

void read_points(const Hdf5File &file, const std::string &group, PointStates<2> &points)
{
  if (!file.contains(group + "points"))
    return;
  for_each_point_array(points, [&](const std::string &name, auto &values)
                       { read_rows(file, name_in(file, group, name), values); });
  read_indices(
      file, group + "points/body", points.body, [](unsigned int &body) -> auto & { return body; });
  for (const std::string &name : file.read_texts(group + "points/extra_names"))
    points.extra.push_back({name, file.read_doubles(group + "points/extra/" + name)});
}

void write_outlines(const Hdf5Group &file, const std::vector<BodyState<2>> &bodies)
{
  std::vector<std::uint64_t> ring_offsets{0}, point_offsets{0};
  std::vector<double> rows;
  for (const BodyState<2> &body : bodies)
  {
    for (const std::vector<dealii::Point<2>> &ring : body.outline)
    {
      for (const dealii::Point<2> &point : ring)
        put(rows, point);
      point_offsets.push_back(rows.size() / 2);
    }
    ring_offsets.push_back(point_offsets.size() - 1);
  }
  file.write("outlines/body_offsets", ring_offsets);
  file.write("outlines/ring_offsets", point_offsets);
  file.write("outlines/points_m", rows, 2);
}

void read_outlines(const Hdf5File &file, const std::string &group, std::vector<BodyState<2>> &bodies)
{
  const std::vector<std::uint64_t> rings = file.read_integers(group + "outlines/body_offsets");
  const std::vector<std::uint64_t> offsets = file.read_integers(group + "outlines/ring_offsets");
  std::vector<dealii::Point<2>> points;
  read_rows(file, group + "outlines/points_m", points);
  const auto rising = [](const std::vector<std::uint64_t> &list, const std::size_t end)
  {
    return !list.empty() && list.front() == 0 && list.back() == end &&
           std::is_sorted(list.begin(), list.end());
  };
  if (rings.size() != bodies.size() + 1 || !rising(offsets, points.size()) ||
      !rising(rings, offsets.size() - 1))
    throw InputError("cannot read '" + group + "outlines' from " + file.name() + ": the offsets do not fit");
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t r = rings[b]; r < rings[b + 1]; ++r)
      bodies[b].outline.emplace_back(points.begin() + static_cast<std::ptrdiff_t>(offsets[r]),
                                     points.begin() + static_cast<std::ptrdiff_t>(offsets[r + 1]));
}

void write_lines(const Hdf5Group &file, const std::vector<ObstacleState<2>> &obstacles)
{
  std::vector<std::uint64_t> offsets{0};
  std::vector<double> rows;
  for (const ObstacleState<2> &obstacle : obstacles)
  {
    for (const dealii::Point<2> &point : obstacle.line)
      put(rows, point);
    offsets.push_back(rows.size() / 2);
  }
  file.write("obstacles/line_offsets", offsets);
  file.write("obstacles/points_m", rows, 2);
}

void read_lines(const Hdf5File &file, const std::string &group, std::vector<ObstacleState<2>> &obstacles)
{
  const std::vector<std::uint64_t> offsets = file.read_integers(group + "obstacles/line_offsets");
  std::vector<dealii::Point<2>> points;
  read_rows(file, group + "obstacles/points_m", points);
  if (offsets.size() != obstacles.size() + 1 || offsets.back() != points.size() ||
      !std::is_sorted(offsets.begin(), offsets.end()))
    throw InputError("cannot read '" + group + "obstacles' from " + file.name() + ": the offsets do not fit");
  for (std::size_t o = 0; o < obstacles.size(); ++o)
    obstacles[o].line.assign(points.begin() + static_cast<std::ptrdiff_t>(offsets[o]),
                             points.begin() + static_cast<std::ptrdiff_t>(offsets[o + 1]));
}

template <typename Item>
std::vector<std::string> names_of(const std::vector<Item> &items)
{
  std::vector<std::string> names;
  for (const Item &item : items)
    names.push_back(item.name);
  return names;
}
} // namespace

void write_snapshot(Hdf5File &whole_file,
                    const Snapshot<2> &snapshot,
                    const bool points,
                    const std::string &group)
{
  const Hdf5Group file{whole_file, group};
  if (points)
    write_points(file, snapshot.points);
  file.write("bodies/name", names_of(snapshot.bodies));
  for_each_body_array([&](const std::string &name, const auto &member)
                      { write_rows(file, name, snapshot.bodies, member); });
  write_widths(file, snapshot.bodies);
  write_outlines(file, snapshot.bodies);
  for_each_contact_array([&](const std::string &name, const auto &member)
                         { write_rows(file, name, snapshot.contacts, member); });
  for_each_contact_index([&](const std::string &name, const auto &member)
                         { write_indices(file, name, snapshot.contacts, member); });
  file.write("walls/name", names_of(snapshot.walls));
  for_each_wall_array([&](const std::string &name, const auto &member)
                      { write_rows(file, name, snapshot.walls, member); });
  write_cell(file, snapshot);
  if (!snapshot.obstacles.empty())
  {
    file.write("obstacles/name", names_of(snapshot.obstacles));
    for_each_obstacle_array([&](const std::string &name, const auto &member)
                            { write_rows(file, name, snapshot.obstacles, member); });
    write_lines(file, snapshot.obstacles);
  }
  const Energies &energies = snapshot.energies;
  file.write("energies/kinetic_energy_J_per_m", std::vector<double>{energies.kinetic});
  file.write("energies/elastic_energy_J_per_m", std::vector<double>{energies.elastic});
  file.write("energies/dissipated_energy_J_per_m", std::vector<double>{energies.dissipated});
  file.write("energies/external_work_J_per_m", std::vector<double>{energies.external_work});
  const std::string object = group.empty() ? "/" : group;
  whole_file.write_attribute(object, "format", file_format);
  whole_file.write_attribute(object, "time_s", snapshot.time);
  whole_file.write_attribute(object, "step", snapshot.step);
  if (group.empty())
    write_units(whole_file);
}

Snapshot<2> read_snapshot_group(const Hdf5File &file, const std::string &group)
{
  Snapshot<2> snapshot;
  snapshot.time = file.read_double_attribute(group, "time_s");
  snapshot.step = file.read_integer_attribute(group, "step");
  read_points(file, group, snapshot.points);
  const auto read_into = [&](auto &items)
  {
    return [&](const std::string &name, const auto &member) { read_rows(file, group + name, items, member); };
  };
  for_each_body_array(read_into(snapshot.bodies));
  read_widths(file, group, snapshot.bodies);
  read_outlines(file, group, snapshot.bodies);
  for_each_contact_array(read_into(snapshot.contacts));
  for_each_contact_index([&](const std::string &name, const auto &member)
                         { read_indices(file, group + name, snapshot.contacts, member); });
  for_each_wall_array(read_into(snapshot.walls));
  read_cell(file, group, snapshot);
  const auto read_names = [&](const std::string &name, auto &items)
  {
    const std::vector<std::string> names = file.read_texts(group + name);
    for (std::size_t i = 0; i < names.size() && i < items.size(); ++i)
      items[i].name = names[i];
  };
  read_names("bodies/name", snapshot.bodies);
  read_names("walls/name", snapshot.walls);
  if (file.contains(group + "obstacles"))
  {
    for_each_obstacle_array(read_into(snapshot.obstacles));
    read_names("obstacles/name", snapshot.obstacles);
    read_lines(file, group, snapshot.obstacles);
  }
  const auto energy = [&](const std::string &name)
  {
    const std::vector<double> values = file.read_doubles(name_in(file, group, "energies/" + name));
    return values.empty() ? 0. : values[0];
  };
  snapshot.energies = {energy("kinetic_energy_J_per_m"), energy("elastic_energy_J_per_m"),
                       energy("dissipated_energy_J_per_m"), energy("external_work_J_per_m")};
  return snapshot;
}
} // namespace softgrain
