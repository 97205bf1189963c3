// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of SpaceModel that is looked at: neutral snapshot, walls, coordination, volume.
#include <softgrain/analysis/touching_pairs.h>
#include <softgrain/base/parallel.h>
#include <softgrain/bpm/aggregate.h>
#include <softgrain/bpm/space_model.h>
#include <softgrain/geometry/cluster_surface.h>

#include <cmath>

namespace softgrain::bpm
{
namespace
{
dealii::Point<3> point_of(const std::array<double, 3> &x)
{
  return {x[0], x[1], x[2]};
}

dealii::Tensor<1, 3> vector_of(const std::array<double, 3> &x)
{
  return dealii::Tensor<1, 3>({x[0], x[1], x[2]});
}
} // namespace

dealii::Point<3> SpaceModel::center_of(const std::size_t body) const
{
  const Balls &balls = dynamics->balls();
  double sum = 0.;
  dealii::Tensor<1, 3> moment;
  for (std::size_t i = first_of_body[body]; i < first_of_body[body + 1]; ++i)
  {
    sum += balls.mass[i];
    moment += balls.mass[i] * vector_of(balls.position[i]);
  }
  return dealii::Point<3>(moment / sum);
}

TriangulatedSurface SpaceModel::surface_of(const std::size_t body) const
{
  const Balls &balls = dynamics->balls();
  std::vector<dealii::Point<3>> centers;
  for (std::size_t i = first_of_body[body]; i < first_of_body[body + 1]; ++i)
    centers.push_back(point_of(balls.position[i]));
  const std::vector<double> radii(balls.radius.begin() + first_of_body[body],
                                  balls.radius.begin() + first_of_body[body + 1]);
  return cluster_surface(center_of(body), centers, radii, 0.5 * dynamics->mean_diameter(), directions);
}

double SpaceModel::solid_area() const
{
  // Surfaces cost more than a step, and change only as primaries change their neighbours.
  if (volume_now >= 0. && volume_of_list == dynamics->present().lists_made())
    return volume_now;
  const dealii::TimerOutput::Scope section(*timer, "surfaces");
  std::vector<double> volume(scene.bodies.size());
  parallel_for(volume.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   volume[b] = enclosed_volume(surface_of(b));
               });
  volume_now = 0.;
  for (const double one : volume)
    volume_now += one;
  volume_of_list = dynamics->present().lists_made();
  return volume_now;
}

std::vector<WallState<3>> SpaceModel::walls() const
{
  return states_of(moving_walls);
}

double SpaceModel::coordination() const
{
  const Balls &balls = dynamics->balls();
  const contact::BallContacts &rows = dynamics->present().rows();
  TouchingPairs touching;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    if (!(rows.impulse[row] > 0.))
      continue;
    const std::size_t body = balls.body[rows.a[row]], b = rows.b[row];
    if (b < balls.size())
      touching.add_bodies(body, balls.body[b]);
    else
      touching.add_wall(body, b - balls.size());
  }
  return touching.coordination(scene.bodies.size());
}

ContactState<3> SpaceModel::contact_state(const std::size_t row) const
{
  const Balls &balls = dynamics->balls();
  const contact::BallContacts &rows = dynamics->present().rows();
  ContactState<3> state;
  const std::uint32_t a = rows.a[row], b = rows.b[row];
  state.body_a = balls.body[a];
  if (b < balls.size())
    state.body_b = balls.body[b];
  else
    state.wall = b - balls.size();
  state.normal = vector_of(rows.normal[row]);
  state.gap = dynamics->present().gaps()[row];
  state.place = point_of(balls.position[a]) - (balls.radius[a] + 0.5 * state.gap) * state.normal;
  state.force = rows.impulse[row] / last_dt * state.normal;
  if (balls.rotate())
    state.force += vector_of(rows.tangential_impulse[row]) / last_dt;
  return state;
}

void SpaceModel::add_contacts(Snapshot<3> &snapshot) const
{
  const Balls &balls = dynamics->balls();
  const contact::BallContacts &rows = dynamics->present().rows();
  for (std::size_t row = 0; row < rows.size() && last_dt > 0.; ++row)
  {
    const bool inner = rows.b[row] < balls.size() && balls.body[rows.a[row]] == balls.body[rows.b[row]];
    if (!inner && rows.impulse[row] > 0.)
      snapshot.contacts.push_back(contact_state(row));
  }
}

template <class Work>
void SpaceModel::for_bonds(const Work &work) const
{
  // Pairs of one body carry contact and attraction together.
  const Balls &balls = dynamics->balls();
  const contact::BallList &list = dynamics->neighbours();
  const contact::BallContacts &rows = dynamics->present().rows();
  std::vector<double> force(list.n_pairs(), 0.);
  for (std::size_t row = 0; row < dynamics->present().pairs().size(); ++row)
    force[dynamics->present().pairs()[row]] = rows.impulse[row] / last_dt;
  for (std::size_t pair = 0; pair < list.n_pairs(); ++pair)
  {
    const std::uint32_t a = list.a(pair), b = list.b(pair);
    if (balls.body[a] != balls.body[b])
      continue;
    force[pair] -= dynamics->present().attraction_of(pair);
    if (force[pair] != 0.)
      work(a, b, force[pair], point_of(balls.position[a]) - point_of(balls.position[b]));
  }
}

