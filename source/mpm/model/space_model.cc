// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/wall_position.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/model/state_file.h>
#include <softgrain/mpm/model/space_model.h>
#include <softgrain/mpm/stepping/stress.h>
#include <softgrain/scene/wall_drive.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
/// Distance of the places that meet walls: there are about as many of them as the field has shapes for.
constexpr double spacing_of_places = 0.7; ///< [cells]

PointNeeds needs_of(const constitutive::Law<3> &law)
{
  PointNeeds needs;
  needs.velocity = false;
  needs.volume = law.kinematics() == constitutive::Kinematics::small_strain;
  return needs;
}

std::vector<std::vector<dealii::Point<3>>> places_for(const Scene<3> &scene, const double cell_size)
{
  std::vector<std::vector<dealii::Point<3>>> places;
  for (const WallDescription<3> &wall : scene.walls)
    places.push_back(scene.bodies.front().shape->places_facing(wall.normal, spacing_of_places * cell_size));
  return places;
}

/// All places where the field must be known.
std::vector<dealii::Point<3>> markers(const TriangulatedSurface &surface,
                                      const std::vector<std::vector<dealii::Point<3>>> &places)
{
  std::vector<dealii::Point<3>> all = surface.vertices;
  for (const auto &of_wall : places)
    all.insert(all.end(), of_wall.begin(), of_wall.end());
  return all;
}

PointStore<3> &covered(PointStore<3> &store)
{
  store.cover_all();
  return store;
}
} // namespace

SpaceModel::SpaceModel(const Scene<3> &scene,
                       const Settings &settings,
                       std::shared_ptr<const constitutive::Law<3>> law)
    : settings(settings)
    , description(scene.bodies.front())
    , function(create_shape_function(settings.shape))
    , lattice(settings.space_lower, settings.space_upper, settings.cell_size)
    , surface(description.shape->surface(spacing_of_places * settings.cell_size))
    , places(places_for(scene, settings.cell_size))
    , store(lattice, PointLayout<3>(needs_of(*law)))
    , body(make_solid(description.name,
                      *description.shape,
                      std::move(law),
                      scene.materials[description.material].density,
                      this->settings,
                      *function,
                      lattice,
                      markers(surface, places),
                      covered(store)))
    , pressed(body, places, this->settings, settings.cell_size)
{
  for (const WallDescription<3> &wall : scene.walls)
  {
    driven.emplace_back();
    driven.back().description = wall;
  }
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
      driven[w].drive_begin = now;
      driven[w].travel_before = driven[w].travel;
    }
}

PressedBody<3>::FlatWall SpaceModel::flat(const DrivenWall &wall) const
{
  Pressed::FlatWall result{wall.point(), wall.description.normal, HertzDent()};
  const double nu = body.law->poisson_ratio();
  if (settings.subgrid)
    result.dent =
        HertzDent(body.law->young_modulus() / (1. - nu * nu),
                  description.shape->radius_of_curvature(-wall.description.normal), settings.cell_size);
  return result;
}

double SpaceModel::wanted_step() const
{
  double wanted = settings.step.time_step > 0. ? settings.step.time_step : std::numeric_limits<double>::max();
  if (settings.wall_way > 0.)
    for (const DrivenWall &wall : driven)
    {
      // A formula may start at rest: its mean over a step that is not too long counts.
      const double dt = std::min(wanted, 1e3 * settings.cell_size), speed = std::abs(wall.velocity(now, dt));
      if (speed > 0.)
        wanted = std::min(wanted, settings.wall_way * settings.cell_size / speed);
    }
  return wanted;
}

std::string SpaceModel::try_step(const double dt, StepReport &report)
{
  std::vector<DrivenWall> moved = driven;
  std::vector<Pressed::FlatWall> walls;
  for (DrivenWall &wall : moved)
  {
    wall.speed = wall.velocity(now, dt);
    wall.travel += dt * wall.speed;
    walls.push_back(flat(wall));
  }
  const Pressed::Outcome outcome = pressed.balance(walls);
  report.newton_iterations += outcome.iterations;
  report.contact_sweeps += outcome.passes;
  if (!outcome.trouble.empty())
    return outcome.trouble;
  report.newton_residual = outcome.residual;
  report.contact_residual = outcome.deepest / settings.cell_size;
  report.max_penetration = outcome.deepest;
  report.n_contacts = 0;
  for (std::size_t w = 0; w < moved.size(); ++w)
  {
    const double force = pressed.total_force(w);
    moved[w].work += 0.5 * (moved[w].force + force) * dt * moved[w].speed;
    moved[w].force = force;
    report.n_contacts += std::count_if(pressed.forces(w).begin(), pressed.forces(w).end(),
                                       [](const double P) { return P > 0.; });
  }
  driven = std::move(moved);
  return "";
}

