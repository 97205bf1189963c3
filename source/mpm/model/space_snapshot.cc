// SPDX-License-Identifier: LGPL-2.1-or-later
// What pictures and measures are told of a scene in space.
#include <softgrain/mpm/model/space_model.h>

namespace softgrain::mpm
{
BodyState<3> SpaceModel::body_state() const
{
  BodyState<3> state;
  state.name = body.name;
  state.outline.emplace_back();
  for (const dealii::Point<3> &x : surface.vertices)
    state.outline[0].push_back(x + body.field.functions_at(x).at(body.displacement));
  state.triangles = surface.triangles;
  state.reference_area = body.rest_area;
  state.mass = body.density * body.rest_area;
  state.center = body.center();
  return state;
}

Snapshot<3> SpaceModel::snapshot() const
{
  Snapshot<3> result;
  result.time = now;
  result.step = steps;
  result.walls = walls();
  result.energies = energies();
  Eigen::VectorXd all;
  body.field.prolongate(body.displacement, all);
  BodyState<3> of_body = body_state();
  PointStates<3> &points = result.points;
  const StepState<3> &state = pressed.points();
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    dealii::Point<3> x = body.points[p].position();
    for (unsigned int k = 0; k < body.field.nodes_per_cell(); ++k)
      for (unsigned int d = 0; d < 3; ++d)
        x[d] += body.field.values(p)[k] * all[3 * body.field.point_nodes(p)[k] + d];
    const double J = determinant(state.gradient[p]), volume = J * body.points[p].rest_volume();
    // Laws of finite strain tell Kirchhoff's stress.
    const dealii::SymmetricTensor<2, 3> stress = state.stress[p] / (body.small_strain() ? 1. : J);
    points.position.push_back(x);
    points.body.push_back(0);
    points.size.push_back(volume);
    points.velocity.emplace_back();
    points.stress.push_back(stress);
    points.deformation_gradient.push_back(state.gradient[p]);
    of_body.area += volume;
    of_body.mean_stress += volume * stress;
  }
  of_body.mean_stress /= of_body.area;
  result.bodies.push_back(of_body);
  for (unsigned int w = 0; w < driven.size(); ++w)
    for (std::size_t k = 0; k < pressed.n_places(w); ++k)
      if (const double P = pressed.forces(w)[k]; P > 0.)
      {
        ContactState<3> contact;
        contact.body_a = 0;
        contact.wall = w;
        contact.place = pressed.place(w, k);
        contact.normal = driven[w].description.normal;
        contact.force = P * contact.normal;
        contact.gap = (contact.place - driven[w].point()) * contact.normal;
        result.contacts.push_back(contact);
      }
  return result;
}
} // namespace softgrain::mpm
