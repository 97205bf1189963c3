// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/driving/wall_step.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/contact/contact_geometry_kind.h>
#include <softgrain/mpm/model/mpm_model.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/quasi_static.h>
#include <softgrain/mpm/stepping/safe_step.h>
#include <softgrain/mpm/stepping/stiffness.h>
#include <softgrain/mpm/stepping/stress.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
constexpr double touching = 1e-3; ///< gap up to which surfaces touch for adhesion [cells]
}

MpmModel::MpmModel(const Scene<2> &scene,
                   const Settings &settings,
                   std::vector<std::shared_ptr<const constitutive::Law<2>>> laws)
    : timer(std::make_unique<dealii::TimerOutput>(
          std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times))
{
  world.scene = scene;
  world.settings = settings;
  world.timer = timer.get();
  build(std::move(laws));
}

namespace
{
/// Steps that are looked at for 'Wall way' are not longer than this many CFL steps.
constexpr double longest_by_walls = 1e12;

/// What is best where a step does not resolve waves and inertia hardly holds what contacts do not, unless it
/// is given.
void choose_for_long_steps(Settings &settings)
{
  if (settings.theta == 0.)
    settings.scheme = TimeScheme::create(settings.scheme.name, 0.8);
  if (settings.contact_solver.algorithm == contact::Algorithm::automatic &&
      settings.coupling == ContactCoupling::condensed)
    settings.contact_solver.algorithm = contact::Algorithm::active_set;
}
} // namespace

MpmModel::~MpmModel() = default;

void MpmModel::build(std::vector<std::shared_ptr<const constitutive::Law<2>>> laws)
{
  const Settings &settings = world.settings;
  world.lattice = std::make_unique<Lattice<2>>(settings.mesh_lower, settings.mesh_upper, settings.cell_size);
  world.shape = create_shape_function(settings.shape);
  PointNeeds needs;
  needs.velocity = settings.scheme.inertia;
  needs.acceleration = settings.scheme.stored_acceleration;
  needs.affine = settings.affine_transfer;
  for (const auto &law : laws)
  {
    needs.volume = needs.volume || law->kinematics() == constitutive::Kinematics::small_strain;
    needs.n_history = std::max(needs.n_history, law->n_history());
  }
  world.points = std::make_unique<PointStore<2>>(*world.lattice, PointLayout<2>(needs));
  const BuildContext context{*world.lattice, *world.shape, settings, *world.points};
  std::vector<BodyDescription<2>> descriptions = world.scene.bodies;
  for (const BodyDescription<2> &body : descriptions)
    world.bodies.push_back(make_body(body, world.bodies.size(), laws[body.material],
                                     world.scene.materials[body.material].density, context));
  world.pairs = ContactPairs(world.scene);
  if (world.pairs.adhere())
    world.adhesion = Adhesion(world.scene.contact_law, touching * settings.cell_size);
  world.walls = make_walls(world.scene);
  world.obstacles = make_obstacles(world.scene);
  for (unsigned int w = 0; w < world.walls.size(); ++w)
    if (world.walls[w].description.type == WallDescription<2>::Type::material_points)
    {
      world.walls[w].body = world.bodies.size();
      descriptions.push_back(wall_slab(world.walls[w].description, context));
      world.bodies.push_back(make_body(descriptions.back(), world.walls[w].body, laws[0],
                                       world.scene.materials[0].density, context));
      world.bodies.back().wall = w;
    }
  world.sort_points();
  for (Body<2> &body : world.bodies)
    start_body(body, descriptions[body.index], context);
  if (settings.scheme.implicit)
  {
    world.matrices.resize(world.bodies.size());
    const bool condensed = settings.coupling == ContactCoupling::condensed &&
                           world.bodies.size() + world.scene.walls.size() + world.obstacles.size() > 1;
    for (const Body<2> &body : world.bodies)
    {
      world.solvers.emplace_back();
      if (body.driven)
        continue;
      lay_out_stiffness(body.field, world.matrices[body.index]);
      world.solvers.back() = std::make_unique<RankOneSolver>(
          create_linear_solver(settings.linear_solver, world.matrices[body.index], 2, condensed));
    }
  }
  if (settings.scheme.inertia && settings.rows_follow() && wanted_step() > 20.5 * cfl_step())
    choose_for_long_steps(world.settings);
  integrator = Registry<TimeIntegrator>::instance().create(settings.scheme.name);
  world.geometry = Registry<ContactGeometryKind>::instance()
                       .create(settings.contact_geometry)
                       ->create(*world.shape, settings);
  if (!settings.scheme.implicit && wanted_step() > cfl_step())
  {
    std::ostringstream message;
    message << "'Time/Time step' = " << settings.step.time_step
            << " s is not allowed with 'Time/Scheme' = 'explicit': it must be below the CFL step of "
            << cfl_step() << " s";
    throw InputError(message.str());
  }
  if (settings.scheme.stored_acceleration)
    for (Body<2> &body : world.bodies)
      if (!body.driven && external_force(body, world.scene.gravity, world.time, body.acceleration))
        for (unsigned int i = 0; i < body.mass.size(); ++i)
          for (unsigned int d = 0; d < 2; ++d)
          {
            // Bodies start without stress: their loads alone accelerate them.
            world.balance.carried_load[d] += body.acceleration[2 * i + d];
            body.acceleration[2 * i + d] /= body.mass[i];
          }
  world.balance.initial_momentum = momentum();
  initial_energy = energies().kinetic;
  update_momentum_scale();
}

