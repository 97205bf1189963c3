// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/output/space_fields.h>

#include <cmath>

namespace softgrain::space_fields
{
namespace
{
/// An index, where -1 stands for none.
std::int32_t id(const unsigned int index)
{
  return index == ContactState<3>::not_a_body ? -1 : static_cast<std::int32_t>(index);
}

template <class Number, class Vector>
void push(std::vector<Number> &values, const Vector &vector)
{
  for (unsigned int d = 0; d < 3; ++d)
    values.push_back(static_cast<Number>(vector[d]));
}

/// Row by row, as ParaView wants a tensor.
template <class Tensor>
void push_tensor(std::vector<float> &values, const Tensor &tensor)
{
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      values.push_back(static_cast<float>(tensor[i][j]));
}
} // namespace

void fill_points(VtuFile &file,
                 const PointStates<3> &points,
                 const bool deformation_gradient,
                 const bool extra)
{
  file.add_vertices(points.position);
  std::vector<std::int32_t> body;
  std::vector<float> volume, stress, von_mises, pressure, gradient;
  for (std::size_t p = 0; p < points.position.size(); ++p)
  {
    body.push_back(id(points.body[p]));
    volume.push_back(static_cast<float>(points.size[p]));
    push_tensor(stress, points.stress[p]);
    von_mises.push_back(static_cast<float>(std::sqrt(1.5) * deviator(points.stress[p]).norm()));
    pressure.push_back(static_cast<float>(-trace(points.stress[p]) / 3.));
    if (!points.deformation_gradient.empty())
      push_tensor(gradient, points.deformation_gradient[p]);
  }
  file.add_point_data("body", body);
  file.add_point_data("volume_m3", 1, volume);
  file.add_point_data("stress_Pa", 9, stress);
  file.add_point_data("von_mises_Pa", 1, von_mises);
  file.add_point_data("pressure_Pa", 1, pressure);
  for (const NamedField &field : points.extra)
    if (extra)
      file.add_point_data(field.name, 1, std::vector<float>(field.values.begin(), field.values.end()));
  if (deformation_gradient && !gradient.empty())
    file.add_point_data("deformation_gradient", 9, gradient);
}

void fill_surfaces(VtuFile &file, const std::vector<BodyState<3>> &bodies)
{
  std::vector<std::int32_t> index;
  std::vector<double> volume, mass, pressure;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    file.add_triangles(bodies[b].outline[0], bodies[b].triangles);
    index.insert(index.end(), bodies[b].triangles.size(), static_cast<std::int32_t>(b));
    volume.insert(volume.end(), bodies[b].triangles.size(), bodies[b].area);
    mass.insert(mass.end(), bodies[b].triangles.size(), bodies[b].mass);
    pressure.insert(pressure.end(), bodies[b].triangles.size(), -trace(bodies[b].mean_stress) / 3.);
  }
  file.add_cell_data("body", index);
  file.add_cell_data("volume_m3", 1, volume);
  file.add_cell_data("mass_kg", 1, mass);
  file.add_cell_data("mean_pressure_Pa", 1, pressure);
}

void fill_contacts(VtuFile &file, const std::vector<ContactState<3>> &contacts)
{
  std::vector<dealii::Point<3>> places;
  std::vector<std::int32_t> body_a, body_b, wall;
  std::vector<float> force, normal, normal_force, gap;
  for (const ContactState<3> &contact : contacts)
  {
    places.push_back(contact.place);
    body_a.push_back(id(contact.body_a));
    body_b.push_back(id(contact.body_b));
    wall.push_back(id(contact.wall));
    push(force, contact.force);
    push(normal, contact.normal);
    normal_force.push_back(static_cast<float>(contact.force * contact.normal));
    gap.push_back(static_cast<float>(contact.gap));
  }
  file.add_vertices(places);
  file.add_point_data("body_a", body_a);
  file.add_point_data("body_b", body_b);
  file.add_point_data("wall", wall);
  file.add_point_data("force_N", 3, force);
  file.add_point_data("normal", 3, normal);
  file.add_point_data("normal_force_N", 1, normal_force);
  file.add_point_data("gap_m", 1, gap);
}

void fill_obstacles(VtuFile &file, const std::vector<ObstacleState<3>> &obstacles)
{
  std::vector<std::int32_t> index;
  std::vector<double> pivot, force, angle, torque;
  for (std::size_t o = 0; o < obstacles.size(); ++o)
  {
    const ObstacleState<3> &obstacle = obstacles[o];
    const std::size_t n = obstacle.triangles.size();
    file.add_triangles(obstacle.line, obstacle.triangles);
    index.insert(index.end(), n, static_cast<std::int32_t>(o));
    angle.insert(angle.end(), n, obstacle.angle);
    torque.insert(torque.end(), n, obstacle.torque);
    for (std::size_t t = 0; t < n; ++t)
    {
      push(pivot, obstacle.pivot);
      push(force, obstacle.force);
    }
  }
  file.add_cell_data("obstacle", index);
  file.add_cell_data("pivot_m", 3, pivot);
  file.add_cell_data("angle_rad", 1, angle);
  file.add_cell_data("force_N", 3, force);
  file.add_cell_data("torque_N_m", 1, torque);
}
} // namespace softgrain::space_fields
