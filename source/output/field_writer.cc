// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/outline_loads.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/field_writer.h>
#include <softgrain/output/series.h>
#include <softgrain/output/space_fields.h>
#include <softgrain/output/vtu_file.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace softgrain
{
namespace
{
using Cell = VtuFile::Cell;

std::int32_t id(const unsigned int index)
{
  return index == ContactState<2>::not_a_body ? -1 : static_cast<std::int32_t>(index);
}

void push(std::vector<float> &values, const dealii::Tensor<1, 2> &vector)
{
  values.insert(values.end(), {static_cast<float>(vector[0]), static_cast<float>(vector[1]), 0.f});
}

void push(std::vector<double> &values, const dealii::Tensor<1, 2> &vector)
{
  values.insert(values.end(), {vector[0], vector[1], 0.});
}

template <typename Item, typename Function>
std::vector<float> floats(const std::vector<Item> &items, const Function &value)
{
  std::vector<float> values;
  values.reserve(items.size());
  for (const Item &item : items)
    values.push_back(static_cast<float>(value(item)));
  return values;
}

template <typename Item, typename Function>
std::vector<double> doubles(const std::vector<Item> &items, const Function &value)
{
  std::vector<double> values;
  values.reserve(items.size());
  for (const Item &item : items)
    values.push_back(value(item));
  return values;
}

template <typename Item, typename Function>
std::vector<float> vectors(const std::vector<Item> &items, const Function &value)
{
  std::vector<float> values;
  values.reserve(3 * items.size());
  for (const Item &item : items)
    push(values, value(item));
  return values;
}

/// A stress as ParaView wants a tensor: nine components, row by row.
template <typename Number>
void push_tensor(std::vector<Number> &values,
                 const dealii::SymmetricTensor<2, 2> &stress,
                 const double out_of_plane)
{
  for (const double component :
       {stress[0][0], stress[0][1], 0., stress[0][1], stress[1][1], 0., 0., 0., out_of_plane})
    values.push_back(static_cast<Number>(component));
}

void add_stress(VtuFile &file, const PointStates<2> &points)
{
  if (points.stress.empty())
    return;
  // Without a stress out of the plane (rigid primaries) the mean is that of the plane.
  const bool plane_strain = !points.out_of_plane_stress.empty();
  std::vector<float> tensors;
  for (std::size_t p = 0; p < points.stress.size(); ++p)
    push_tensor(tensors, points.stress[p], plane_strain ? points.out_of_plane_stress.at(p) : 0.);
  file.add_point_data("stress_Pa", 9, tensors);
  std::vector<float> von_mises, pressure;
  for (std::size_t p = 0; p < points.stress.size(); ++p)
  {
    const double x = points.stress[p][0][0], y = points.stress[p][1][1], xy = points.stress[p][0][1];
    const double z = plane_strain ? points.out_of_plane_stress.at(p) : 0;
    const double squares = (x - y) * (x - y) + (y - z) * (y - z) + (z - x) * (z - x);
    von_mises.push_back(static_cast<float>(std::sqrt(0.5 * squares + 3 * xy * xy)));
    pressure.push_back(static_cast<float>(plane_strain ? -(x + y + z) / 3 : -(x + y) / 2));
  }
  file.add_point_data("von_mises_Pa", 1, von_mises);
  file.add_point_data("pressure_Pa", 1, pressure);
}

void fill_points(VtuFile &file, const PointStates<2> &points, const FieldOptions &options)
{
  file.add_vertices(points.position);
  std::vector<std::int32_t> body;
  for (const unsigned int index : points.body)
    body.push_back(id(index));
  file.add_point_data("body", body);
  file.add_point_data("area_m2", 1, floats(points.size, [](const double size) { return size; }));
  file.add_point_data("velocity_m_per_s", 3, vectors(points.velocity, [](const auto &v) { return v; }));
  add_stress(file, points);
  if (options.deformation_gradient && !points.deformation_gradient.empty())
  {
    std::vector<float> values;
    for (const dealii::Tensor<2, 2> &gradient : points.deformation_gradient)
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          values.push_back(static_cast<float>(gradient[i][j]));
    file.add_point_data("deformation_gradient", 4, values);
  }
  if (options.extra_fields)
    for (const NamedField &field : points.extra)
      file.add_point_data(field.name, 1, floats(field.values, [](const double value) { return value; }));
}

void fill_outlines(VtuFile &file, const Snapshot<2> &snapshot)
{
  const std::vector<BodyState<2>> &bodies = snapshot.bodies;
  const auto loads = loads_on_outlines(snapshot);
  std::vector<float> contact_pressure, contact_traction;
  std::vector<std::int32_t> body, ring;
  std::vector<double> center, velocity, area, mass, pressure;
  std::vector<double> stress;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t r = 0; r < bodies[b].outline.size(); ++r)
    {
      std::vector<dealii::Point<2>> vertices = bodies[b].outline[r];
      if (vertices.size() > 1 && vertices.front() == vertices.back())
        vertices.pop_back();
      if (vertices.size() < 3)
        continue;
      // VTK's polygons have no holes: a ring is drawn by its two outlines, closed lines.
      const bool filled = bodies[b].outline.size() == 1;
      if (!filled)
        vertices.push_back(vertices.front());
      file.add_cell(filled ? Cell::polygon : Cell::poly_line, vertices);
      for (std::size_t v = 0; v < vertices.size(); ++v)
      {
        const OutlineLoad &load = loads[b][r][v % loads[b][r].size()];
        contact_pressure.push_back(static_cast<float>(load.pressure));
        contact_traction.push_back(static_cast<float>(load.traction));
      }
      body.push_back(static_cast<std::int32_t>(b));
      ring.push_back(static_cast<std::int32_t>(r));
      push(center, bodies[b].center);
      push(velocity, bodies[b].velocity);
      area.push_back(bodies[b].area);
      mass.push_back(bodies[b].mass);
      const dealii::SymmetricTensor<2, 2> &mean = bodies[b].mean_stress;
      push_tensor(stress, mean, 0.); // of the plane only
      pressure.push_back(-(mean[0][0] + mean[1][1]) / 2);
    }
  file.add_cell_data("body", body);
  file.add_cell_data("ring", ring);
  file.add_cell_data("center_m", 3, center);
  file.add_cell_data("velocity_m_per_s", 3, velocity);
  file.add_cell_data("area_m2", 1, area);
  file.add_cell_data("mass_kg_per_m", 1, mass);
  file.add_cell_data("mean_stress_Pa", 9, stress);
  file.add_cell_data("mean_pressure_Pa", 1, pressure);
  file.add_point_data("contact_pressure_Pa", 1, contact_pressure);
  file.add_point_data("contact_traction_Pa", 1, contact_traction);
}

bool repeats(const Snapshot<2> &snapshot)
{
  return std::any_of(snapshot.walls.begin(), snapshot.walls.end(),
                     [](const WallState<2> &wall) { return wall.repeats; });
}

void fill_contacts(VtuFile &file, const Snapshot<2> &snapshot)
{
  const std::vector<ContactState<2>> &contacts = snapshot.contacts;
  using Contact = ContactState<2>;
  std::vector<dealii::Point<2>> places;
  std::vector<std::int32_t> body_a, body_b, wall;
  for (const Contact &contact : contacts)
  {
    places.push_back(contact.place);
    body_a.push_back(id(contact.body_a));
    body_b.push_back(id(contact.body_b));
    wall.push_back(id(contact.wall));
  }
  file.add_vertices(places);
  file.add_point_data("body_a", body_a);
  file.add_point_data("body_b", body_b);
  file.add_point_data("wall", wall);
  file.add_point_data("force_N_per_m", 3, vectors(contacts, [](const Contact &c) { return c.force; }));
  file.add_point_data("normal", 3, vectors(contacts, [](const Contact &c) { return c.normal; }));
  file.add_point_data("normal_force_N_per_m", 1,
                      floats(contacts, [](const Contact &c) { return c.force * c.normal; }));
  // Along the normal turned by -90 degrees, as for walls.
  file.add_point_data(
      "tangential_force_N_per_m", 1,
      floats(contacts, [](const Contact &c) { return c.force[0] * c.normal[1] - c.force[1] * c.normal[0]; }));
  file.add_point_data("gap_m", 1, floats(contacts, [](const Contact &c) { return c.gap; }));
  file.add_point_data("length_m", 1, floats(contacts, [](const Contact &c) { return c.length; }));
  if (repeats(snapshot))
    file.add_point_data("image_m", 3, vectors(contacts, [](const Contact &c) { return c.image; }));
}

void fill_walls(VtuFile &file, const Snapshot<2> &snapshot)
{
  using Wall = WallState<2>;
  std::vector<std::int32_t> index;
  std::vector<double> normal, velocity;
  std::vector<Wall> drawn;
  for (unsigned int w = 0; w < snapshot.walls.size(); ++w)
  {
    const std::vector<dealii::Point<2>> segment = wall_segment(snapshot, w);
    if (segment.empty())
      continue;
    file.add_cell(Cell::line, segment);
    index.push_back(static_cast<std::int32_t>(w));
    push(normal, snapshot.walls[w].normal);
    push(velocity, snapshot.walls[w].velocity * snapshot.walls[w].normal);
    drawn.push_back(snapshot.walls[w]);
  }
  file.add_cell_data("wall", index);
  file.add_cell_data("normal", 3, normal);
  file.add_cell_data("position_m", 1, doubles(drawn, [](const Wall &w) { return w.position; }));
  file.add_cell_data("velocity_m_per_s", 3, velocity); // a vector as that of points and bodies
  file.add_cell_data("normal_force_N_per_m", 1, doubles(drawn, [](const Wall &w) { return w.normal_force; }));
  file.add_cell_data("tangential_force_N_per_m", 1,
                     doubles(drawn, [](const Wall &w) { return w.tangential_force; }));
  if (!repeats(snapshot))
    return;
  file.add_cell_data("repeats", 1, doubles(drawn, [](const Wall &w) { return w.repeats ? 1. : 0.; }));
  file.add_cell_data("offset_m", 1, doubles(drawn, [](const Wall &w) { return w.offset; }));
}

void fill_obstacles(VtuFile &file, const std::vector<ObstacleState<2>> &obstacles)
{
  using Obstacle = ObstacleState<2>;
  std::vector<std::int32_t> index;
  std::vector<double> pivot, force;
  for (const Obstacle &obstacle : obstacles)
  {
    index.push_back(static_cast<std::int32_t>(index.size()));
    file.add_cell(Cell::poly_line, obstacle.line);
    push(pivot, obstacle.pivot);
    push(force, obstacle.force);
  }
  file.add_cell_data("obstacle", index);
  file.add_cell_data("pivot_m", 3, pivot);
  file.add_cell_data("angle_rad", 1, doubles(obstacles, [](const Obstacle &o) { return o.angle; }));
  file.add_cell_data("force_N_per_m", 3, force);
  file.add_cell_data("torque_N", 1, doubles(obstacles, [](const Obstacle &o) { return o.torque; }));
}
} // namespace