double MpmModel::cfl_step() const
{
  double step = std::numeric_limits<double>::max();
  for (const Body<2> &body : world.bodies)
    if (!body.driven)
      step = std::min(step, world.lattice->cell_size() * std::sqrt(body.density / body.law->wave_modulus()));
  return step;
}

double MpmModel::wanted_step() const
{
  const Settings &settings = world.settings;
  if (settings.wall_way > 0.)
  {
    const double cfl = cfl_step(), longest = settings.step.wanted(longest_by_walls * cfl);
    const double way = settings.wall_way * world.lattice->cell_size();
    const double step = step_of_wall_way(world.walls, world.time, way, std::min(cfl, longest), longest);
    if (step > 0.)
      return std::min(step, longest);
  }
  // Symplectic Euler is stable to about one CFL step; half of it leaves room for compressed cells.
  return settings.step.wanted(
      (settings.scheme.implicit ? settings.cfl_multiple : std::min(settings.cfl_multiple, 0.5)) * cfl_step());
}

StepReport MpmModel::advance(const double dt_limit)
{
  if (!keeps_state_before_step())
    return try_steps(dt_limit);
  save(before_step);
  try
  {
    return try_steps(dt_limit);
  }
  catch (...)
  {
    load(before_step);
    throw;
  }
}

StepReport MpmModel::try_steps(const double dt_limit)
{
  StepReport report;
  const Settings &settings = world.settings;
  const double wanted = wanted_step();
  bool cut_by_law = false;
  const auto try_step = [&](const double dt) -> Attempt
  {
    const StepOutcome outcome = integrator->step(world, dt, wanted);
    report.newton_iterations += outcome.newton_iterations;
    report.contact_sweeps += outcome.contact_sweeps;
    law_cuts += outcome.law_asks;
    cut_by_law = cut_by_law || outcome.law_asks;
    if (!outcome.accepted)
      return {false, outcome.reason, true, outcome.share};
    report.newton_residual = outcome.newton_residual;
    report.contact_residual = outcome.contact_residual;
    report.max_penetration = outcome.max_penetration;
    held_steps += outcome.held_steps;
    if (outcome.held_steps > 0)
      settled_step = steps + 1;
    last_unbalanced = !settings.scheme.inertia         ? outcome.unbalanced
                      : settings.contact_on_boundaries ? unbalanced_force(world, dt)
                                                       : 0.;
    // A law that has just asked for this length would refuse a longer one.
    return {true, "",
            !cut_by_law && outcome.newton_iterations <= (1 + outcome.held_steps) * settings.max_newton / 2};
  };
  const double limit = safe_step(world, std::min(dt_limit, wanted));
  const StepTaken taken = step_control.advance(settings.step, wanted, limit, world.time, try_step);
  report.attempts = taken.attempts;
  report.dt = last_dt = taken.dt;
  ++steps;
  for (unsigned int r = 0; r < world.contact.contact_rows().size(); ++r)
    report.n_contacts += world.contact.carries_force(r);
  renew_grids();
  if (!world.settings.scheme.implicit && steps % 20 == 0)
    check_energy();
  update_momentum_scale();
  return report;
}

