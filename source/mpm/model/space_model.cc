// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/wall_position.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/mpm/body/solid_builder.h>
#include <softgrain/mpm/model/space_model.h>
#include <softgrain/mpm/stepping/driven_work.h>
#include <softgrain/mpm/stepping/stress.h>
#include <softgrain/scene/wall_drive.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <set>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
/// Distance of the places of a surface where contact is looked for.
constexpr double spacing_of_samples = 0.5; ///< [cells]

PointNeeds needs_of(const constitutive::Law<3> &law)
{
  PointNeeds needs;
  needs.velocity = false;
  needs.volume = law.kinematics() == constitutive::Kinematics::small_strain;
  return needs;
}

/// The part of a lattice around a shape, a cell wider.
Lattice<3> part_around(const Shape<3> &shape, const Lattice<3> &lattice)
{
  const double h = lattice.cell_size();
  auto [lower, upper] = shape.bounding_box();
  for (unsigned int d = 0; d < 3; ++d)
  {
    lower[d] = lattice.lower()[d] + h * (std::floor((lower[d] - lattice.lower()[d]) / h) - 1.);
    upper[d] = lattice.lower()[d] + h * (std::ceil((upper[d] - lattice.lower()[d]) / h) + 1.);
  }
  return {lower, upper, h};
}

/// A place of the surface in every cell that it goes through, so that the field is known on all of it.
std::vector<dealii::Point<3>> places_in_cells(const Shape<3> &shape, const Lattice<3> &lattice)
{
  std::vector<dealii::Point<3>> places;
  const double h = lattice.cell_size();
  const Lattice<3>::Index n = lattice.n_cells();
  for (int i = 0; i < n[0]; ++i)
    for (int j = 0; j < n[1]; ++j)
      for (int k = 0; k < n[2]; ++k)
      {
        const dealii::Point<3> lower =
            lattice.lower() + h * dealii::Tensor<1, 3>({double(i), double(j), double(k)});
        if (const auto place = shape.surface_in_box(lower, lower + dealii::Tensor<1, 3>({h, h, h})))
          places.push_back(*place);
      }
  return places;
}
} // namespace

SpaceModel::SpaceModel(const Scene<3> &scene, const Settings &settings, const Laws &laws)
    : settings(settings)
    , function(create_shape_function(settings.shape))
    , lattice(settings.space_lower, settings.space_upper, settings.cell_size)
    , subgrid{settings.subgrid, settings.cell_size, settings.space_lower}
    , pairs(scene)
    , timer(std::make_unique<dealii::TimerOutput>(
          std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times))
{
  for (const BodyDescription<3> &description : scene.bodies)
    add_body(description, laws[description.material], scene.materials[description.material].density);
  work.timer = timer.get();
  work.reinit(state.bodies, settings.linear_solver);
  for (const WallDescription<3> &wall : scene.walls)
  {
    driven.emplace_back();
    driven.back().description = wall;
    wall_names.push_back(wall.name);
  }
  state.wall_force.assign(driven.size(), 0.);
}

void SpaceModel::add_body(const BodyDescription<3> &description,
                          const std::shared_ptr<const constitutive::Law<3>> &law,
                          const double density)
{
  const Shape<3> &shape = *description.shape;
  const TriangulatedSurface surface = shape.surface(spacing_of_samples * settings.cell_size);
  grounds.push_back(std::make_unique<Ground>(part_around(shape, lattice), PointLayout<3>(needs_of(*law))));
  Ground &ground = *grounds.back();
  std::vector<dealii::Point<3>> markers = surface.vertices;
  try
  {
    for (const dealii::Point<3> &x : markers)
      lattice.check_inside(x, "surface");
  }
  catch (const ComputationError &error)
  {
    throw InputError("'Bodies/" + description.name + "': " + error.what());
  }
  const std::vector<dealii::Point<3>> more = places_in_cells(shape, ground.lattice);
  markers.insert(markers.end(), more.begin(), more.end());
  Body<3> body = make_solid(description.name, shape, law, density, settings, *function, ground.lattice,
                            markers, ground.store);
  body.index = state.bodies.size();
  body.boundary.grid_position = body.boundary.position = surface.vertices;
  body.boundary.circular = true;
  state.bodies.push_back(std::move(body));
  const std::vector<double> numbers = shape.numbers(); // of a ball, the only shape there is
  state.surfaces.emplace_back(dealii::Point<3>(numbers[0], numbers[1], numbers[2]), numbers[3],
                              surface.triangles);
}

