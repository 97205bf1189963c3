// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/bpm/aggregate.h>
#include <softgrain/bpm/bpm_model.h>
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/scene/loads_over_step.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <sstream>

namespace softgrain::bpm
{
namespace
{
std::string text(const double value, const std::string &unit)
{
  std::ostringstream s;
  s.precision(4);
  s << value << unit;
  return s.str();
}

/// Share of the damping that is chosen for a wall under a pressure. Contacts of rigid disks stop it from
/// swinging anyway, and while a packing is sheared all of it would hold up some percent of the pressure.
constexpr double share_of_damping = 0.2;

/// What a step changes of an obstacle; formulas are dear to copy.
struct Felt
{
  Pose<2> now;
  ObstacleMotion<2> way;
  dealii::Tensor<1, 2> force;
  double torque, work;
  FreeObstacle own;
};

std::vector<Felt> felt_by(const std::vector<Obstacle<2>> &obstacles)
{
  std::vector<Felt> felt;
  for (const Obstacle<2> &one : obstacles)
    felt.push_back({one.now, one.way, one.force, one.torque, one.work, one.own});
  return felt;
}

void put_back(const std::vector<Felt> &felt, std::vector<Obstacle<2>> &obstacles)
{
  for (std::size_t o = 0; o < obstacles.size(); ++o)
  {
    obstacles[o].now = felt[o].now;
    obstacles[o].way = felt[o].way;
    obstacles[o].force = felt[o].force;
    obstacles[o].torque = felt[o].torque;
    obstacles[o].work = felt[o].work;
    obstacles[o].own = felt[o].own;
  }
}
} // namespace

BpmModel::~BpmModel() = default;

void BpmModel::drive_walls(const double dt)
{
  for (Obstacle<2> &obstacle : moving_obstacles)
    obstacle.plan(now, dt);
  for (std::size_t w = 0; w < moving_walls.size(); ++w)
  {
    Wall<2> &wall = moving_walls[w];
    if (!is_free(wall, Freedom::along))
      wall.slide_speed = demanded_slide(wall, now, dt);
    // A place that is asked for has a mean velocity in a step, none in a moment: that of the first step.
    wall.speed = expected_rates(wall, now, dt > 0. ? dt : wanted_step()).speed;
    for (const Freedom direction : freedoms_of(wall))
      put_stress(moving_walls, w, direction, now, dt, share_of_damping);
  }
}

void BpmModel::accelerate(const double dt)
{
  if (load_names.empty())
    return;
  const std::size_t n = dynamics->disks().size();
  acceleration.resize(n);
  of_loads.resize(load_names.size() - 1);
  for (auto &of_load : of_loads)
    of_load.resize(n);
  std::vector<const Load<2> *> loads;
  for (const auto &load : scene.loads)
    loads.push_back(load.get());
  std::vector<dealii::Tensor<1, 2>> means;
  // Loads that are the same everywhere are asked once.
  const bool everywhere = !is_loaded && !scene.loads.see_velocity();
  for (std::size_t i = 0; i < (everywhere ? std::min<std::size_t>(n, 1) : n); ++i)
  {
    ask_loads(i, dt, loads, means);
    accelerate(i, means);
  }
  if (!everywhere || n == 0)
    return;
  std::fill(acceleration.begin(), acceleration.end(), acceleration[0]);
  for (auto &of_load : of_loads)
    std::fill(of_load.begin(), of_load.end(), of_load[0]);
}

void BpmModel::ask_loads(const std::size_t i,
                         const double dt,
                         std::vector<const Load<2> *> &loads,
                         std::vector<dealii::Tensor<1, 2>> &means) const
{
  const Primaries &disks = dynamics->disks();
  const std::array<double, 2> &x = disks.position[i], &v = disks.velocity[i];
  LoadPlace<2> place{{x[0], x[1]}, {x[0], x[1]}, dealii::Tensor<1, 2>({v[0], v[1]}), now};
  if (is_loaded)
    place.at_rest = dealii::Point<2>(disks.start[i][0], disks.start[i][1]);
  loads.resize(scene.loads.size());
  if (const auto &own = own_load[disks.body[i]])
    loads.push_back(own.get());
  mean_accelerations(loads, place, dt, means);
}

void BpmModel::accelerate(const std::size_t i, const std::vector<dealii::Tensor<1, 2>> &means)
{
  acceleration[i] = {0., 0.};
  for (std::size_t number = 0; number < means.size(); ++number)
  {
    const dealii::Tensor<1, 2> &pull = means[number];
    for (unsigned int d = 0; d < 2; ++d)
      acceleration[i][d] += pull[d];
    if (number < of_loads.size())
      of_loads[number][i] = {pull[0], pull[1]};
  }
}

double BpmModel::wanted_step() const
{
  return settings.step.wanted(settings.step_fraction * natural_time);
}

std::string BpmModel::cause_of_no_solution() const
{
  // Sweeps carry the weight of a body through lighter ones in about as many steps as their masses differ.
  constexpr double too_much = 1e4;
  std::ostringstream cause;
  cause.precision(2);
  if (contrast > too_much)
    cause << "a primary of body '" << scene.bodies[heaviest].name << "' is " << contrast
          << " times as heavy as one of body '" << scene.bodies[lightest].name
          << "': sweeps find no forces where such a difference rests on light bodies, bring 'Density' and "
             "sizes nearer to each other";
  else if (std::any_of(moving_walls.begin(), moving_walls.end(),
                       [](const Wall<2> &wall)
                       { return wall.speed != 0. || is_free(wall, Freedom::across); }))
    cause << "walls that close on a full box leave no room";
  else
    cause << "a smaller 'Time/Time step' or more sweeps may help";
  return cause.str();
}

std::string BpmModel::where_is(const Overlap &overlap) const
{
  std::ostringstream text;
  const std::string &body = scene.bodies[overlap.body].name;
  text << "primaries of ";
  if (overlap.with == Overlap::With::wall)
    text << "body '" << body << "' and wall '" << scene.walls[overlap.other].name << "'";
  else if (overlap.with == Overlap::With::obstacle)
    text << "body '" << body << "' and obstacle '" << scene.obstacles[overlap.other].name << "'";
  else if (overlap.other == overlap.body)
    text << "body '" << body << "'";
  else
    text << "the bodies '" << body << "' and '" << scene.bodies[overlap.other].name << "'";
  text << " lie " << overlap.depth << " m deep in each other at (" << overlap.place << ") m";
  return text.str();
}

std::string BpmModel::why_not(const DynamicsReport &report, const double limit) const
{
  std::ostringstream reason;
  const std::string allowed = ", allowed is " + text(limit, " m") + " ('Contact/Largest penetration')";
  if (report.solver.converged && report.on_the_way.depth > limit)
    reason << "on the way of the last one, " << where_is(report.on_the_way) << allowed;
  else if (report.solver.converged)
    reason << "after the last one, " << where_is(dynamics->deepest_overlap()) << allowed;
  else
    reason << "the contact solver is at a residual of " << report.solver.residual << " after "
           << report.solver.sweeps << " sweeps ('Contact/Maximum sweeps'); " << cause_of_no_solution();
  return reason.str();
}

StepReport BpmModel::advance(const double dt_limit)
{
  std::optional<Exchange::OwnWork> own;
  if (dynamics->strips() != nullptr)
    own.emplace(exchange);
  StepReport report;
  const double limit = std::max(settings.largest_penetration * diameter, dynamics->present().penetration());
  dynamics->keep_motion(true);
  const std::vector<Wall<2>> walls_before = moving_walls;
  const Adhesion memory = dynamics->memories().adhesion;
  const std::vector<Felt> obstacles_before = felt_by(moving_obstacles);
  const auto try_step = [&](const double dt) -> Attempt
  {
    drive_walls(dt);
    accelerate(dt);
    DynamicsReport done;
    try
    {
      done = dynamics->step(dt, moving_walls, acceleration, of_loads);
    }
    catch (const Interrupted &)
    {
      // Only the contact solve stops early, before anything has moved.
      moving_walls = walls_before;
      put_back(obstacles_before, moving_obstacles);
      throw;
    }
    report.contact_sweeps += done.solver.sweeps;
    if (done.max_penetration <= limit && done.solver.converged)
    {
      report.contact_residual = done.solver.residual;
      report.max_penetration = done.max_penetration;
      const DynamicsSums sums = dynamics->sums();
      report.n_contacts = sums.n_pushing;
      keep_books(done, sums.moving);
      fallbacks += done.solver.fell_back;
      return {true, ""};
    }
    const std::string reason = why_not(done, limit);
    moving_walls = walls_before;
    dynamics->memories().adhesion = memory;
    put_back(obstacles_before, moving_obstacles);
    dynamics->take_back_motion(moving_walls);
    memory_is_of_attempt = true;
    return {false, reason};
  };
  const StepTaken taken = step_control.advance(settings.step, wanted_step(), dt_limit, now, try_step);
  dynamics->keep_motion(false);
  memory_is_of_attempt = false;
  report.attempts = taken.attempts;
  report.dt = last_dt = taken.dt;
  now += taken.dt;
  ++steps;
  check_ranks_agree(report);
  return report;
}

void BpmModel::forget_attempt()
{
  // A solution that was stopped early is forgotten for that of the last step.
  if (memory_is_of_attempt)
    last_dt = 0.;
  else
    dynamics->detect(moving_walls);
}

void BpmModel::check_ranks_agree(const StepReport &report) const
{
  if (exchange.alone())
    return;
  exchange.check_alike(
      {report.dt, report.contact_residual, report.max_penetration, dynamics->sums().kinetic});
}

void BpmModel::take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives)
{
  softgrain::take_drives(moving_walls, drives, now);
}