FieldWriter::FieldWriter(const std::string &directory, const FieldOptions &options)
    : directory(directory), options(options)
{
}

std::string FieldWriter::begin_frame(const double time)
{
  while (!frames.empty() && frames.back().time >= time)
    frames.pop_back();
  if (!stale_files_removed)
  {
    // The index first, so that it never names a file that is gone.
    write_index();
    remove_stale_files();
    stale_files_removed = true;
  }
  return series_number(frames.size());
}

template <class Fill>
void FieldWriter::put(Frame &frame,
                      const std::string &number,
                      const std::string &part,
                      const std::uint64_t step,
                      const Fill &fill)
{
  VtuFile file(options.compression_level);
  file.add_global("TimeValue", frame.time);
  file.add_global("step", static_cast<double>(step));
  fill(file);
  const std::string name = "fields/" + part + "-" + number + ".vtu";
  write_file_atomically(directory + "/" + name, file.text(), late);
  frame.parts.emplace_back(part, name);
}

template <int dim, class Parts>
void FieldWriter::write_frame(const Snapshot<dim> &snapshot, const Parts &parts)
{
  const std::string number = begin_frame(snapshot.time);
  Frame frame;
  frame.time = snapshot.time;
  parts([&](const std::string &part, const auto &fill) { put(frame, number, part, snapshot.step, fill); });
  frames.push_back(frame);
  write_index();
}

