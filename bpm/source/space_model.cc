// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/bpm/space_model.h>
#include <softgrain/scene/loads_over_step.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace softgrain::bpm
{
namespace
{
/// Way of a ball in a step, over its radius, beyond which it might pass by another unseen.
constexpr double longest_way = 0.5;

std::string text(const double value, const std::string &unit)
{
  std::ostringstream s;
  s.precision(4);
  s << value << unit;
  return s.str();
}
} // namespace

double SpaceModel::wanted_step() const
{
  return settings.step.wanted(settings.step_fraction * natural_time);
}

SpaceModel::Accelerations SpaceModel::ask_loads(const double dt) const
{
  const Balls &balls = dynamics->balls();
  Accelerations of_loads(scene.loads.size());
  if (of_loads.empty())
    return of_loads;
  std::vector<const Load<3> *> loads;
  for (const auto &load : scene.loads)
    loads.push_back(load.get());
  // Loads that are the same everywhere are asked once.
  const bool everywhere = !scene.loads.look_at_points() && !scene.loads.see_velocity();
  std::vector<dealii::Tensor<1, 3>> means;
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const std::array<double, 3> &x = balls.position[i], &v = balls.velocity[i];
    if (i == 0 || !everywhere)
    {
      LoadPlace<3> place{
          {x[0], x[1], x[2]}, {x[0], x[1], x[2]}, dealii::Tensor<1, 3>({v[0], v[1], v[2]}), now};
      if (!balls.start.empty())
        place.at_rest = {balls.start[i][0], balls.start[i][1], balls.start[i][2]};
      mean_accelerations(loads, place, dt, means);
    }
    for (std::size_t load = 0; load < means.size(); ++load)
      of_loads[load].push_back({means[load][0], means[load][1], means[load][2]});
  }
  return of_loads;
}

std::string SpaceModel::where_is(const std::size_t row) const
{
  const Balls &balls = dynamics->balls();
  const contact::BallContacts &rows = dynamics->present().rows();
  std::ostringstream text;
  const std::uint32_t a = rows.a[row], b = rows.b[row];
  const std::string &name = scene.bodies[balls.body[a]].name;
  if (b >= balls.size())
    text << "primaries of body '" << name << "' and wall '" << scene.walls[b - balls.size()].name << "'";
  else if (balls.body[a] == balls.body[b])
    text << "primaries of body '" << name << "'";
  else
    text << "primaries of the bodies '" << name << "' and '" << scene.bodies[balls.body[b]].name << "'";
  const std::array<double, 3> &x = balls.position[a];
  text << " lie " << -dynamics->present().gaps()[row] << " m deep in each other at (" << x[0] << ", " << x[1]
       << ", " << x[2] << ") m";
  return text.str();
}

std::string SpaceModel::why_not(const BallReport &report, const double limit) const
{
  std::ostringstream reason;
  if (!report.solver.converged)
    reason << "the contact solver is at a residual of " << report.solver.residual << " after "
           << report.solver.sweeps
           << " sweeps ('Contact/Maximum sweeps'): a smaller 'Time/Time step' or more "
           << "sweeps may help, and walls that close on a full box leave no room";
  else if (report.farthest > longest_way)
    reason << "a primary goes " << report.farthest << " of its radius in one step, at most " << longest_way
           << " can be seen";
  else
    reason << "after the last one, " << where_is(dynamics->present().deepest_row()) << ", allowed is "
           << text(limit, " m") << " ('Contact/Largest penetration')";
  return reason.str();
}

