// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_snapshot_arrays_h
#define softgrain_output_snapshot_arrays_h

#include <softgrain/analysis/snapshot.h>

#include <string>

/// Names of the arrays of a snapshot, in the plane and in space, each with the member that it holds: one list
/// serves writing and reading, so that they cannot differ.
namespace softgrain::snapshot_arrays
{
/// A name for the plane, where all is per metre of thickness, or for space.
template <int dim>
std::string name_of(const char *in_plane, const char *in_space)
{
  return dim == 2 ? in_plane : in_space;
}

template <int dim, typename Action>
void for_each_body_array(const Action &action)
{
  action(
      name_of<dim>("bodies/area_m2", "bodies/volume_m3"), [](auto &body) -> auto & { return body.area; });
  action(
      name_of<dim>("bodies/reference_area_m2", "bodies/reference_volume_m3"),
      [](auto &body) -> auto & { return body.reference_area; });
  action(
      name_of<dim>("bodies/mass_kg_per_m", "bodies/mass_kg"), [](auto &body) -> auto & { return body.mass; });
  action(
      "bodies/center_m", [](auto &body) -> auto & { return body.center; });
  action(
      "bodies/velocity_m_per_s", [](auto &body) -> auto & { return body.velocity; });
  if constexpr (dim == 2)
    action(
        "bodies/angular_momentum_kg_m_per_s", [](auto &body) -> auto & { return body.angular_momentum; });
  action(
      "bodies/mean_stress_Pa", [](auto &body) -> auto & { return body.mean_stress; });
}

template <int dim, typename Action>
void for_each_contact_array(const Action &action)
{
  action(
      "contacts/place_m", [](auto &contact) -> auto & { return contact.place; });
  action(
      "contacts/normal", [](auto &contact) -> auto & { return contact.normal; });
  action(
      name_of<dim>("contacts/force_N_per_m", "contacts/force_N"),
      [](auto &contact) -> auto & { return contact.force; });
  if constexpr (dim == 2)
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

template <int dim, typename Action>
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
      name_of<dim>("walls/normal_force_N_per_m", "walls/normal_force_N"),
      [](auto &wall) -> auto & { return wall.normal_force; });
  if constexpr (dim == 2)
    action(
        "walls/tangential_force_N_per_m", [](auto &wall) -> auto & { return wall.tangential_force; });
}

/// Points, by their member vectors.
template <int dim, typename Points, typename Action>
void for_each_point_array(Points &points, const Action &action)
{
  action("points/position_m", points.position);
  action(name_of<dim>("points/area_m2", "points/volume_m3"), points.size);
  action("points/velocity_m_per_s", points.velocity);
  action("points/stress_Pa", points.stress);
  if constexpr (dim == 2)
    action("points/out_of_plane_stress_Pa", points.out_of_plane_stress);
  action("points/deformation_gradient", points.deformation_gradient);
}

template <int dim, typename Action>
void for_each_energy(const Action &action)
{
  const std::string unit = dim == 2 ? "_J_per_m" : "_J";
  action(
      "energies/kinetic_energy" + unit, [](auto &energies) -> auto & { return energies.kinetic; });
  action(
      "energies/elastic_energy" + unit, [](auto &energies) -> auto & { return energies.elastic; });
  action(
      "energies/dissipated_energy" + unit, [](auto &energies) -> auto & { return energies.dissipated; });
  action(
      "energies/external_work" + unit, [](auto &energies) -> auto & { return energies.external_work; });
}
} // namespace softgrain::snapshot_arrays

#endif