void FieldWriter::write(const Snapshot<2> &snapshot)
{
  write_frame(snapshot,
              [&](const auto &put_part)
              {
                if (options.points)
                  put_part("points", [&](VtuFile &file) { fill_points(file, snapshot.points, options); });
                if (options.outlines)
                  put_part("outlines", [&](VtuFile &file) { fill_outlines(file, snapshot); });
                if (options.contacts)
                  put_part("contacts", [&](VtuFile &file) { fill_contacts(file, snapshot); });
                if (options.walls)
                  put_part("walls", [&](VtuFile &file) { fill_walls(file, snapshot); });
                if (options.walls && !snapshot.obstacles.empty())
                  put_part("obstacles", [&](VtuFile &file) { fill_obstacles(file, snapshot.obstacles); });
              });
}

void FieldWriter::write(const Snapshot<3> &snapshot)
{
  write_frame(
      snapshot,
      [&](const auto &put_part)
      {
        if (options.points)
          put_part("points",
                   [&](VtuFile &file) {
                     space_fields::fill_points(file, snapshot.points, options.deformation_gradient,
                                               options.extra_fields);
                   });
        if (options.outlines)
          put_part("outlines", [&](VtuFile &file) { space_fields::fill_surfaces(file, snapshot.bodies); });
        if (options.contacts)
          put_part("contacts", [&](VtuFile &file) { space_fields::fill_contacts(file, snapshot.contacts); });
        if (options.walls && !snapshot.obstacles.empty())
          put_part("obstacles",
                   [&](VtuFile &file) { space_fields::fill_obstacles(file, snapshot.obstacles); });
      });
}
} // namespace softgrain