void MpmModel::settle(StepReport &report)
{
  // Explicit steps and those with inertia end where they should; what has been settled stays so.
  if (world.settings.scheme.inertia || settled_step == steps)
    return;
  settled_step = steps;
  StepOutcome outcome;
  try
  {
    outcome = integrator->settle(world, last_dt);
  }
  catch (...)
  {
    load(before_step);
    throw;
  }
  last_unbalanced = outcome.unbalanced;
  if (outcome.held_steps == 0)
    return;
  held_steps += outcome.held_steps;
  report.newton_iterations += outcome.newton_iterations;
  report.contact_sweeps += outcome.contact_sweeps;
  report.newton_residual = outcome.newton_residual;
  report.contact_residual = outcome.contact_residual;
  report.max_penetration = outcome.max_penetration;
  renew_grids();
}

void MpmModel::take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives)
{
  // Whoever holds a wall gives it the energy of its motion, and takes it.
  const double energy = softgrain::take_drives(world.walls, drives, world.time);
  if (world.settings.scheme.inertia)
    world.balance.wall_work += energy;
}

void MpmModel::check_energy() const
{
  // An unstable explicit step may settle again after a burst, with stresses that look right and are not.
  const Energies now = energies();
  const double scale = std::max({now.kinetic + now.elastic, std::abs(now.external_work), initial_energy});
  const double created = now.kinetic + now.elastic + now.dissipated - now.external_work - initial_energy;
  // The energy of a law is known to some rounding of its modulus.
  double rounding = 0.;
  for (const Body<2> &body : world.bodies)
    if (!body.driven)
      rounding += 100. * std::numeric_limits<double>::epsilon() * body.law->wave_modulus() * body.rest_area;
  if (created <= std::max(0.5 * scale, rounding))
    return;
  std::ostringstream message;
  message << "at time " << world.time << " s the bodies hold " << created
          << " J/m more than they were given: the explicit step of " << last_dt
          << " s is not stable; lower 'Time/CFL multiple', or raise 'Material points/Fill limit' so that no "
             "node has little mass";
  throw ComputationError(message.str());
}

void MpmModel::update_momentum_scale()
{
  // The sum over bodies, or over the nodes of a body that vibrates, may vanish while everything moves.
  double scale = 0.;
  for (const Body<2> &body : world.bodies)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < body.mass.size() && body.velocity.size() > 0 && !body.driven; ++i)
      sum += body.mass[i] * body.velocity.segment<2>(2 * i).norm();
    scale = std::max(scale, sum);
  }
  world.balance.note_momentum(scale);
}

void MpmModel::refresh_forces(Body<2> &body)
{
  StepState<2> &s = body.step;
  const auto n = body.points.size();
  s.grid_gradient.assign(n, dealii::Tensor<2, 2>({{1., 0.}, {0., 1.}}));
  s.gradient.resize(n);
  s.stress.resize(n);
  s.volume.resize(n);
  for (unsigned int p = 0; p < n; ++p)
  {
    const auto point = body.points[p];
    s.gradient[p] = point.gradient();
    s.stress[p] = point.stress();
    s.volume[p] = body.small_strain() ? point.volume() : point.rest_volume();
  }
  internal_force(body, body.internal_force);
}

void MpmModel::renew_grids()
{
  if (world.settings.grid_update == GridUpdate::never)
    return;
  dealii::TimerOutput::Scope section(*timer, "grid update");
  const BuildContext context{*world.lattice, *world.shape, world.settings, *world.points};
  // All are looked at before any changes, so that a body that has left the mesh ends the run with a good
  // state.
  std::vector<unsigned int> leaving;
  std::vector<std::vector<dealii::Point<2>>> places;
  for (Body<2> &body : world.bodies)
    if (world.settings.grid_update == GridUpdate::every_step ||
        grid_distortion(body) >= world.settings.distortion_limit)
    {
      world.bring_into_cell(body); // so that the mesh need not reach where it goes
      leaving.push_back(body.index);
      places.push_back(places_reached(body, *world.lattice));
    }
  if (leaving.empty())
    return;
  for (unsigned int i = 0; i < leaving.size(); ++i)
    leave_grid(world.bodies[leaving[i]], places[i], context);
  world.sort_points();
  for (const unsigned int b : leaving)
  {
    Body<2> &body = world.bodies[b];
    lay_grid(body, context);
    if (body.driven)
    {
      for (unsigned int i = 0; body.velocity.size() > 0 && i < body.field.n_independent(); ++i)
        for (unsigned int d = 0; d < 2; ++d)
          body.velocity[2 * i + d] = body.drive[d];
      continue;
    }
    refresh_forces(body);
    if (world.settings.scheme.implicit)
      lay_out_stiffness(body.field, world.matrices[body.index]);
  }
}
} // namespace softgrain::mpm