double SpaceModel::DrivenWall::velocity(const double time, const double dt) const
{
  return description.drive->demand({time - drive_begin, dt, travel - travel_before}).velocity;
}

void SpaceModel::take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives)
{
  for (std::size_t w = 0; w < driven.size(); ++w)
    if (drives[w])
    {
      driven[w].description.drive = drives[w];
      driven[w].drive_begin = state.time;
      driven[w].travel_before = driven[w].travel;
    }
}

double SpaceModel::wanted_step() const
{
  double wanted = settings.step.time_step > 0. ? settings.step.time_step : std::numeric_limits<double>::max();
  if (settings.wall_way > 0.)
    for (const DrivenWall &wall : driven)
    {
      // A formula may start at rest: its mean over a step that is not too long counts.
      const double dt = std::min(wanted, 1e3 * settings.cell_size),
                   speed = std::abs(wall.velocity(state.time, dt));
      if (speed > 0.)
        wanted = std::min(wanted, settings.wall_way * settings.cell_size / speed);
    }
  return wanted;
}

std::vector<WallMotion<3>> SpaceModel::motion() const
{
  std::vector<WallMotion<3>> walls;
  for (const DrivenWall &wall : driven)
    walls.push_back({wall.point(), wall.description.normal, 0.});
  return walls;
}

void SpaceModel::note(const StepOutcome &outcome, StepReport &report) const
{
  report.newton_iterations += outcome.newton_iterations;
  report.contact_sweeps += outcome.contact_sweeps;
  if (!outcome.accepted)
    return;
  report.newton_residual = outcome.newton_residual;
  report.contact_residual = outcome.max_penetration / settings.cell_size;
  report.max_penetration = outcome.max_penetration;
}

Attempt SpaceModel::try_step(const double dt, const double wanted, StepReport &report)
{
  std::vector<WallMotion<3>> walls = motion();
  for (std::size_t w = 0; w < walls.size(); ++w)
    walls[w].velocity = driven[w].velocity(state.time, dt);
  const StepOutcome outcome =
      SpaceAtRest(state, work, settings, subgrid, pairs, walls, wall_names).go(dt, wanted);
  note(outcome, report);
  if (!outcome.accepted)
    return {false, outcome.reason, true, outcome.share};
  std::vector<DrivenWork> works;
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    DrivenWall &wall = driven[w];
    wall.speed = walls[w].velocity;
    wall.travel += dt * wall.speed;
    wall.work += 0.5 * (wall.force + state.wall_force[w]) * dt * wall.speed;
    works.push_back({&wall.work, 0.5 * std::abs((state.wall_force[w] - wall.force) * dt * wall.speed)});
    wall.force = state.wall_force[w];
  }
  state.rubbed += give_kinks(state.kinks, works) * state.kinks.of_slides;
  return {true, "", outcome.newton_iterations <= settings.max_newton / 2};
}

void SpaceModel::keep_before()
{
  before_step = {{}, state, last_dt, driven, steps};
  for (const Body<3> &body : state.bodies)
    before_step.displacement.push_back(body.displacement);
}

void SpaceModel::go_back()
{
  for (Body<3> &body : state.bodies)
  {
    body.displacement = before_step.displacement[body.index];
    move_markers(body);
  }
  static_cast<SpaceProgress &>(state) = before_step.progress;
  last_dt = before_step.last_dt;
  driven = before_step.driven;
  steps = before_step.steps;
}

StepReport SpaceModel::advance(const double dt_limit)
{
  StepReport report;
  keep_before();
  const double wanted = std::min(wanted_step(), dt_limit);
  const StepTaken taken = step_control.advance(settings.step, wanted, dt_limit, state.time,
                                               [&](const double dt)
                                               {
                                                 stop_if_interrupted();
                                                 return try_step(dt, wanted, report);
                                               });
  report.dt = last_dt = taken.dt;
  report.attempts = taken.attempts;
  report.n_contacts = state.contacts.size();
  state.time += taken.dt;
  ++steps;
  return report;
}