void SpaceModel::add_inner_forces(Snapshot<3> &snapshot) const
{
  const Balls &balls = dynamics->balls();
  for_bonds(
      [&](const std::uint32_t a, const std::uint32_t b, const double force,
          const dealii::Tensor<1, 3> &branch)
      {
        ContactState<3> state;
        const double distance = branch.norm();
        state.body_a = state.body_b = balls.body[a];
        state.normal = branch / distance;
        state.gap = distance - balls.radius[a] - balls.radius[b];
        state.place = point_of(balls.position[a]) - (balls.radius[a] + 0.5 * state.gap) * state.normal;
        state.force = force * state.normal;
        snapshot.contacts.push_back(state);
      });
}

void SpaceModel::add_stresses(Snapshot<3> &snapshot) const
{
  // Internal moments: sum of force times arm over the forces on a primary, and on a body.
  const Balls &balls = dynamics->balls();
  const auto add =
      [&](const std::uint32_t i, const dealii::Tensor<1, 3> &force, const dealii::Tensor<1, 3> &arm)
  {
    const dealii::SymmetricTensor<2, 3> moment = symmetrize(outer_product(force, arm));
    snapshot.points.stress[i] += moment / snapshot.points.size[i];
    snapshot.bodies[balls.body[i]].mean_stress += moment;
  };
  const auto add_pair = [&](const std::uint32_t a, const std::uint32_t b, const dealii::Tensor<1, 3> &normal,
                            const double gap, const dealii::Tensor<1, 3> &force)
  {
    // The force acts in the middle of the gap, at the end of both arms.
    add(a, force, -(balls.radius[a] + 0.5 * gap) * normal);
    add(b, -force, (balls.radius[b] + 0.5 * gap) * normal);
  };
  const contact::BallContacts &rows = dynamics->present().rows();
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    const std::uint32_t a = rows.a[row], b = rows.b[row];
    if (!(rows.impulse[row] > 0.) || (b < balls.size() && balls.body[a] == balls.body[b]))
      continue;
    const ContactState<3> contact = contact_state(row);
    if (b < balls.size())
      add_pair(a, b, contact.normal, contact.gap, contact.force);
    else
      add(a, contact.force, -balls.radius[a] * contact.normal);
  }
  for_bonds(
      [&](const std::uint32_t a, const std::uint32_t b, const double force,
          const dealii::Tensor<1, 3> &branch)
      {
        const double distance = branch.norm();
        add_pair(a, b, branch / distance, distance - balls.radius[a] - balls.radius[b],
                 force / distance * branch);
      });
  for (BodyState<3> &body : snapshot.bodies)
    if (body.area > 0.)
      body.mean_stress /= body.area;
}

void SpaceModel::show_balls(Snapshot<3> &snapshot) const
{
  const Balls &balls = dynamics->balls();
  PointStates<3> &points = snapshot.points;
  points.body = balls.body;
  points.stress.resize(balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    points.position.push_back(point_of(balls.position[i]));
    points.size.push_back(size_of_primary<3>(balls.radius[i]));
    points.velocity.push_back(vector_of(balls.velocity[i]));
  }
  points.extra.push_back({"radius_m", balls.radius});
}

void SpaceModel::show_bodies(Snapshot<3> &snapshot) const
{
  const Balls &balls = dynamics->balls();
  const std::size_t before = snapshot.bodies.size();
  snapshot.bodies.resize(before + scene.bodies.size());
  parallel_for(scene.bodies.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                 {
                   BodyState<3> &state = snapshot.bodies[before + b];
                   state.name = scene.bodies[b].name;
                   const TriangulatedSurface surface = surface_of(b);
                   state.outline.push_back(surface.vertices);
                   state.triangles = surface.triangles;
                   state.area = enclosed_volume(surface);
                   state.reference_area = volume_at_start[b];
                   state.center = center_of(b);
                   dealii::Tensor<1, 3> momentum;
                   for (std::size_t i = first_of_body[b]; i < first_of_body[b + 1]; ++i)
                   {
                     state.mass += balls.mass[i];
                     momentum += balls.mass[i] * vector_of(balls.velocity[i]);
                   }
                   state.velocity = momentum / state.mass;
                 }
               });
}

Snapshot<3> SpaceModel::snapshot() const
{
  Snapshot<3> result;
  result.time = now;
  result.step = steps;
  result.walls = walls();
  result.energies = energies();
  show_balls(result);
  show_bodies(result);
  if (last_dt == 0.)
    return result;
  add_stresses(result);
  add_contacts(result);
  if (settings.inner_contacts_in_output)
    add_inner_forces(result);
  return result;
}

Snapshot<3> SpaceModel::touching_state() const
{
  Snapshot<3> result;
  result.time = now;
  result.step = steps;
  result.walls = walls();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
  {
    result.bodies.emplace_back();
    result.bodies.back().name = scene.bodies[b].name;
    result.bodies.back().center = center_of(b);
  }
  add_contacts(result);
  return result;
}
} // namespace softgrain::bpm
