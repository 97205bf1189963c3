// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of BpmModel that is looked at: neutral snapshot, walls, coordination, area.
#include <softgrain/analysis/touching_pairs.h>
#include <softgrain/base/parallel.h>
#include <softgrain/bpm/bpm_model.h>
#include <softgrain/driving/wall_balance.h>
#include <softgrain/geometry/aggregate_outline.h>
#include <softgrain/geometry/polygon.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/timer.h>

#include <algorithm>

namespace softgrain::bpm
{
namespace
{
dealii::Point<2> point_of(const std::array<double, 2> &x)
{
  return {x[0], x[1]};
}

dealii::Tensor<1, 2> vector_of(const std::array<double, 2> &x)
{
  return dealii::Tensor<1, 2>({x[0], x[1]});
}
} // namespace

std::vector<std::vector<std::vector<dealii::Point<2>>>> BpmModel::outlines() const
{
  const dealii::TimerOutput::Scope section(*timer, "outlines");
  const Primaries &disks = dynamics->disks();
  std::vector<std::vector<std::vector<dealii::Point<2>>>> result(scene.bodies.size());
  parallel_for(scene.bodies.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                 {
                   std::vector<dealii::Point<2>> centers;
                   for (std::size_t i = first_of_body[b]; i < first_of_body[b + 1]; ++i)
                     centers.push_back(point_of(disks.position[i]));
                   const std::vector<double> radii(disks.radius.begin() + first_of_body[b],
                                                   disks.radius.begin() + first_of_body[b + 1]);
                   result[b] = aggregate_outline(centers, radii, 0.5 * dynamics->mean_diameter());
                 }
               });
  return result;
}

void BpmModel::refresh_solid_area() const
{
  area_now = 0.;
  for (const auto &outline : outlines())
    for (const auto &loop : outline)
      area_now += signed_area(loop);
}

double BpmModel::solid_area() const
{
  // Outlines cost more than a step, and change only as primaries change their neighbours.
  if (area_now < 0. || area_of_list != dynamics->lists_made())
  {
    refresh_solid_area();
    area_of_list = dynamics->lists_made();
  }
  return area_now;
}

double BpmModel::unbalanced_walls() const
{
  return unbalanced(moving_walls);
}

std::vector<WallState<2>> BpmModel::walls() const
{
  return states_of(moving_walls);
}

std::vector<ObstacleState<2>> BpmModel::obstacles() const
{
  return states_of(moving_obstacles);
}

double BpmModel::coordination() const
{
  const Primaries &disks = dynamics->disks();
  const contact::DiskContacts &rows = dynamics->contacts();
  TouchingPairs touching;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    if (!dynamics->carries_force(row))
      continue;
    const std::size_t body = disks.body[rows.a[row]], b = rows.b[row];
    if (b < disks.size())
      touching.add_bodies(body, disks.body[b]);
    else
      touching.add_wall(body, b - disks.size());
  }
  return touching.coordination(scene.bodies.size());
}

ContactState<2> BpmModel::contact_state(const std::size_t row) const
{
  const Primaries &disks = dynamics->disks();
  const contact::DiskContacts &rows = dynamics->contacts();
  ContactState<2> state;
  const std::uint32_t a = rows.a[row], b = rows.b[row];
  const dealii::Tensor<1, 2> normal = vector_of(rows.normal[row]);
  state.body_a = disks.body[a];
  if (b < disks.size())
    state.body_b = disks.body[b];
  else
    state.wall = b - disks.size();
  state.normal = normal;
  state.gap = dynamics->gaps()[row];
  state.place = point_of(disks.position[a]) - (disks.radius[a] + 0.5 * state.gap) * normal;
  // A pair of primaries stands for so much of the line along which two bodies touch.
  state.length = b < disks.size() ? disks.radius[a] + disks.radius[b] : 2. * disks.radius[a];
  state.force = rows.impulse[row] / last_dt * normal;
  if (disks.rotate())
    state.force += rows.tangential_impulse[row] / last_dt * dealii::Tensor<1, 2>({-normal[1], normal[0]});
  return state;
}

void BpmModel::add_inner_forces(Snapshot<2> &snapshot, const FoldedBodies *const cell) const
{
  // Pairs of one body carry contact and attraction together; what the eye wants is the sum.
  const Primaries &disks = dynamics->disks();
  const contact::NeighbourList &list = dynamics->neighbours();
  for (std::size_t pair = 0; pair < list.n_pairs(); ++pair)
  {
    const std::uint32_t a = list.a(pair), b = list.b(pair);
    if (disks.body[a] != disks.body[b])
      continue;
    const double force = list.memory()[pair][0] / last_dt - dynamics->attraction_of(pair);
    if (force == 0.)
      continue;
    ContactState<2> state;
    state.body_a = state.body_b = disks.body[a];
    const dealii::Point<2> xa = point_of(disks.position[a]), xb = point_of(disks.position[b]);
    const double distance = xa.distance(xb);
    if (distance == 0.)
      continue;
    state.normal = (xa - xb) / distance;
    state.gap = distance - disks.radius[a] - disks.radius[b];
    state.place = xa - (disks.radius[a] + 0.5 * state.gap) * state.normal;
    state.length = distance;
    state.force = force * state.normal;
    if (cell != nullptr)
      cell->fold(state, {}, {});
    snapshot.contacts.push_back(state);
  }
}