StepReport SpaceModel::advance(const double dt_limit)
{
  StepReport report;
  const double limit =
      std::max(settings.largest_penetration * dynamics->mean_diameter(), dynamics->present().penetration());
  dynamics->keep_motion();
  const std::vector<Wall<3>> walls_before = moving_walls;
  const auto try_step = [&](const double dt) -> Attempt
  {
    for (Wall<3> &wall : moving_walls)
      plan(wall, now, dt);
    BallReport done;
    try
    {
      done = dynamics->step(dt, moving_walls, ask_loads(dt));
    }
    catch (const Interrupted &)
    {
      // Only the contact solve stops early, before anything has moved.
      moving_walls = walls_before;
      throw;
    }
    report.contact_sweeps += done.solver.sweeps;
    if (done.solver.converged && done.farthest <= longest_way && done.max_penetration <= limit)
    {
      report.contact_residual = done.solver.residual;
      report.max_penetration = done.max_penetration;
      keep_books(done);
      return {true, ""};
    }
    const std::string reason = why_not(done, limit);
    moving_walls = walls_before;
    dynamics->take_back_motion(moving_walls);
    return {false, reason};
  };
  const StepTaken taken = step_control.advance(settings.step, wanted_step(), dt_limit, now, try_step);
  report.attempts = taken.attempts;
  report.dt = last_dt = taken.dt;
  now += taken.dt;
  ++steps;
  report.n_contacts = dynamics->sums().n_pushing;
  return report;
}

void SpaceModel::take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives)
{
  softgrain::take_drives(moving_walls, drives, now, false);
}

void SpaceModel::keep_books(const BallReport &report)
{
  contact_loss += report.contact_loss;
  impulse += report.impulse;
  largest_momentum = std::max(largest_momentum, dynamics->sums().moving);
  fallbacks += report.solver.fell_back;
  std::size_t load = 0;
  for (const std::string &name : scene.loads.names())
    load_work.add(name, report.load_work[load++]);
}

double SpaceModel::rounded_velocity() const
{
  // Places are known to some 1e-16 of the size of a scene, which is thousands of diameters at most.
  return 1e-12 * dynamics->mean_diameter() / wanted_step();
}

double SpaceModel::momentum_error() const
{
  const double scale = std::max(largest_momentum, impulse.norm());
  if (scale <= mass * rounded_velocity())
    return std::numeric_limits<double>::quiet_NaN();
  return (dynamics->sums().momentum - impulse).norm() / scale;
}

double SpaceModel::energy_of_rounding() const
{
  return mass * rounded_velocity() * rounded_velocity();
}

Energies SpaceModel::energies() const
{
  Energies energies;
  energies.kinetic = dynamics->sums().kinetic;
  energies.elastic = dynamics->sums().attraction;
  energies.dissipated = contact_loss;
  energies.external_work = load_work.sum();
  for (const Wall<3> &wall : moving_walls)
    energies.external_work += wall.book.work;
  return energies;
}

SizeReport SpaceModel::size_report() const
{
  const double dt = wanted_step();
  return {{"bodies", std::to_string(n_bodies())},
          {"primaries", std::to_string(n_points())},
          {"mean diameter", text(dynamics->mean_diameter(), " m")},
          {"neighbour pairs", std::to_string(dynamics->neighbours().n_pairs())},
          {"contacts", std::to_string(dynamics->present().rows().size())},
          {"characteristic stress F0/<a0>^2",
           text(characteristic_force / std::pow(dynamics->mean_diameter(), 2), " Pa")},
          {"time step", natural_time > 0. ? text(dt, " s") + " = " + text(dt / natural_time, " sqrt(m a0/F0)")
                                          : text(dt, " s")}};
}

std::vector<std::pair<std::string, double>> SpaceModel::works() const
{
  std::vector<std::pair<std::string, double>> columns;
  for (const Wall<3> &wall : moving_walls)
    columns.emplace_back(wall.description.name + "_work_J", wall.book.work);
  for (const std::string &load : scene.loads.names())
    columns.emplace_back(load + "_work_J", load_work.of(load));
  return columns;
}

std::vector<std::pair<std::string, double>> SpaceModel::extra_history() const
{
  std::vector<std::pair<std::string, double>> columns = {
      {"contacts", static_cast<double>(dynamics->present().rows().size())},
      {"plain_solves", static_cast<double>(fallbacks)}};
  for (const Wall<3> &wall : moving_walls)
    if (wall.description.drive->slides())
      columns.emplace_back(wall.description.name + "_tangential_force_N", state_of(wall).tangential_force);
  return columns;
}

std::map<std::string, double> SpaceModel::phases() const
{
  return timer->get_summary_data(dealii::TimerOutput::total_wall_time);
}
} // namespace softgrain::bpm
