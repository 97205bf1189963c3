// SPDX-License-Identifier: LGPL-2.1-or-later
// What pictures and measures are told of a scene in space.
#include <softgrain/driving/folded_bodies.h>
#include <softgrain/mpm/body/remembered_points.h>
#include <softgrain/mpm/model/point_history.h>
#include <softgrain/mpm/model/space_model.h>

namespace softgrain::mpm
{
BodyState<3> SpaceModel::body_state(const Body<3> &body) const
{
  BodyState<3> result;
  result.name = body.name;
  result.outline.push_back(body.boundary.position);
  result.triangles = state.surfaces[body.index].triangles;
  result.reference_area = body.rest.area;
  result.mass = body.material.density * body.rest.area;
  result.center = body.center();
  result.velocity = body.nodes.momentum() / body.nodes.mass.sum();
  return result;
}

void SpaceModel::add_points(const Body<3> &body, BodyState<3> &of_body, PointStates<3> &points) const
{
  Eigen::VectorXd all, velocity = Eigen::VectorXd::Zero(3 * body.field.nodes().n());
  body.field.extension().prolongate(body.nodes.displacement, all);
  if (body.nodes.velocity.size() > 0)
    body.field.extension().prolongate(body.nodes.velocity, velocity);
  const StepState<3> here = stress_of(body);
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    dealii::Point<3> x = body.points[p].position();
    dealii::Tensor<1, 3> v;
    for (unsigned int k = 0; k < body.field.cells().nodes_per_cell(); ++k)
      for (unsigned int d = 0; d < 3; ++d)
      {
        x[d] += body.field.at_point(p).values[k] * all[3 * body.field.at_point(p).nodes[k] + d];
        v[d] += body.field.at_point(p).values[k] * velocity[3 * body.field.at_point(p).nodes[k] + d];
      }
    const double J = determinant(here.gradient[p]), volume = J * body.points[p].rest_volume();
    // Laws of finite strain tell Kirchhoff's stress.
    const dealii::SymmetricTensor<2, 3> stress =
        (remembers(body) ? body.points[p].stress() : here.stress[p]) /
        (body.material.small_strain() ? 1. : J);
    points.position.push_back(x);
    points.body.push_back(body.index);
    points.size.push_back(volume);
    points.velocity.push_back(v);
    points.stress.push_back(stress);
    points.deformation_gradient.push_back(here.gradient[p]);
    of_body.area += volume;
    of_body.mean_stress += volume * stress;
  }
  of_body.mean_stress /= of_body.area;
}

Snapshot<3> SpaceModel::snapshot() const
{
  Snapshot<3> result;
  result.time = state.time;
  result.step = steps;
  result.walls = walls();
  result.obstacles = obstacles();
  result.energies = energies();
  for (const Body<3> &body : state.bodies)
  {
    BodyState<3> of_body = body_state(body);
    add_points(body, of_body, result.points);
    result.bodies.push_back(of_body);
  }
  for (const Body<3> &body : state.bodies)
    add_history_fields(*body.material.law, result.points);
  std::size_t begin = 0;
  for (const Body<3> &body : state.bodies)
  {
    put_history(
        body, [begin](const unsigned int p) { return begin + p; }, result.points);
    begin += body.points.size();
  }
  const std::optional<FoldedBodies<3>> cell = fold_bodies(result);
  for (const SpaceContact &of_ray : state.contacts)
  {
    ContactState<3> contact;
    contact.body_a = of_ray.body;
    if (of_ray.partner != ContactFrame<3>::none)
      contact.body_b = of_ray.partner;
    else
      contact.wall = of_ray.wall;
    contact.place = of_ray.place;
    contact.normal = of_ray.normal;
    contact.force = of_ray.force;
    contact.gap = of_ray.gap;
    if (cell)
      cell->fold(contact, {}, of_ray.image);
    result.contacts.push_back(contact);
  }
  return result;
}
} // namespace softgrain::mpm
