// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/space_ray_step.h>
#include <softgrain/mpm/stepping/space_step.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double least_load = 1e-6; ///< that is asked for, over Young's modulus times the side of a cell

class StepAtRest : public SpaceRayStep
{
public:
  StepAtRest(SpaceState &state,
             const SpaceScene &space,
             SpaceMotion &motion,
             const StepPlan &plan,
             SpaceEquations &equations)
      : SpaceRayStep(state, space, motion, plan, equations), of_space(equations)
  {
  }

  std::string find();
  void accept(SpaceState &state);

private:
  void account_frame(unsigned int f, SpaceState &state) const;
  std::vector<double> works_of_step(const Body<3> &body) const;
  void account_pressures(const std::vector<dealii::Tensor<1, 3>> &force_before, SpaceState &state) const;

  SpaceEquations &of_space;
};

std::string StepAtRest::find()
{
  if (std::string trouble = SpaceRayStep::find(); !trouble.empty())
    return trouble;
  heed_laws(world.bodies, of_space.stress_outcome(), outcome);
  return outcome.law_asks ? outcome.reason : "";
}

/// Loads at the middle of a step do more exact work than those at its end.
std::vector<double> StepAtRest::works_of_step(const Body<3> &body) const
{
  const Eigen::VectorXd &of_step = of_space.external[body.index];
  if (of_step.size() == 0)
    return {};
  LoadTimes times = of_space.load_times();
  if (plan.held)
    return works_of_loads(body, of_step, way[body.index], times);
  times.at = times.begin + 0.5 * plan.dt;
  Eigen::VectorXd load;
  external_force(body, times, load);
  return works_of_loads(body, load, way[body.index], times);
}

// From balance to balance friction does the work of the mean of both ends, but for what kinks tell.
void StepAtRest::account_frame(const unsigned int f, SpaceState &state) const
{
  const FrameState<3> &frame = frames[f];
  state.dent_energy += frame.conditions().dent_energy(force[f]);
  frame.conditions().add_kinks(force[f], rubbing[f], state.kinks);
  for (unsigned int k = 0; k < frame.n_rays(); ++k)
    if (frame.ray(k).met && frame.conditions().rubs(k))
      state.losses.rubbed -= 0.5 * (frame.layout().rays[k].friction + rubbing[f][k]) * frame.ray(k).rub.slide;
}

// A load does all of its work as soon as it acts. What the bodies do not bear on the way is lost.
void StepAtRest::account_pressures(const std::vector<dealii::Tensor<1, 3>> &force_before,
                                   SpaceState &state) const
{
  for (unsigned int i = 0; i < pressed.size(); ++i)
  {
    const unsigned int w = pressed[i];
    const double gone = system.ways[i].at,
                 at_start = motion.pressure_at_start[w] * pressed_area(motion.walls, w),
                 load = 0.5 * (at_start + system.ways[i].load),
                 borne = 0.5 * (force_before[w] + state.wall_force[w]) * motion.walls[w].normal;
    state.loaded[w].way += gone;
    state.loaded[w].work += gone * load;
    state.losses.regularisation += gone * (load - borne);
  }
}

void StepAtRest::accept(SpaceState &state)
{
  state.held_back.clear();
  for (const auto &[held_back, work] :
       world.share.numbers<2>(state.bodies,
                              [&](const Body<3> &body) {
                                return std::array<double, 2>{of_space.held_back(body.index),
                                                             of_space.regularisation_work(body.index)};
                              }))
  {
    state.held_back.push_back(held_back);
    state.losses.regularisation += work;
  }
  account_loads([this](const Body<3> &body) { return works_of_step(body); }, state);
  state.dent_energy = 0.;
  state.kinks = ContactKinks();
  for (unsigned int f = 0; f < frames.size(); ++f)
    account_frame(f, state);
  const std::vector<dealii::Tensor<1, 3>> before = state.wall_force;
  accept_ways(state);
  account_pressures(before, state);
}
} // namespace

StepOutcome SpaceAtRest::step(const StepPlan &plan)
{
  stands = motion.at_end(plan.dt);
  SpaceMotion now = plan.held ? stands : motion;
  now.walls = walls_now(now, state.loaded);
  now.cell_offset = state.cell_offset;
  SpaceEquations equations(state.bodies, scene.settings, scene.work, plan, state.time, scene.frictionless);
  StepAtRest step(state, scene, now, plan, equations);
  return try_ray_step(step, state);
}

double SpaceAtRest::unbalanced()
{
  return std::max(unbalanced_rays(state.bodies, state.frames, state.held_back, scene.settings.cell_size),
                  unbalanced_wall().share);
}

WallImbalance SpaceAtRest::unbalanced_wall() const
{
  const double h = scene.settings.cell_size;
  return least_balanced_wall(stands, state.loaded, state.wall_force,
                             least_load * softest(state.bodies) * h * h);
}

bool SpaceAtRest::remembers() const
{
  return any_history(state.bodies);
}

bool SpaceAtRest::walls_yield() const
{
  return std::any_of(motion.pressure.begin(), motion.pressure.end(),
                     [](const std::optional<double> &pressure) { return pressure.has_value(); });
}

void SpaceAtRest::held(StepOutcome & /*sum*/)
{
  const double room = scene.settings.space_lower.distance(scene.settings.space_upper);
  for (unsigned int w = 0; w < state.loaded.size(); ++w)
    if (motion.pressure[w] && std::abs(state.loaded[w].way) > room)
      throw ComputationError("at time " + short_number(state.time) +
                             " s nothing bears the pressure of wall '" + scene.wall_names[w] +
                             "': it has gone " + short_number(state.loaded[w].way) + " m");
}

std::string SpaceAtRest::least_balanced() const
{
  const WallImbalance worst = unbalanced_wall();
  if (worst.share <= scene.settings.unbalanced_force)
    return least_balanced_body(state.bodies, state.held_back);
  return worst.in_words(scene.wall_names[worst.wall], "N");
}
} // namespace softgrain::mpm
