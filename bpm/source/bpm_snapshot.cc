// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of BpmModel that is looked at: neutral snapshot, walls, coordination, area.
#include <softgrain/analysis/touching_pairs.h>
#include <softgrain/bpm/bpm_model.h>
#include <softgrain/bpm/gathered_primaries.h>
#include <softgrain/driving/wall_balance.h>
#include <softgrain/geometry/polygon.h>

#include <deal.II/base/numbers.h>

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
/// Adds to @p touching, which has the contacts known here, those of the others.
void add_those_of_all(TouchingPairs &touching, const Exchange &exchange)
{
  std::vector<double> bodies, walls;
  const auto write = [](const auto &pairs, std::vector<double> &list)
  {
    for (const auto &[one, other] : pairs)
      list.insert(list.end(), {static_cast<double>(one), static_cast<double>(other)});
  };
  write(touching.pairs_of_bodies(), bodies);
  write(touching.pairs_with_walls(), walls);
  for (const std::vector<double> &list : exchange.lists_of_all(bodies))
    for (std::size_t k = 0; k < list.size(); k += 2)
      touching.add_bodies(static_cast<std::size_t>(list[k]), static_cast<std::size_t>(list[k + 1]));
  for (const std::vector<double> &list : exchange.lists_of_all(walls))
    for (std::size_t k = 0; k < list.size(); k += 2)
      touching.add_wall(static_cast<std::size_t>(list[k]), static_cast<std::size_t>(list[k + 1]));
}
} // namespace

void BpmModel::refresh_solid_area() const
{
  area_now = 0.;
  for (const double area : outlined_areas())
    area_now += area;
}

double BpmModel::solid_area() const
{
  // Outlines cost more than a step, and change only as primaries change their neighbours.
  if (area_now < 0. || area_of_list != dynamics->present().lists_made())
  {
    refresh_solid_area();
    area_of_list = dynamics->present().lists_made();
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
  const PresentContacts present = dynamics->present();
  const contact::DiskContacts &rows = present.rows();
  TouchingPairs touching;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    if (!present.carries_force(row))
      continue;
    const std::size_t body = disks.body[rows.a[row]], b = rows.b[row];
    if (b < disks.size())
      touching.add_bodies(body, disks.body[b]);
    else
      touching.add_wall(body, b - disks.size());
  }
  if (dynamics->strips() != nullptr)
    add_those_of_all(touching, exchange);
  return touching.coordination(scene.bodies.size());
}

ContactState<2> BpmModel::contact_state(const GatheredPrimaries &seen, const std::size_t row) const
{
  const Primaries &disks = seen.disks();
  const contact::DiskContacts &rows = seen.rows();
  ContactState<2> state;
  const std::uint32_t a = rows.a[row], b = rows.b[row];
  const dealii::Tensor<1, 2> normal = vector_of(rows.normal[row]);
  state.body_a = disks.body[a];
  if (b < disks.size())
    state.body_b = disks.body[b];
  else
    state.wall = b - disks.size();
  state.normal = normal;
  state.gap = seen.gap(row);
  state.place = point_of(disks.position[a]) - (disks.radius[a] + 0.5 * state.gap) * normal;
  // A pair of primaries stands for so much of the line along which two bodies touch.
  state.length = b < disks.size() ? disks.radius[a] + disks.radius[b] : 2. * disks.radius[a];
  state.force = rows.impulse[row] / last_dt * normal;
  if (disks.rotate())
    state.force += rows.tangential_impulse[row] / last_dt * dealii::Tensor<1, 2>({-normal[1], normal[0]});
  return state;
}

void BpmModel::add_inner_forces(const GatheredPrimaries &seen,
                                Snapshot<2> &snapshot,
                                const FoldedBodies<2> *const cell) const
{
  // Pairs of one body carry contact and attraction together; what the eye wants is the sum.
  const Primaries &disks = seen.disks();
  seen.for_bonds(
      [&](const GatheredPrimaries::Bond &bond)
      {
        const std::uint32_t a = bond.a, b = bond.b;
        const double force = bond.impulse / last_dt - bond.attraction;
        const dealii::Point<2> xa = point_of(disks.position[a]), xb = point_of(disks.position[b]);
        const double distance = xa.distance(xb);
        if (force == 0. || distance == 0.)
          return;
        ContactState<2> state;
        state.body_a = state.body_b = disks.body[a];
        state.normal = (xa - xb) / distance;
        state.gap = distance - disks.radius[a] - disks.radius[b];
        state.place = xa - (disks.radius[a] + 0.5 * state.gap) * state.normal;
        state.length = distance;
        state.force = force * state.normal;
        if (cell != nullptr)
          cell->fold(state, {}, {});
        snapshot.contacts.push_back(state);
      });
}

namespace
{
/// What all have alike of every snapshot.
Snapshot<2> begin_snapshot(const BpmModel &model)
{
  Snapshot<2> snapshot;
  snapshot.time = model.time();
  snapshot.step = model.step();
  snapshot.walls = model.walls();
  snapshot.obstacles = model.obstacles();
  return snapshot;
}
} // namespace

