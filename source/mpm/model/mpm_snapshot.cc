// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/touching_pairs.h>
#include <softgrain/driving/folded_bodies.h>
#include <softgrain/driving/wall_balance.h>
#include <softgrain/geometry/polygon.h>
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/contact/plane_compliance.h>
#include <softgrain/mpm/model/mpm_model.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
using Row = ContactRow<2>;

double outline_area(const Body<2> &body)
{
  double area = 0.;
  for (unsigned int l = 0; l < body.boundary.n_loops(); ++l)
    area += signed_area(Polygon(body.boundary.position.begin() + body.boundary.loop_start[l],
                                body.boundary.position.begin() + body.boundary.loop_start[l + 1]));
  return area;
}
} // namespace

BodyState<2> MpmModel::body_state(const Body<2> &body, const std::array<double, 4> &stress_sum) const
{
  BodyState<2> state;
  state.name = body.name;
  for (unsigned int l = 0; l < body.boundary.n_loops(); ++l)
    state.outline.emplace_back(body.boundary.position.begin() + body.boundary.loop_start[l],
                               body.boundary.position.begin() + body.boundary.loop_start[l + 1]);
  state.area = outline_area(body);
  state.reference_area = body.rest.area;
  state.mass = body.nodes.mass.sum();
  if (body.boundary.circular)
  {
    state.curvature = std::sqrt(M_PI / body.rest.area);
    state.compliance = plane_compliance(body);
  }
  const auto place = [&](const unsigned int i)
  {
    dealii::Point<2> x = body.field.place(i);
    for (unsigned int d = 0; d < 2; ++d)
      x[d] += body.nodes.displacement[2 * i + d];
    return x;
  };
  state.center = body.center();
  state.velocity = body.nodes.momentum() / state.mass;
  for (unsigned int i = 0; i < body.nodes.mass.size() && body.nodes.velocity.size() > 0; ++i)
  {
    const dealii::Tensor<1, 2> arm = place(i) - state.center;
    state.angular_momentum +=
        body.nodes.mass[i] * (arm[0] * body.nodes.velocity[2 * i + 1] - arm[1] * body.nodes.velocity[2 * i]);
  }
  for (unsigned int i = 0; i < 3; ++i)
    state.mean_stress.access_raw_entry(i) = stress_sum[i];
  if (state.area > 0.)
    state.mean_stress /= body.material.small_strain() ? stress_sum[3] : state.area;
  return state;
}

std::vector<std::array<double, 4>> MpmModel::stress_sums() const
{
  std::vector<std::array<double, 4>> sums(state.bodies.size());
  const auto add_up = [&](const Body<2> &body)
  {
    dealii::SymmetricTensor<2, 2> stress;
    double volume = 0.;
    for (unsigned int p = 0; p < body.points.size(); ++p)
    {
      // Kirchhoff stress per rest volume is Cauchy stress per current volume.
      const auto point = body.points[p];
      stress += point.rest_volume() * point.stress();
      volume += point.rest_volume();
    }
    for (unsigned int i = 0; i < 3; ++i)
      sums[body.index][i] = stress.access_raw_entry(i);
    sums[body.index][3] = volume;
  };
  work.share.together(
      [&]()
      {
        for (const Body<2> &body : state.bodies)
          if (work.share.mine(body.index))
            add_up(body);
      },
      [&](BodyShare::Message &message)
      {
        for (unsigned int b = 0; b < sums.size(); ++b)
          message.add(b, sums[b].data(), sums[b].size());
      });
  return sums;
}

Snapshot<2> MpmModel::snapshot() const
{
  Snapshot<2> snapshot;
  snapshot.time = state.time;
  snapshot.step = steps;
  snapshot.points = point_states();
  const std::vector<std::array<double, 4>> stress = stress_sums();
  for (const Body<2> &body : state.bodies)
  {
    if (body.rigid.wall != Row::none)
      continue; // a slab is shown as the wall it stands for
    snapshot.bodies.push_back(body_state(body, stress[body.index]));
  }
  snapshot.walls = walls();
  snapshot.obstacles = obstacles();
  snapshot.energies = energies();
  add_contacts(snapshot);
  return snapshot;
}

Snapshot<2> MpmModel::touching_state() const
{
  Snapshot<2> snapshot;
  snapshot.time = state.time;
  snapshot.step = steps;
  for (const Body<2> &body : state.bodies)
    if (body.rigid.wall == Row::none)
    {
      snapshot.bodies.emplace_back();
      snapshot.bodies.back().name = body.name;
      snapshot.bodies.back().center = body.center();
    }
  snapshot.walls = walls();
  snapshot.obstacles = obstacles();
  add_contacts(snapshot);
  return snapshot;
}

