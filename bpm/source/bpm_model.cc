// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/bpm/aggregate.h>
#include <softgrain/bpm/bpm_model.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <iostream>
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
} // namespace

BpmModel::~BpmModel() = default;

void BpmModel::set_up_walls()
{
  for (const WallDescription<2> &description : scene.walls)
  {
    MovingWall wall;
    for (unsigned int d = 0; d < 2; ++d)
    {
      wall.point[d] = description.point[d];
      wall.normal[d] = description.normal[d];
    }
    wall.friction = description.friction;
    const bool pressed = !description.pressure.empty();
    wall.inverse_mass = pressed ? 1. / description.mass : 0.;
    wall.damping = description.damping;
    if (description.type != WallDescription<2>::Type::plane)
      throw InputError("'Walls/" + description.name +
                       "/Type' = 'material points' is not allowed with 'Model' = 'bpm': choose 'plane'");
    moving_walls.push_back(wall);
    wall_drive.emplace_back(pressed ? description.pressure : description.velocity,
                            std::vector<std::string>{"t"});
    if (pressed && pressed_length(moving_walls.size() - 1) <= 0.)
      throw InputError("'Walls/" + description.name +
                       "/Drive' = 'pressure' needs two walls beside it, at right angles, between which the "
                       "pressure acts");
  }
}

double BpmModel::pressed_length(const std::size_t w) const
{
  // The walls on both sides, seen along the tangent: the length between them is what the pressure acts on.
  const dealii::Tensor<1, 2> &normal = scene.walls[w].normal;
  const dealii::Tensor<1, 2> tangent({-normal[1], normal[0]});
  double low = 0., high = 0.;
  bool has_low = false, has_high = false;
  for (std::size_t other = 0; other < scene.walls.size(); ++other)
  {
    const double along = scene.walls[other].normal * tangent;
    if (std::abs(std::abs(along) - 1.) > 1e-12)
      continue;
    const double travel = other < moving_walls.size() ? moving_walls[other].travel : 0.;
    const double place = scene.walls[other].point * tangent + travel * along;
    (along > 0. ? low : high) = place;
    (along > 0. ? has_low : has_high) = true;
  }
  return has_low && has_high ? high - low : 0.;
}

void BpmModel::drive_walls(const double dt)
{
  for (std::size_t w = 0; w < moving_walls.size(); ++w)
    // The middle of the step, so that a wall ends where its formula integrates to, to second order.
    if (moving_walls[w].inverse_mass == 0.)
      moving_walls[w].velocity = wall_drive[w]({now + 0.5 * dt});
    else
      moving_walls[w].load = wall_drive[w]({now + 0.5 * dt}) * pressed_length(w);
}

void BpmModel::accelerate()
{
  if (acceleration.empty())
    return;
  const Primaries &disks = dynamics->disks();
  for (std::size_t i = 0; i < disks.size(); ++i)
  {
    acceleration[i] = {scene.gravity[0], scene.gravity[1]};
    const std::vector<Expression> &force = body_force[disks.body[i]];
    if (force.empty())
      continue;
    const std::array<double, 2> &x = disks.position[i], &X = start_position[i];
    for (unsigned int d = 0; d < 2; ++d)
      acceleration[i][d] += force[d]({x[0], x[1], X[0], X[1], now});
  }
}

double BpmModel::wanted_step() const
{
  return settings.time_step > 0. ? settings.time_step : settings.step_fraction * natural_time;
}

StepReport BpmModel::advance(const double dt_limit)
{
  StepReport report;
  const double wanted = wanted_step(), scale_before = step_scale;
  double dt = std::min(wanted * step_scale, dt_limit);
  const double limit =
      std::max(settings.largest_penetration * dynamics->mean_diameter(), dynamics->penetration());
  const auto positions = dynamics->disks().position, velocities = dynamics->disks().velocity;
  const auto spins = dynamics->disks().angular_velocity;
  const std::vector<MovingWall> walls_before = moving_walls;
  for (;; ++report.attempts)
  {
    drive_walls(dt);
    accelerate();
    DynamicsReport done;
    try
    {
      done = dynamics->step(dt, moving_walls, acceleration);
    }
    catch (const Interrupted &)
    {
      // Only the contact solve stops early, before anything has moved.
      moving_walls = walls_before;
      step_scale = scale_before;
      throw;
    }
    report.contact_sweeps += done.solver.sweeps;
    if (done.max_penetration <= limit && done.solver.converged)
    {
      report.contact_residual = done.solver.residual;
      report.max_penetration = done.max_penetration;
      keep_books(done, dt);
      step_scale = std::min(1., 1.25 * step_scale);
      fallbacks += done.solver.fell_back;
      break;
    }
    dynamics->disks().position = positions;
    dynamics->disks().velocity = velocities;
    dynamics->disks().angular_velocity = spins;
    moving_walls = walls_before;
    dynamics->detect(moving_walls);
    dt *= 0.5;
    step_scale = std::min(step_scale, dt / wanted);
    if (dt < settings.smallest_step * std::min(wanted, dt_limit))
    {
      std::ostringstream message;
      message << "at time " << now << " s no step longer than " << dt << " s succeeds: ";
      if (done.solver.converged)
        message << "the last one left primaries that overlap by " << done.max_penetration << " m, allowed is "
                << limit << " m ('Contact/Largest penetration')";
      else
        message << "the contact solver is at a residual of " << done.solver.residual << " after "
                << done.solver.sweeps
                << " sweeps ('Contact/Maximum sweeps'); walls that close on a full box leave no room";
      throw ComputationError(message.str());
    }
  }
  report.dt = last_dt = dt;
  now += dt;
  ++steps;
  for (const double impulse : dynamics->contacts().impulse)
    report.n_contacts += impulse > 0.;
  return report;
}

