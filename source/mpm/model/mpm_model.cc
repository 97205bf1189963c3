// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/wall_step.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/model/mpm_model.h>
#include <softgrain/mpm/model/rank_report.h>
#include <softgrain/mpm/model/step_choice.h>
#include <softgrain/mpm/stepping/quasi_static.h>
#include <softgrain/mpm/stepping/safe_step.h>
#include <softgrain/mpm/stepping/stiffness.h>
#include <softgrain/mpm/stepping/stress.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
/// Steps that are looked at for 'Wall way' are not longer than this many CFL steps.
constexpr double longest_by_walls = 1e12;
} // namespace

MpmModel::~MpmModel() = default;

double MpmModel::cfl_step() const
{
  double step = std::numeric_limits<double>::max();
  for (const Body<2> &body : state.bodies)
    if (!body.rigid.driven)
      step = std::min(step, problem.lattice->cell_size() *
                                std::sqrt(body.material.density / body.material.law->wave_modulus()));
  return step;
}

bool MpmModel::waves_count() const
{
  const Settings &settings = problem.settings;
  return settings.chosen_way && !at_rest() && (moved_by_more || !all_are_told(state.walls));
}

double MpmModel::fastest_driven_body() const
{
  double speed = 0.;
  for (const Body<2> &body : state.bodies)
    if (body.rigid.driven)
      speed = std::max(speed, body.rigid.drive.norm());
  return speed;
}

double MpmModel::wanted_step() const
{
  const Settings &settings = problem.settings;
  if (settings.wall_way > 0.)
  {
    const double cfl = cfl_step();
    const double longest =
        settings.step.wanted((waves_count() ? settings.cfl_multiple : longest_by_walls) * cfl);
    const double way = settings.wall_way * problem.lattice->cell_size();
    double step = step_of_wall_way(state.walls, state.time, way, std::min(cfl, longest), longest);
    if (const double speed = fastest_driven_body(); speed > 0.)
      step = step > 0. ? std::min(step, way / speed) : way / speed;
    if (step > 0.)
      return std::min(step, longest);
  }
  return settings.step.wanted(settings.scheme.cfl_multiple(settings.cfl_multiple) * cfl_step());
}

StepReport MpmModel::advance(const double dt_limit)
{
  if (!at_rest())
    return try_steps(dt_limit);
  write_state(before_step, false);
  try
  {
    return try_steps(dt_limit);
  }
  catch (...)
  {
    read_state(before_step, false);
    throw;
  }
}

StepReport MpmModel::try_steps(const double dt_limit)
{
  StepReport report;
  const Settings &settings = problem.settings;
  const double wanted = wanted_step();
  bool cut_by_law = false;
  const auto try_step = [&](const double dt) -> Attempt
  {
    const StepOutcome outcome = settings.scheme.integrator->step(problem, state, work, dt, wanted);
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
    last_unbalanced = at_rest()                  ? outcome.unbalanced
                      : settings.meets_by_rays() ? unbalanced_force(problem, state, work, dt, work.load)
                                                 : 0.;
    // A law that has just asked for this length would refuse a longer one.
    return {true, "",
            !cut_by_law && outcome.newton_iterations <= (1 + outcome.held_steps) * settings.max_newton / 2};
  };
  SafeStep safe;
  const double asked = std::min(dt_limit, wanted);
  if (const double limit = safe_step(problem, state, work, asked); limit < asked)
    safe.dt = limit;
  // Bodies that go by their size in so small a share of a usual step are far faster than sound.
  safe.shortest = settings.step.smallest_step * std::min(wanted, settings.cfl_multiple * cfl_step());
  safe.cause = [this]() { return fastest_body(); };
  const StepTaken taken = step_control.advance(settings.step, wanted, dt_limit, state.time, try_step, safe);
  report.attempts = taken.attempts;
  report.dt = last_dt = taken.dt;
  ++steps;
  for (unsigned int r = 0; r < work.contact.contact_rows().size(); ++r)
    report.n_contacts += carries_force(work.contact, r);
  renew_grids();
  if (!settings.scheme.solves_equations() && steps % 20 == 0)
    check_energy();
  update_momentum_scale();
  check_ranks_agree(work.share, state.bodies, report);
  return report;
}

std::string MpmModel::fastest_body() const
{
  const Body<2> *fastest = nullptr;
  double speed = -1.;
  for (const Body<2> &body : state.bodies)
    if (const double of_body = body.rigid.driven ? -1. : body.nodes.momentum().norm() / body.nodes.mass.sum();
        of_body > speed)
    {
      speed = of_body;
      fastest = &body;
    }
  if (fastest == nullptr)
    return "nothing can move";
  std::ostringstream text;
  text << "body '" << fastest->name << "' at (" << fastest->center() << ") m moves at " << speed << " m/s";
  return text.str();
}

void MpmModel::settle(StepReport &report)
{
  // Explicit steps and those with inertia end where they should; what has been settled stays so.
  if (!at_rest() || settled_step == steps)
    return;
  settled_step = steps;
  StepOutcome outcome;
  try
  {
    outcome = problem.settings.scheme.integrator->settle(problem, state, work, last_dt);
  }
  catch (...)
  {
    read_state(before_step, false);
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
  softgrain::take_drives(state.walls, drives, state.time, !at_rest());
}

void MpmModel::check_energy() const
{
  // An unstable explicit step may settle again after a burst, with stresses that look right and are not.
  const Energies now = energies();
  const double scale = std::max({now.kinetic + now.elastic, std::abs(now.external_work), initial_energy});
  const double created = now.kinetic + now.elastic + now.dissipated - now.external_work - initial_energy;
  // The energy of a law is known to some rounding of its modulus.
  double rounding = 0.;
  for (const Body<2> &body : state.bodies)
    if (!body.rigid.driven)
      rounding +=
          100. * std::numeric_limits<double>::epsilon() * body.material.law->wave_modulus() * body.rest.area;
  if (created <= std::max(0.5 * scale, rounding))
    return;
  std::ostringstream message;
  message << "at time " << state.time << " s the bodies hold " << created
          << " J/m more than they were given: the explicit step of " << last_dt
          << " s is not stable; lower 'Time/CFL multiple', or raise 'Material points/Fill limit' so that no "
             "node has little mass";
  throw ComputationError(message.str());
}

void MpmModel::update_momentum_scale()
{
  // The sum over bodies, or over the nodes of a body that vibrates, may vanish while everything moves.
  double scale = 0.;
  for (const Body<2> &body : state.bodies)
  {
    double sum = 0.;
    for (unsigned int i = 0;
         i < body.nodes.mass.size() && body.nodes.velocity.size() > 0 && !body.rigid.driven; ++i)
      sum += body.nodes.mass[i] * body.nodes.velocity.segment<2>(2 * i).norm();
    scale = std::max(scale, sum);
  }
  state.balance.momentum.note(scale);
}

} // namespace softgrain::mpm
