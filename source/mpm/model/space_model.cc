// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/geometry/bisection.h>
#include <softgrain/geometry/rigid_surface.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/body/remembered_points.h>
#include <softgrain/mpm/body/solid_builder.h>
#include <softgrain/mpm/model/long_steps.h>
#include <softgrain/mpm/model/rank_report.h>
#include <softgrain/mpm/model/space_model.h>
#include <softgrain/mpm/stepping/explicit_space_step.h>
#include <softgrain/mpm/stepping/moving_step.h>
#include <softgrain/mpm/stepping/safe_step.h>
#include <softgrain/scene/motion_at_start.h>
#include <softgrain/scene/wall_drive.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
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
  needs.n_history = law.n_history();
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

/// What bodies press into a thin sheet could come out on its other side.
void check_thickness(const ObstacleDescription<3> &obstacle, const double cell_size)
{
  if (obstacle.surface->thickness() >= cell_size)
    return;
  std::ostringstream text;
  text << "'Obstacles/" << obstacle.name << "/Thickness' = '" << obstacle.surface->thickness()
       << "' is not allowed: it must be at least 'Mesh/Cell size', which is " << cell_size << " m";
  throw InputError(text.str());
}

/// In a step of @p dt from @p time on, along the normal or the tangent [m/s].
double fastest_of(Wall<3> wall, const double time, const double dt)
{
  plan(wall, time, dt);
  return std::max(std::abs(wall.speed), std::abs(wall.slide_speed));
}
} // namespace

SpaceModel::SpaceModel(const Scene<3> &scene, const Settings &settings, const Laws &laws)
    : settings(settings)
    , function(create_shape_function(settings.shape))
    , lattice(settings.space_lower, settings.space_upper, settings.cell_size)
    , subgrid{settings.subgrid_compliance(), settings.cell_size, settings.space_lower}
    , pairs(scene)
    , loads(scene.loads)
    , moved_by_more(moved_by_more_than_walls(scene))
    , frictionless(pairs.frictionless() && !rough(scene.obstacles))
    , timer(std::make_unique<dealii::TimerOutput>(
          std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times))
{
  for (const BodyDescription<3> &description : scene.bodies)
    add_body(description, laws[description.material], scene.materials[description.material].density);
  work.timer = timer.get();
  share_out_bodies();
  work.reinit(state.bodies, settings.linear_solver, settings.scheme.solves_equations());
  driven = make_walls(scene);
  for (const WallDescription<3> &wall : scene.walls)
    wall_names.push_back(wall.name);
  state.wall_force.resize(driven.size());
  state.loaded.resize(driven.size());
  state.obstacles = make_obstacles(scene);
  for (const Obstacle<3> &obstacle : state.obstacles)
    check_thickness(obstacle.description, settings.cell_size);
  choose_for_long_steps(wanted_step(), cfl_step(), this->settings);
  this->settings.scheme.check_step(wanted_step(), cfl_step());
  state.motion.impulse = momentum();
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
  body.loads = loads;
  if (loads.look_at_points())
    body.rest.position.resize(body.points.size());
  for (std::size_t p = 0; p < body.rest.position.size(); ++p)
    body.rest.position[body.points.number(p)] = body.points[p].position();
  body.boundary.grid_position = body.boundary.position = surface.vertices;
  body.boundary.circular = shape.round();
  start(description, body);
  state.bodies.push_back(std::move(body));
  state.surfaces.emplace_back(description.shape, surface.triangles);
}

void SpaceModel::share_out_bodies()
{
  if (work.share.alone())
    return;
  std::vector<dealii::Point<3>> centers;
  std::vector<double> weights;
  for (const Body<3> &body : state.bodies)
  {
    centers.push_back(body.center());
    // Factors of a band.
    weights.push_back(std::pow(body.field.n_independent(), 7. / 3.));
  }
  std::vector<unsigned int> owners = bisect(centers, weights, work.share.exchange.number());
  work.share.give(std::move(owners), std::vector<char>(state.bodies.size(), 1));
}

void SpaceModel::start(const BodyDescription<3> &description, Body<3> &body) const
{
  if (at_rest())
    return;
  // Formulas are taken at the nodes, so that affine motions are exact.
  const std::vector<Expression> formulas = vector_expression(description.velocity, {"x", "y", "z"}, 3);
  body.nodes.velocity = Eigen::VectorXd::Zero(body.field.n_dofs());
  for (unsigned int i = 0; i < body.field.n_independent(); ++i)
  {
    const dealii::Point<3> x = body.field.place(i);
    for (unsigned int d = 0; d < 3; ++d)
      body.nodes.velocity[3 * i + d] = formulas[d]({x[0], x[1], x[2]});
  }
}