void SpaceModel::settle(StepReport &report)
{
  if (last_dt == 0.)
    return;
  const auto not_booked = [this]()
  {
    const Energies now = energies();
    return now.elastic + now.dissipated - now.external_work;
  };
  const double before = not_booked();
  StepOutcome outcome;
  try
  {
    outcome = SpaceAtRest(state, work, settings, subgrid, pairs, motion(), wall_names).settle(last_dt);
  }
  catch (...)
  {
    go_back();
    throw;
  }
  note(outcome, report);
  if (outcome.held_steps > 0)
    state.released_energy += before - not_booked();
  for (std::size_t w = 0; w < driven.size(); ++w)
    driven[w].force = state.wall_force[w];
  report.n_contacts = state.contacts.size();
}

std::vector<WallState<3>> SpaceModel::walls() const
{
  std::vector<WallState<3>> states;
  for (const DrivenWall &wall : driven)
  {
    WallState<3> state;
    state.name = wall.description.name;
    state.point = wall.point();
    state.normal = wall.description.normal;
    state.position = wall_position(state.point, state.normal);
    state.velocity = wall.speed;
    state.normal_force = wall.force;
    states.push_back(state);
  }
  return states;
}

Energies SpaceModel::energies() const
{
  Energies energies;
  energies.elastic = state.dent_energy;
  for (const Body<3> &body : state.bodies)
    energies.elastic +=
        measure_points(body, body.displacement, Eigen::VectorXd::Zero(body.displacement.size())).energy;
  energies.dissipated = state.regularisation_work + state.released_energy + state.rubbed;
  for (const DrivenWall &wall : driven)
    energies.external_work += wall.work;
  return energies;
}

double SpaceModel::energy_of_rounding() const
{
  double sum = 0.;
  for (const Body<3> &body : state.bodies)
    sum += 1e-12 * body.law->young_modulus() * body.rest_area;
  return sum;
}

StepState<3> SpaceModel::stress_of(const Body<3> &body) const
{
  StepState<3> stress;
  Trial asked;
  asked.tangent = false;
  evaluate_stress(body, body.displacement, Eigen::VectorXd::Zero(body.displacement.size()), asked, stress);
  return stress;
}

double SpaceModel::solid_area() const
{
  double volume = 0.;
  for (const Body<3> &body : state.bodies)
  {
    const StepState<3> stress = stress_of(body);
    for (unsigned int p = 0; p < body.points.size(); ++p)
      volume += body.points[p].rest_volume() * determinant(stress.gradient[p]);
  }
  return volume;
}

double SpaceModel::coordination() const
{
  // Partners and walls, once each.
  std::set<std::array<unsigned int, 3>> pairs;
  for (const SpaceContact &contact : state.contacts)
  {
    pairs.insert({{contact.body, contact.partner, contact.wall}});
    if (contact.partner != ContactFrame<3>::none)
      pairs.insert({{contact.partner, contact.body, contact.wall}});
  }
  return static_cast<double>(pairs.size()) / state.bodies.size();
}

std::size_t SpaceModel::n_points() const
{
  std::size_t n = 0;
  for (const Body<3> &body : state.bodies)
    n += body.n_points;
  return n;
}

SizeReport SpaceModel::size_report() const
{
  std::ostringstream cells;
  cells << settings.cell_size << " m";
  std::size_t nodes = 0;
  for (const Body<3> &body : state.bodies)
    nodes += body.field.n_independent();
  return {{"bodies", std::to_string(state.bodies.size())},
          {"cell size", cells.str()},
          {"material points", std::to_string(n_points())},
          {"nodes", std::to_string(nodes)}};
}

std::vector<std::pair<std::string, double>> SpaceModel::works() const
{
  std::vector<std::pair<std::string, double>> columns;
  for (const DrivenWall &wall : driven)
    columns.emplace_back(wall.description.name + "_work_J", wall.work);
  return columns;
}

std::map<std::string, double> SpaceModel::phases() const
{
  return timer->get_summary_data(dealii::TimerOutput::total_wall_time);
}
} // namespace softgrain::mpm