StepReport SpaceModel::advance(const double dt_limit)
{
  const auto begin = std::chrono::steady_clock::now();
  StepReport report;
  const StepTaken taken =
      step_control.advance(settings.step, std::min(wanted_step(), dt_limit), dt_limit, now,
                           [&](const double dt)
                           {
                             stop_if_interrupted();
                             const std::string trouble = try_step(dt, report);
                             return Attempt{trouble.empty(), trouble};
                           });
  report.dt = taken.dt;
  report.attempts = taken.attempts;
  now += taken.dt;
  ++steps;
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
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
  energies.elastic =
      measure_points(body, body.displacement, Eigen::VectorXd::Zero(body.displacement.size())).energy;
  for (const DrivenWall &wall : driven)
  {
    energies.elastic += flat(wall).dent.energy(wall.force);
    energies.external_work += wall.work;
  }
  return energies;
}

double SpaceModel::energy_of_rounding() const
{
  return 1e-12 * body.law->young_modulus() * body.rest_area;
}

double SpaceModel::solid_area() const
{
  double volume = 0.;
  for (unsigned int p = 0; p < body.points.size(); ++p)
    volume += body.points[p].rest_volume() * determinant(pressed.points().gradient[p]);
  return volume;
}

double SpaceModel::coordination() const
{
  return std::count_if(driven.begin(), driven.end(), [](const DrivenWall &wall) { return wall.force > 0.; });
}

std::size_t SpaceModel::n_places() const
{
  std::size_t n = 0;
  for (const auto &of_wall : places)
    n += of_wall.size();
  return n;
}

SizeReport SpaceModel::size_report() const
{
  std::ostringstream cells;
  cells << settings.cell_size << " m";
  return {{"bodies", "1"},
          {"cell size", cells.str()},
          {"material points", std::to_string(body.n_points)},
          {"nodes", std::to_string(body.field.n_independent())},
          {"places that may meet walls", std::to_string(n_places())}};
}

std::vector<std::pair<std::string, double>> SpaceModel::works() const
{
  std::vector<std::pair<std::string, double>> columns;
  for (const DrivenWall &wall : driven)
    columns.emplace_back(wall.description.name + "_work_J", wall.work);
  return columns;
}

void SpaceModel::save(StateWriter &out) const
{
  out.write("space/time", std::vector<double>{now, step_control.scale, seconds});
  out.write("space/steps", std::vector<std::uint64_t>{steps});
  out.write("space/displacement", std::vector<double>(body.displacement.data(),
                                                      body.displacement.data() + body.displacement.size()));
  std::vector<double> walls, forces;
  for (std::size_t w = 0; w < driven.size(); ++w)
  {
    walls.insert(walls.end(), {driven[w].travel, driven[w].speed, driven[w].work, driven[w].force,
                               driven[w].drive_begin, driven[w].travel_before});
    forces.insert(forces.end(), pressed.forces(w).begin(), pressed.forces(w).end());
  }
  out.write("space/walls", walls);
  out.write("space/forces", forces);
}

void SpaceModel::load(StateReader &in)
{
  const std::vector<double> times = in.read_doubles("space/time", 3);
  const std::vector<double> nodes = in.read_doubles("space/displacement", body.displacement.size());
  const std::vector<double> walls = in.read_doubles("space/walls", 6 * driven.size());
  const std::vector<double> forces = in.read_doubles("space/forces", n_places());
  std::vector<std::vector<double>> of_walls;
  std::size_t first = 0;
  for (const auto &of_wall : places)
  {
    of_walls.emplace_back(forces.begin() + first, forces.begin() + first + of_wall.size());
    first += of_wall.size();
  }
  if (const std::string trouble =
          pressed.take(Eigen::Map<const Eigen::VectorXd>(nodes.data(), nodes.size()), of_walls);
      !trouble.empty())
    in.refuse("space/displacement", trouble);
  now = times[0];
  step_control.scale = times[1];
  seconds = times[2];
  steps = in.read_integers("space/steps", 1)[0];
  for (std::size_t w = 0; w < driven.size(); ++w)
  {
    driven[w].travel = walls[6 * w];
    driven[w].speed = walls[6 * w + 1];
    driven[w].work = walls[6 * w + 2];
    driven[w].force = walls[6 * w + 3];
    driven[w].drive_begin = walls[6 * w + 4];
    driven[w].travel_before = walls[6 * w + 5];
  }
}
} // namespace softgrain::mpm
