// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/contact/moved_boundary.h>
#include <softgrain/mpm/stepping/cell_work.h>
#include <softgrain/mpm/stepping/contact_work.h>
#include <softgrain/mpm/stepping/moving_equations.h>
#include <softgrain/mpm/stepping/moving_step.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/stress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace softgrain::mpm
{
MovingStep::MovingStep(SpaceState &state,
                       const SpaceScene &space,
                       SpaceMotion &motion,
                       const StepPlan &plan,
                       SpaceEquations &equations)
    : SpaceRayStep(state, space, motion, plan, equations)
    , moving(equations)
    , obstacle_work(motion.obstacles.size(), 0.)
{
  for (const Body<3> &body : state.bodies)
    scene.ways.own.push_back(plan.dt * mpm::largest_way(body, body.nodes.velocity));
}

std::string MovingStep::find()
{
  if (std::string trouble = find_ways(); !trouble.empty())
    return trouble;
  for (unsigned int i = 0; i < pressed.size(); ++i)
  {
    FreeWall<3> &wall = motion.free[pressed[i]].wall;
    wall.speed = wall.speed_after(system.ways[i].at, world.settings.scheme.theta, plan.dt);
    if (wall.at_stop())
      return "a wall under a load would go further than " + short_number(world.settings.wall_motion) +
             " cells";
  }
  heed_laws(world.bodies, moving.stress_outcome(), outcome);
  if (outcome.law_asks)
    return outcome.reason;
  note_contact_work();
  return why_contact_gives();
}

void MovingStep::note_contact_work()
{
  for (unsigned int f = 0; f < frames.size(); ++f)
    if (const ContactFrame<3> &layout = frames[f].layout(); layout.partner == ContactFrame<3>::none)
      for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
        if (force[f][k] != 0.)
        {
          const double work = force_on_body(f, k) * way_of_partner(frames[f], k);
          if (const unsigned int o = obstacle_of(layout); o != none)
            obstacle_work[o] += work;
          taken += work;
        }
  for (const auto &[work] : world.share.numbers<1>(
           world.bodies, [&](const Body<3> &body)
           { return std::array<double, 1>{forces_on(body.index).dot(way_at_work(body.index))}; }))
    taken -= work;
  if (cell)
    taken -= plan.dt * scalar_product(cell->gradient, virial());
}

std::string MovingStep::why_contact_gives() const
{
  const auto stored = [this]
  {
    double sum = 0.;
    for (const auto &[energy] : world.share.numbers<1>(
             world.bodies,
             [&](const Body<3> &body)
             {
               const Eigen::VectorXd &gone = way[body.index];
               return std::array<double, 1>{
                   measure_points(body, Eigen::VectorXd(body.nodes.displacement + gone), gone).energy};
             }))
      sum += energy;
    return sum;
  };
  const std::optional<double> held = energy_where_contact_gives(world.bodies, -taken, stored);
  return held ? "contact would give the bodies " + short_number(-taken) + " J where they have " +
                    short_number(*held) + " J"
              : "";
}

MovingStep::OfBody MovingStep::end_of(const Body<3> &body)
{
  const unsigned int b = body.index;
  const std::array<double, 2> of_scheme = end(body);
  OfBody told{of_scheme[0], of_scheme[1]};
  const Eigen::VectorXd &load = moving.external[b];
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
  {
    told[2] += std::abs(body.nodes.mass[i]) * trial[b].segment<3>(3 * i).norm();
    for (unsigned int d = 0; d < 3 && load.size() > 0; ++d)
      told[3 + d] += plan.dt * load[3 * i + d];
  }
  return told;
}

void MovingStep::accept_motion(SpaceState &state)
{
  std::vector<OfBody> told(state.bodies.size(), OfBody{});
  world.share.for_mine(
      state.bodies,
      [&](Body<3> &body)
      {
        told[body.index] = end_of(body);
        body.nodes.velocity = trial[body.index];
        body.nodes.internal_force = moving.internal[body.index];
      },
      [&](BodyShare::Message &message)
      {
        for (Body<3> &body : state.bodies)
        {
          body.nodes.internal_force.resize(body.nodes.velocity.size());
          message.add(body.index, told[body.index].data(), told[body.index].size());
          message.add(body.index, body.nodes.velocity.data(), body.nodes.velocity.size());
          message.add(body.index, body.nodes.internal_force.data(), body.nodes.internal_force.size());
        }
      });
  MotionBalance &balance = state.motion;
  for (const OfBody &of_body : told)
  {
    balance.scheme_damping += of_body[0];
    state.losses.regularisation += of_body[1];
    balance.largest_momentum = std::max(balance.largest_momentum, of_body[2]);
    balance.impulse += dealii::Tensor<1, 3>({of_body[3], of_body[4], of_body[5]});
  }
}

/// Books the ways of walls under loads, the work of the loads, and what dampers and the scheme take of it.
void MovingStep::account_pressures(SpaceState &state) const
{
  const TimeScheme &scheme = world.settings.scheme;
  for (unsigned int i = 0; i < pressed.size(); ++i)
  {
    const auto &[wall, load] = motion.free[pressed[i]];
    LoadedWall &loaded = state.loaded[pressed[i]];
    const double gone = system.ways[i].at;
    loaded.speed = wall.speed;
    loaded.way += gone;
    loaded.work += gone * load.force;
    state.motion.wall_damping += load.damping * gone * gone / plan.dt;
    state.motion.scheme_damping += scheme.loss_of_wall(load.mass, wall.speed - wall.start_speed);
  }
}

void MovingStep::accept(SpaceState &state)
{
  account_loads(
      [this](const Body<3> &body)
      {
        const Eigen::VectorXd &load = moving.external[body.index];
        return load.size() > 0 ? works_of_loads(body, load, way_at_work(body.index), moving.load_times())
                               : std::vector<double>();
      },
      state);
  accept_motion(state);
  state.motion.contact_loss += taken;
  account_pressures(state);
  accept_ways(state);
  if (cell)
  {
    const CellWork<3> done = measure_against_cell(*cell, plan.dt, state.bodies);
    state.motion.impulse += done.impulse;
    state.motion.cell_work += done.work;
  }
  for (unsigned int o = 0; o < obstacle_work.size(); ++o)
  {
    state.obstacles[o].work += obstacle_work[o];
    state.obstacles[o].go_on();
  }
  for (const SpaceContact &contact : state.contacts)
    if (contact.partner == ContactFrame<3>::none)
      state.motion.impulse += plan.dt * contact.force;
}
namespace
{
/// A step of `moreau_jean`: Newton's method finds bodies and contact together.
class ImplicitMovingStep final : public MovingStep
{
public:
  ImplicitMovingStep(SpaceState &state,
                     const SpaceScene &space,
                     SpaceMotion &motion,
                     const StepPlan &plan,
                     MovingEquations &equations)
      : MovingStep(state, space, motion, plan, equations), moving(equations)
  {
  }

private:
  std::array<double, 2> end(const Body<3> &body) override
  {
    const unsigned int b = body.index;
    spread_imbalance(body, moving.missing(b) + plan.dt * contact_forces(b), trial[b]);
    return {{moving.damping(b, trial[b]), moving.held_work(b)}};
  }

  MovingEquations &moving;
};
} // namespace

StepOutcome
moving_step(SpaceState &state, const SpaceScene &scene, const SpaceMotion &motion, const double dt)
{
  const StepPlan plan{dt, false, 0.};
  MovingEquations equations(state.bodies, scene.settings, scene.work, plan, state.time, scene.frictionless);
  SpaceMotion planned = motion;
  planned.walls = walls_now(planned, state.loaded);
  ImplicitMovingStep step(state, scene, planned, plan, equations);
  return try_ray_step(step, state);
}
} // namespace softgrain::mpm