Snapshot<2> BpmModel::snapshot() const
{
  Snapshot<2> snapshot = begin_snapshot(*this);
  snapshot.energies = energies();
  const Outlines loops = outlines();
  const GatheredPrimaries seen(*dynamics);
  if (dynamics->strips() == nullptr)
  {
    show(seen, loops, snapshot);
    return snapshot;
  }
  exchange.at_first([&]() { show(seen, loops, snapshot); });
  tell_of_bodies(snapshot, loops);
  return snapshot;
}

void BpmModel::show(const GatheredPrimaries &seen, const Outlines &loops, Snapshot<2> &snapshot) const
{
  const Primaries &disks = seen.disks();
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
  show_bodies(disks, loops, snapshot);
  if (last_dt > 0.)
    add_stresses(seen, snapshot);

  const std::optional<FoldedBodies<2>> cell = add_contacts(seen, snapshot);
  if (settings.inner_contacts_in_output && last_dt > 0.)
    add_inner_forces(seen, snapshot, cell ? &*cell : nullptr);
}

Snapshot<2> BpmModel::touching_state() const
{
  Snapshot<2> snapshot = begin_snapshot(*this);
  const GatheredPrimaries seen(*dynamics);
  // Where each owner has some primaries, only the first one sees those of all.
  if (dynamics->strips() != nullptr && !exchange.first())
    return snapshot;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
  {
    snapshot.bodies.emplace_back();
    snapshot.bodies.back().name = scene.bodies[b].name;
    snapshot.bodies.back().center = center_of(seen.disks(), b);
  }
  add_contacts(seen, snapshot);
  return snapshot;
}

std::optional<FoldedBodies<2>> BpmModel::add_contacts(const GatheredPrimaries &seen,
                                                      Snapshot<2> &snapshot) const
{
  const Primaries &disks = seen.disks();
  const contact::DiskContacts &rows = seen.rows();
  std::optional<FoldedBodies<2>> cell = fold_bodies(snapshot);
  for (std::size_t row = 0; row < rows.a.size() && last_dt > 0.; ++row)
  {
    const bool inner = rows.b[row] < disks.size() && disks.body[rows.a[row]] == disks.body[rows.b[row]];
    if (inner || !seen.carries_force(row))
      continue;
    snapshot.contacts.push_back(contact_state(seen, row));
    if (cell)
      cell->fold(snapshot.contacts.back(), {},
                 rows.b[row] < disks.size() ? seen.image_of_row(row) : PeriodicCell<2>::Image());
  }
  return cell;
}

dealii::Point<2> BpmModel::center_of(const Primaries &disks, const std::size_t body) const
{
  double mass = 0.;
  dealii::Tensor<1, 2> moment;
  for (std::size_t i = first_of_body[body]; i < first_of_body[body + 1]; ++i)
  {
    mass += disks.mass[i];
    moment += disks.mass[i] * vector_of(disks.position[i]);
  }
  return dealii::Point<2>(moment / mass);
}

void BpmModel::show_bodies(const Primaries &disks, const Outlines &loops, Snapshot<2> &snapshot) const
{
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
  {
    BodyState<2> state;
    state.name = scene.bodies[b].name;
    state.outline = loops[b];
    for (const auto &loop : loops[b])
      state.area += signed_area(loop);
    state.reference_area = area_at_start[b];
    dealii::Tensor<1, 2> momentum;
    for (std::size_t i = first_of_body[b]; i < first_of_body[b + 1]; ++i)
    {
      state.mass += disks.mass[i];
      momentum += disks.mass[i] * vector_of(disks.velocity[i]);
    }
    state.center = center_of(disks, b);
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
}

void BpmModel::add_stresses(const GatheredPrimaries &seen, Snapshot<2> &snapshot) const
{
  // Internal moments (2.30)-(2.31): sum of force times arm over the forces on a primary or on a body.
  const Primaries &disks = seen.disks();
  const contact::DiskContacts &rows = seen.rows();
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
    if (!seen.carries_force(row))
      continue;
    const ContactState<2> contact = contact_state(seen, row);
    if (rows.b[row] < disks.size())
      add_pair(rows.a[row], rows.b[row], contact.normal, contact.gap, contact.force);
    else
      add(rows.a[row], contact.force, -disks.radius[rows.a[row]] * contact.normal);
  }
  seen.for_bonds(
      [&](const GatheredPrimaries::Bond &bond)
      {
        const std::uint32_t a = bond.a, b = bond.b;
        const dealii::Tensor<1, 2> branch = point_of(disks.position[a]) - point_of(disks.position[b]);
        const double distance = branch.norm();
        if (bond.attraction != 0. && distance > 0.)
          add_pair(a, b, branch / distance, distance - disks.radius[a] - disks.radius[b],
                   -bond.attraction / distance * branch);
      });
  for (BodyState<2> &body : snapshot.bodies)
    if (body.area > 0.)
      body.mean_stress /= body.area;
}
} // namespace softgrain::bpm