void BpmModel::keep_books(const DynamicsReport &report, const double moving)
{
  for (Wall<2> &wall : moving_walls)
    accept_pressure(wall);
  balance.momentum.of_walls += report.wall_impulse + report.driven_impulse;
  balance.momentum.of_loads += report.cell_impulse;
  balance.momentum.of_loads += report.loads.impulse;
  balance.momentum.note(moving);
  balance.cell_work += report.cell_work;
  double left = report.loads.work;
  for (std::size_t load = 0; load < report.loads.of_loads.size(); ++load)
  {
    balance.load_work.add(load_names[load], report.loads.of_loads[load]);
    left -= report.loads.of_loads[load];
  }
  if (!load_names.empty())
    balance.load_work.add(load_names.back(), left);
  balance.contact_loss += report.contact_loss;
  balance.adhesion_work += report.adhesion_work;
  balance.driven_work += report.driven_work;
  balance.wall_damping_loss += report.damping_loss;
  balance.losses.add(report.losses);
  balance.sums.add(report.sums);
}

double BpmModel::momentum_error() const
{
  return balance.momentum.error(dynamics->sums().momentum, mass * rounded_velocity());
}

double BpmModel::rounded_velocity() const
{
  // Places are known to some 1e-16 of the size of a scene, which is thousands of diameters at most.
  return 1e-12 * diameter / wanted_step();
}

