// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/contact/moved_boundary.h>
#include <softgrain/mpm/stepping/contact_work.h>
#include <softgrain/mpm/stepping/moving_equations.h>
#include <softgrain/mpm/stepping/moving_step.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/stress.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace softgrain::mpm
{
namespace
{
class MovingStep : public SpaceRayStep
{
public:
  MovingStep(SpaceState &state,
             const SpaceScene &space,
             SpaceMotion &motion,
             const StepPlan &plan,
             MovingEquations &equations);

  std::string find();
  void accept(SpaceState &state);

private:
  void note_contact_work();
  std::string why_contact_gives() const;
  void account_body(Body<3> &body, SpaceState &state);

  MovingEquations &moving;
  std::vector<double> obstacle_work; ///< on the bodies [J]
  double taken = 0.;                 ///< of all work by contact [J]
};

MovingStep::MovingStep(SpaceState &state,
                       const SpaceScene &space,
                       SpaceMotion &motion,
                       const StepPlan &plan,
                       MovingEquations &equations)
    : SpaceRayStep(state, space, motion, plan, equations)
    , moving(equations)
    , obstacle_work(motion.obstacles.size(), 0.)
{
  for (const Body<3> &body : state.bodies)
    scene.ways.own.push_back(plan.dt * mpm::largest_way(body, body.velocity));
}

std::string MovingStep::find()
{
  if (std::string trouble = SpaceRayStep::find(); !trouble.empty())
    return trouble;
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
          const double work = (force[f][k] * frames[f].derivatives().resultant(k) +
                               frames[f].ray(k).rub.in_space(rubbing[f][k])) *
                              way_of_partner(frames[f], k);
          if (const unsigned int o = obstacle_of(layout); o != none)
            obstacle_work[o] += work;
          taken += work;
        }
  for (unsigned int b = 0; b < way.size(); ++b)
    taken -= contact_forces(b).dot(way[b]);
}

std::string MovingStep::why_contact_gives() const
{
  const auto stored = [this]
  {
    double sum = 0.;
    for (const Body<3> &body : world.bodies)
      sum +=
          measure_points(body, Eigen::VectorXd(body.displacement + way[body.index]), way[body.index]).energy;
    return sum;
  };
  const std::optional<double> held = energy_where_contact_gives(world.bodies, -taken, stored);
  return held ? "contact would give the bodies " + short_number(-taken) + " J where they have " +
                    short_number(*held) + " J"
              : "";
}

void MovingStep::account_body(Body<3> &body, SpaceState &state)
{
  const unsigned int b = body.index;
  MotionBalance &balance = state.motion;
  spread_imbalance(body, moving.missing(b) + plan.dt * contact_forces(b), trial[b]);
  balance.scheme_damping += moving.damping(b, trial[b]);
  state.losses.regularisation += moving.held_work(b);
  if (const Eigen::VectorXd &load = moving.external[b]; load.size() > 0)
  {
    account_load(body, load, moving.load_times(), state);
    for (unsigned int i = 0; i < body.mass.size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        balance.impulse[d] += plan.dt * load[3 * i + d];
  }
  body.velocity = trial[b];
  body.internal_force = moving.internal[b];
  double moves = 0.;
  for (unsigned int i = 0; i < body.mass.size(); ++i)
    moves += std::abs(body.mass[i]) * body.velocity.segment<3>(3 * i).norm();
  balance.largest_momentum = std::max(balance.largest_momentum, moves);
}

void MovingStep::accept(SpaceState &state)
{
  for (Body<3> &body : state.bodies)
    account_body(body, state);
  state.motion.contact_loss += taken;
  accept_ways(state);
  for (unsigned int o = 0; o < obstacle_work.size(); ++o)
  {
    state.obstacles[o].work += obstacle_work[o];
    state.obstacles[o].go_on();
  }
  for (const SpaceContact &contact : state.contacts)
    if (contact.partner == ContactFrame<3>::none)
      state.motion.impulse += plan.dt * contact.force;
}
} // namespace

StepOutcome
moving_step(SpaceState &state, const SpaceScene &scene, const SpaceMotion &motion, const double dt)
{
  const StepPlan plan{dt, false, 0.};
  MovingEquations equations(state.bodies, scene.settings, scene.work, plan, state.time, scene.frictionless);
  SpaceMotion planned = motion;
  MovingStep step(state, scene, planned, plan, equations);
  return try_ray_step(step, state);
}
} // namespace softgrain::mpm