double SpaceModel::cfl_step() const
{
  double step = std::numeric_limits<double>::max();
  for (const Body<3> &body : state.bodies)
    step = std::min(step, settings.cell_size *
                              std::sqrt(body.material.density / body.material.law->wave_modulus()));
  return step;
}

double SpaceModel::wanted_step() const
{
  constexpr double longest = std::numeric_limits<double>::max();
  const double told = settings.step.wanted(longest);
  double by_walls = longest;
  if (settings.wall_way > 0.)
    for (const Wall<3> &wall : driven)
    {
      // A formula may start at rest: its mean over a step that is not too long counts.
      const double dt = std::min(told, at_rest() ? 1e3 * settings.cell_size : cfl_step()),
                   speed = fastest_of(wall, state.time, dt);
      if (speed > 0.)
        by_walls = std::min(by_walls, settings.wall_way * settings.cell_size / speed);
    }
  if (settings.wall_way > 0. && at_rest())
    if (const double speed = fastest_obstacle(std::min(told, 1e3 * settings.cell_size)); speed > 0.)
      by_walls = std::min(by_walls, settings.wall_way * settings.cell_size / speed);
  const double by_waves =
      settings.step.wanted(settings.scheme.cfl_multiple(settings.cfl_multiple) * cfl_step());
  if (!at_rest() && (by_walls == longest || (settings.chosen_way && moved_by_more)))
    return std::min(by_waves, by_walls);
  return std::min(told, by_walls);
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

Attempt
SpaceModel::try_step(const double dt, const double wanted, const std::size_t cuts_before, StepReport &report)
{
  const SpaceMotion planned = motion(dt);
  const StepOutcome outcome = at_rest() ? SpaceAtRest(state, scene(), planned).go(dt, wanted)
                              : settings.scheme.solves_equations()
                                  ? moving_step(state, scene(), planned, dt)
                                  : explicit_space_step(state, scene(), planned, dt);
  note(outcome, report);
  state.law_cuts += outcome.law_asks;
  if (!outcome.accepted)
    return {false, outcome.reason, true, outcome.share};
  book(planned, dt);
  // A law that has asked for this length in this step would refuse a longer one.
  return {true, "", cuts_before == state.law_cuts && outcome.newton_iterations <= settings.max_newton / 2};
}

void SpaceModel::keep_before()
{
  before_step = {{}, state, last_dt, driven, steps};
  for (const Body<3> &body : state.bodies)
    before_step.displacement.push_back(body.nodes.displacement);
  before_step.points = remembered_by_points(state.bodies);
}

void SpaceModel::go_back()
{
  for (Body<3> &body : state.bodies)
  {
    body.nodes.displacement = before_step.displacement[body.index];
    move_boundary(body);
  }
  take_points(before_step.points, state.bodies);
  static_cast<SpaceProgress &>(state) = before_step.progress;
  last_dt = before_step.last_dt;
  driven = before_step.driven;
  steps = before_step.steps;
}

StepReport SpaceModel::advance(const double dt_limit)
{
  StepReport report;
  const double wanted = std::min(wanted_step(), dt_limit);
  const std::size_t law_cuts = state.law_cuts;
  SafeStep safe;
  if (at_rest())
    keep_before();
  else if (const double limit = safe_step_in_space(state.bodies, state.obstacles, state.time, wanted);
           limit < wanted)
  {
    safe.dt = limit;
    safe.shortest = settings.step.smallest_step * std::min(wanted, settings.cfl_multiple * cfl_step());
    safe.cause = [] { return "bodies move too fast to be seen on their ways"; };
  }
  bool cut = false;
  const StepTaken taken = step_control.advance(
      settings.step, wanted, dt_limit, state.time,
      [&](const double dt)
      {
        stop_if_interrupted();
        Attempt done = try_step(dt, wanted, law_cuts, report);
        // What has just been too long without inertia often is again.
        done.may_grow = done.may_grow && !(at_rest() && cut);
        cut = cut || !done.accepted;
        return done;
      },
      safe);
  report.dt = last_dt = taken.dt;
  report.attempts = taken.attempts;
  report.n_contacts = state.contacts.size();
  state.time += taken.dt;
  ++steps;
  check_ranks_agree(work.share, state.bodies, report);
  return report;
}

void SpaceModel::settle(StepReport &report)
{
  if (last_dt == 0. || !at_rest())
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
    outcome = SpaceAtRest(state, scene(), motion(0.)).settle(last_dt);
  }
  catch (...)
  {
    go_back();
    throw;
  }
  follow_step();
  if (outcome.held_steps > 0)
  {
    note(outcome, report);
    state.losses.released += before - not_booked();
  }
  for (std::size_t w = 0; w < driven.size(); ++w)
    driven[w].book.force = dealii::Tensor<1, 3>() - state.wall_force[w];
  report.n_contacts = state.contacts.size();
}
} // namespace softgrain::mpm