void MpmModel::add_contacts(Snapshot<2> &snapshot) const
{
  const std::optional<FoldedBodies<2>> cell = fold_bodies(snapshot);
  const auto &rows = work.contact.contact_rows();
  const unsigned int components = work.contact.n_components();
  // Rows count images from where bodies would be if none had ever been brought into the cell.
  const auto here = [&](PeriodicCell<2>::Image image, const unsigned int a, const unsigned int b)
  {
    for (unsigned int d = 0; d < 2; ++d)
      image[d] += (b == Row::none ? 0 : state.bodies[b].home[d]) - state.bodies[a].home[d];
    return image;
  };
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    if (!carries_force(work.contact, r) || last_dt == 0.)
      continue;
    ContactState<2> contact;
    contact.body_a = rows[r].body;
    if (rows[r].wall != Row::none)
      contact.wall = rows[r].wall;
    else
      contact.body_b = rows[r].partner;
    contact.place = rows[r].place;
    contact.normal = rows[r].normal;
    contact.length = rows[r].length;
    contact.gap = rows[r].gap;
    for (unsigned int c = 0; c < components; ++c)
      contact.force += work.contact.impulses()[r * components + c] / last_dt * direction_of(rows[r], c);
    if (cell)
      cell->fold(contact, here(rows[r].cell.fold, rows[r].body, Row::none),
                 here(rows[r].cell.image, rows[r].body, rows[r].partner));
    snapshot.contacts.push_back(contact);
  }
}

double MpmModel::unbalanced_walls() const
{
  return unbalanced(state.walls);
}

std::vector<WallState<2>> MpmModel::walls() const
{
  return states_of(state.walls);
}

std::vector<ObstacleState<2>> MpmModel::obstacles() const
{
  return states_of(state.obstacles);
}

double MpmModel::solid_area() const
{
  const auto told = work.share.numbers<1>(state.bodies, [](const Body<2> &body)
                                          { return std::array<double, 1>{outline_area(body)}; });
  double area = 0.;
  for (const Body<2> &body : state.bodies)
    if (body.rigid.wall == Row::none)
      area += body.rigid.driven ? outline_area(body) : told[body.index][0];
  return area;
}

double MpmModel::coordination() const
{
  TouchingPairs touching;
  const auto &rows = work.contact.contact_rows();
  for (unsigned int r = 0; r < rows.size(); ++r)
    if (carries_force(work.contact, r))
    {
      if (rows[r].wall != Row::none)
        touching.add_wall(rows[r].body, rows[r].wall);
      else if (rows[r].partner != rows[r].body)
        touching.add_bodies(rows[r].body, rows[r].partner);
    }
  return touching.coordination(problem.scene.bodies.size());
}

bool MpmModel::laws_limit_step() const
{
  return std::any_of(state.bodies.begin(), state.bodies.end(),
                     [](const Body<2> &body) { return body.material.law->limits_step(); });
}

double MpmModel::rotational_energy() const
{
  double energy = 0.;
  for (const Body<2> &body : state.bodies)
    if (!body.rigid.driven && body.nodes.velocity.size() > 0)
    {
      const Eigen::VectorXd r = whole_rotation(body);
      const double rate = r.dot(body.nodes.velocity);
      energy += 0.5 * rate * rate * rotary_inertia(body, r);
    }
  return energy;
}

std::vector<std::pair<std::string, double>> MpmModel::extra_history() const
{
  const Balance &balance = state.balance;
  const auto of_loss = [&](const std::string &name)
  { return std::pair<std::string, double>(name + "_J_per_m", balance.losses.of(name)); };
  std::vector<std::pair<std::string, double>> columns = {
      {"force_time_s", problem.settings.scheme.force_time(time(), last_dt)},
      {"plain_solves", work.contact.plain_solves},
      {"contact_loss_J_per_m", balance.contact_loss},
      {"rotational_energy_J_per_m", rotational_energy()},
      of_loss(loss::scheme),
      of_loss(loss::regularisation)};
  if (at_rest())
    columns.insert(columns.end(), {{"held_steps", held_steps}, of_loss(loss::released)});
  if (laws_limit_step())
    columns.emplace_back("law_cuts", law_cuts);
  if (problem.settings.meets_by_rays())
    columns.emplace_back("unbalanced_force", last_unbalanced);
  if (problem.scene.bodies.size() != 1)
    return columns;
  double lower = std::numeric_limits<double>::max(), upper = -lower;
  for (const auto &x : state.bodies[0].boundary.position)
  {
    lower = std::min(lower, x[0]);
    upper = std::max(upper, x[0]);
  }
  columns.insert(columns.begin(), {"width_m", upper - lower});
  return columns;
}
} // namespace softgrain::mpm