double BpmModel::energy_of_rounding() const
{
  return mass * rounded_velocity() * rounded_velocity();
}

Energies BpmModel::energies() const
{
  Energies energies;
  const DynamicsSums sums = dynamics->sums();
  energies.kinetic = sums.kinetic;
  for (const Wall<2> &wall : moving_walls)
    energies.kinetic += kinetic_energy_of(wall);
  energies.elastic = sums.attraction;
  energies.dissipated = balance.dissipated();
  energies.external_work = external_work(balance, moving_walls, moving_obstacles);
  return energies;
}

SizeReport BpmModel::size_report() const
{
  const double dt = wanted_step();
  const DynamicsSums sums = dynamics->sums();
  return {{"bodies", std::to_string(n_bodies())},
          {"primaries", std::to_string(n_points())},
          {"mean diameter", text(diameter, " m")},
          {"neighbour pairs", std::to_string(sums.n_pairs)},
          {"contacts", std::to_string(sums.n_contacts)},
          {"characteristic stress F0/<a0>", text(characteristic_force / diameter, " Pa")},
          {"time step", natural_time > 0. ? text(dt, " s") + " = " + text(dt / natural_time, " sqrt(m a0/F0)")
                                          : text(dt, " s")}};
}

std::vector<std::pair<std::string, double>> BpmModel::extra_history() const
{
  return {{"contacts", static_cast<double>(dynamics->sums().n_contacts)},
          {"plain_solves", static_cast<double>(fallbacks)}};
}

std::vector<std::pair<std::string, double>> BpmModel::works() const
{
  Workers workers;
  workers.loads = load_names;
  workers.cell = any_sides(moving_walls);
  workers.driven_bodies = std::any_of(fixed.begin(), fixed.end(), [](const bool one) { return one; });
  workers.adhesion = settings.dynamics.pairs.adhere();
  return columns_of_work(balance, moving_walls, moving_obstacles, workers);
}

std::map<std::string, double> BpmModel::phases() const
{
  return timer->get_summary_data(dealii::TimerOutput::total_wall_time);
}
} // namespace softgrain::bpm