void BpmModel::keep_books(const DynamicsReport &report, const double dt)
{
  for (const MovingWall &wall : moving_walls)
    for (unsigned int d = 0; d < 2; ++d)
      books.wall_impulse[d] += wall.normal_impulse * wall.normal[d] -
                               wall.tangential_impulse * (d == 0 ? wall.normal[1] : -wall.normal[0]);
  const Primaries &disks = dynamics->disks();
  if (!acceleration.empty())
    for (std::size_t i = 0; i < disks.size(); ++i)
      for (unsigned int d = 0; d < 2 && !fixed[disks.body[i]]; ++d)
        books.body_force_impulse[d] += dt * disks.mass[i] * acceleration[i][d];
  double sum = std::max(books.wall_impulse.norm(), books.body_force_impulse.norm());
  double moving = 0.;
  for (std::size_t i = 0; i < disks.size(); ++i)
    moving += disks.mass[i] * std::hypot(disks.velocity[i][0], disks.velocity[i][1]);
  books.largest_momentum = std::max({books.largest_momentum, sum, moving});
  books.wall_work += report.wall_work;
  books.body_force_work += report.force_work;
  books.contact_loss += report.contact_loss;
  books.damping_loss += report.damping_loss;
}

dealii::Tensor<1, 2> BpmModel::momentum() const
{
  dealii::Tensor<1, 2> sum;
  const Primaries &disks = dynamics->disks();
  for (std::size_t i = 0; i < disks.size(); ++i)
    for (unsigned int d = 0; d < 2 && !fixed[disks.body[i]]; ++d)
      sum[d] += disks.mass[i] * disks.velocity[i][d];
  return sum;
}

double BpmModel::momentum_error() const
{
  const auto error = momentum() - books.initial_momentum - books.wall_impulse - books.body_force_impulse;
  return books.largest_momentum > 0. ? error.norm() / books.largest_momentum : error.norm();
}

Energies BpmModel::energies() const
{
  Energies energies;
  energies.kinetic = dynamics->kinetic_energy();
  for (const MovingWall &wall : moving_walls)
    if (wall.inverse_mass > 0.)
      energies.kinetic += 0.5 * wall.velocity * wall.velocity / wall.inverse_mass;
  energies.elastic = dynamics->attraction_energy();
  energies.dissipated = books.contact_loss + books.damping_loss;
  energies.external_work = books.wall_work + books.body_force_work;
  return energies;
}

SizeReport BpmModel::size_report() const
{
  const double dt = wanted_step();
  SizeReport report = {
      {"bodies", std::to_string(n_bodies())},
      {"primaries", std::to_string(n_points())},
      {"mean diameter", text(dynamics->mean_diameter(), " m")},
      {"neighbour pairs", std::to_string(dynamics->neighbours().n_pairs())},
      {"contacts", std::to_string(dynamics->contacts().size())},
      {"characteristic stress F0/<a0>", text(characteristic_force / dynamics->mean_diameter(), " Pa")},
      {"time step", natural_time > 0. ? text(dt, " s") + " = " + text(dt / natural_time, " sqrt(m a0/F0)")
                                      : text(dt, " s")}};
  report.emplace_back("steps to the end time",
                      scene.stop.end_time > 0. ? text(std::ceil(scene.stop.end_time / dt), "") : "open");
  return report;
}

std::vector<std::pair<std::string, double>> BpmModel::extra_history() const
{
  return {{"contacts", static_cast<double>(dynamics->contacts().size())},
          {"plain_solves", static_cast<double>(fallbacks)}};
}

std::map<std::string, double> BpmModel::phases() const
{
  return timer->get_summary_data(dealii::TimerOutput::total_wall_time);
}
} // namespace softgrain::bpm
