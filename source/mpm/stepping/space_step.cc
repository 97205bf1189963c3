// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/space_ray_step.h>
#include <softgrain/mpm/stepping/space_step.h>

namespace softgrain::mpm
{
namespace
{
class StepAtRest : public SpaceRayStep
{
public:
  StepAtRest(SpaceState &state,
             const SpaceScene &space,
             const std::vector<WallMotion<3>> &motion,
             const StepPlan &plan,
             SpaceEquations &equations)
      : SpaceRayStep(state, space, motion, plan, equations), of_space(equations)
  {
  }

  void accept(SpaceState &state);

private:
  void account_frame(unsigned int f, SpaceState &state) const;

  SpaceEquations &of_space;
};

// From balance to balance friction does the work of the mean of both ends, but for what kinks tell.
void StepAtRest::account_frame(const unsigned int f, SpaceState &state) const
{
  const FrameState<3> &frame = frames[f];
  state.dent_energy += frame.dent_energy(force[f]);
  frame.add_kinks(force[f], rubbing[f], state.kinks);
  for (unsigned int k = 0; k < frame.n_rays(); ++k)
    if (frame.ray(k).met && frame.rubs(k))
      state.rubbed -= 0.5 * (frame.layout().rays[k].friction + rubbing[f][k]) * frame.ray(k).slide;
}

void StepAtRest::accept(SpaceState &state)
{
  state.held_back.resize(way.size());
  for (unsigned int b = 0; b < way.size(); ++b)
  {
    state.held_back[b] = of_space.held_back(b);
    state.regularisation_work += of_space.regularisation_work(b);
  }
  state.dent_energy = 0.;
  state.kinks = ContactKinks();
  for (unsigned int f = 0; f < frames.size(); ++f)
    account_frame(f, state);
  accept_ways(state);
}
} // namespace

StepOutcome SpaceAtRest::step(const StepPlan &plan, const bool careful, const double most_resistance)
{
  std::vector<WallMotion<3>> walls = motion;
  for (WallMotion<3> &wall : walls)
    if (plan.held)
    {
      wall.point += plan.dt * wall.velocity * wall.normal;
      wall.velocity = wall.slide = 0.;
    }
  SpaceEquations equations(state.bodies, scene.settings, scene.work, plan, scene.pairs.frictionless());
  StepAtRest step(state, scene, walls, plan, equations);
  return try_ray_step(step, careful, most_resistance, state);
}

double SpaceAtRest::unbalanced()
{
  return unbalanced_rays(state.bodies, state.frames, state.held_back, scene.settings.cell_size);
}
} // namespace softgrain::mpm