Snapshot<2> BpmModel::snapshot() const
{
  const Primaries &disks = dynamics->disks();
  Snapshot<2> snapshot;
  snapshot.time = now;
  snapshot.step = steps;
  snapshot.walls = walls();
  snapshot.obstacles = obstacles();
  snapshot.energies = energies();

  PointStates<2> &points = snapshot.points;
  NamedField radius{"radius_m", disks.radius};
  points.body = disks.body;
  points.stress.resize(disks.size());
  for (std::size_t i = 0; i < disks.size(); ++i)
  {
    points.position.push_back(point_of(disks.position[i]));
    points.size.push_back(dealii::numbers::PI * disks.radius[i] * disks.radius[i]);
    points.velocity.push_back(vector_of(disks.velocity[i]));
  }
  points.extra.push_back(std::move(radius));
  if (disks.rotate())
    points.extra.push_back({"angular_velocity_rad_per_s", disks.angular_velocity});

  const auto loops = outlines();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
  {
    BodyState<2> state;
    state.name = scene.bodies[b].name;
    state.outline = loops[b];
    for (const auto &loop : loops[b])
      state.area += signed_area(loop);
    state.reference_area = area_at_start[b];
    dealii::Tensor<1, 2> moment, momentum;
    for (std::size_t i = first_of_body[b]; i < first_of_body[b + 1]; ++i)
    {
      state.mass += disks.mass[i];
      moment += disks.mass[i] * vector_of(disks.position[i]);
      momentum += disks.mass[i] * vector_of(disks.velocity[i]);
    }
    state.center = dealii::Point<2>(moment / state.mass);
    state.velocity = momentum / state.mass;
    for (std::size_t i = first_of_body[b]; i < first_of_body[b + 1]; ++i)
    {
      const dealii::Tensor<1, 2> arm = point_of(disks.position[i]) - state.center;
      state.angular_momentum +=
          disks.mass[i] * (arm[0] * disks.velocity[i][1] - arm[1] * disks.velocity[i][0]);
      if (disks.rotate())
        state.angular_momentum +=
            0.5 * disks.mass[i] * disks.radius[i] * disks.radius[i] * disks.angular_velocity[i];
    }
    snapshot.bodies.push_back(state);
  }
  if (last_dt > 0.)
    add_stresses(snapshot);

  const contact::DiskContacts &rows = dynamics->contacts();
  const std::optional<FoldedBodies> cell = fold_bodies(snapshot);
  for (std::size_t row = 0; row < rows.size() && last_dt > 0.; ++row)
  {
    const bool inner = rows.b[row] < disks.size() && disks.body[rows.a[row]] == disks.body[rows.b[row]];
    if (inner || !dynamics->carries_force(row))
      continue;
    snapshot.contacts.push_back(contact_state(row));
    if (cell)
      cell->fold(snapshot.contacts.back(), {},
                 rows.b[row] < disks.size() ? dynamics->image_of_row(row) : PeriodicCell<2>::Image());
  }
  if (settings.inner_contacts_in_output && last_dt > 0.)
    add_inner_forces(snapshot, cell ? &*cell : nullptr);
  return snapshot;
}

void BpmModel::add_stresses(Snapshot<2> &snapshot) const
{
  // Internal moments (2.30)-(2.31): sum of force times arm over the forces on a primary or on a body.
  const Primaries &disks = dynamics->disks();
  const contact::DiskContacts &rows = dynamics->contacts();
  const contact::NeighbourList &list = dynamics->neighbours();
  const auto add =
      [&](const std::uint32_t i, const dealii::Tensor<1, 2> &force, const dealii::Tensor<1, 2> &arm)
  {
    const dealii::SymmetricTensor<2, 2> moment = symmetrize(outer_product(force, arm));
    snapshot.points.stress[i] += moment / snapshot.points.size[i];
    snapshot.bodies[disks.body[i]].mean_stress += moment;
  };
  const auto add_pair = [&](const std::uint32_t a, const std::uint32_t b, const dealii::Tensor<1, 2> &normal,
                            const double gap, const dealii::Tensor<1, 2> &force)
  {
    // The force acts in the middle of the gap, at the end of both arms.
    add(a, force, -(disks.radius[a] + 0.5 * gap) * normal);
    add(b, -force, (disks.radius[b] + 0.5 * gap) * normal);
  };
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    if (!dynamics->carries_force(row))
      continue;
    const ContactState<2> contact = contact_state(row);
    if (rows.b[row] < disks.size())
      add_pair(rows.a[row], rows.b[row], contact.normal, contact.gap, contact.force);
    else
      add(rows.a[row], contact.force, -disks.radius[rows.a[row]] * contact.normal);
  }
  for (std::size_t pair = 0; pair < list.n_pairs(); ++pair)
  {
    const double strength = dynamics->attraction_of(pair);
    if (strength == 0.)
      continue;
    const std::uint32_t a = list.a(pair), b = list.b(pair);
    const dealii::Tensor<1, 2> branch = point_of(disks.position[a]) - point_of(disks.position[b]);
    const double distance = branch.norm();
    if (distance > 0.)
      add_pair(a, b, branch / distance, distance - disks.radius[a] - disks.radius[b],
               -strength / distance * branch);
  }
  for (BodyState<2> &body : snapshot.bodies)
    if (body.area > 0.)
      body.mean_stress /= body.area;
}
} // namespace softgrain::bpm
