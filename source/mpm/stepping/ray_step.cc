// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/contact/denser_rays.h>
#include <softgrain/mpm/contact/frame_adhesion.h>
#include <softgrain/mpm/contact/frame_memory.h>
#include <softgrain/mpm/contact/frame_rows.h>
#include <softgrain/mpm/stepping/accept_step.h>
#include <softgrain/mpm/stepping/begin_step.h>
#include <softgrain/mpm/stepping/contact_work.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/judge_step.h>
#include <softgrain/mpm/stepping/plane_partners.h>
#include <softgrain/mpm/stepping/plane_scene.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/ray_newton.h>
#include <softgrain/mpm/stepping/ray_step.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/step_equations.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace softgrain::mpm
{
namespace
{
/// Of the plane: with cells that repeat, bodies that are driven, walls under loads, obstacles and adhesion.
class RayStep : private RayNewton<2>
{
public:
  RayStep(const Problem &problem,
          const State &state,
          Workspace &work,
          const StepPlan &plan,
          std::vector<WallMotion<2>> &motion,
          StepEquations &equations);

  using RayNewton<2>::outcome;

  Verdict verdict; ///< of the step that was found

  std::string find();
  void accept(State &state_to_change);

private:
  std::vector<StepEquations::Told> tell_ends();
  void note_rays(FoundStep &found, State &state_to_change) const;
  void find_free_walls() override;
  void move_free_walls() override;
  double other_way() const override { return plane.largest_way(); }
  std::string partner_of(const ContactFrame<2> &frame) const override;
  void hand_over_rows();

  const Problem &problem;
  const State &state;
  Workspace &work;
  std::vector<WallMotion<2>> &motion;
  StepEquations &step_equations;
  PlaneScene plane;
};

RayStep::RayStep(const Problem &problem,
                 const State &state,
                 Workspace &work,
                 const StepPlan &plan,
                 std::vector<WallMotion<2>> &motion,
                 StepEquations &equations)
    : RayNewton<2>({state.bodies, work.outlines, state.frames, motion, problem.settings,
                    problem.lattice->cell_size(), problem.subgrid(), work.share, work.matrices, work.solvers,
                    *work.timer},
                   plan,
                   equations)
    , problem(problem)
    , state(state)
    , work(work)
    , motion(motion)
    , step_equations(equations)
    , plane(problem, state, work, plan.dt, motion)
{
  plane.complete(scene);
  scene.reach = 0.5 * h + 2. * largest_way() + (problem.pairs.adhere() ? state.adhesion.reach() : 0.);
}

// Puts walls under loads where they have come to.
void RayStep::move_free_walls()
{
  std::vector<FreeWall<2>> &list = work.contact.free_walls.list;
  for (unsigned int w = 0; w < list.size(); ++w)
    list[w].speed = list[w].speed_after(system.ways[w].at, theta, plan.dt);
  if (list.empty())
    return;
  settle_free_walls(problem, state, work, motion);
  plane.renew(scene);
}

// Walls under loads become unknowns.
void RayStep::find_free_walls()
{
  const PeriodicCell<2> *repeats = scene.cell != nullptr ? &scene.cell->cell : nullptr;
  for (const FreeWall<2> &free : work.contact.free_walls.list)
  {
    const Wall<2> &wall = state.walls[free.wall];
    const PeriodicCell<2> *const side = free.is_side() ? repeats : nullptr;
    if (inertia)
    {
      system.ways.push_back(FreeWay<2>::with_mass(free, free.slab, side, theta, plan.dt));
      continue;
    }
    const double load = load_on(wall, freedom_of(free)).force, net = load + wall.book.force * free.way;
    // The spring is that of bodies that resist no more than they must.
    system.ways.emplace_back(free, free.slab, side, std::abs(net) < 0.5 * std::abs(load) ? 0. : net, load,
                             problem.settings.wall_motion * h,
                             free.mass / (plan.dt * plan.dt) * problem.settings.regularisation /
                                 plan.regularisation);
  }
}

std::string RayStep::partner_of(const ContactFrame<2> &frame) const
{
  return partner_in_words(state, frame.wall, frame.partner);
}

std::string RayStep::find()
{
  if (std::string trouble = converge(); !trouble.empty())
    return trouble;
  if (inertia && walls_are_on_their_way(work))
    return "a wall under a load would go further than 'Wall motion' allows";
  heed_laws(state.bodies, step_equations.stress_outcome(), outcome);
  if (outcome.law_asks)
    return outcome.reason;
  hand_over_rows();
  const std::string given =
      inertia ? why_contact_gives(problem, state, work, plan.dt, motion, equations.increment) : "";
  if (!given.empty())
    return given;
  return judge_step(problem, state, work, motion, plan.dt, equations.increment, outcome, &verdict);
}

// Rays that carry force, as those who keep accounts want them.
void RayStep::hand_over_rows()
{
  ContactMemory<2> memory;
  memory.step = plan.dt;
  std::vector<ContactRow<2>> rows = rows_of_frames(scene, frames, force, rubbing, memory);
  work.contact.reinit(std::move(rows), work.share, false, state.bodies, plan.dt, memory);
}

// Of a body: what the scheme or what resists takes from it, and what resists it.
std::vector<StepEquations::Told> RayStep::tell_ends()
{
  std::vector<StepEquations::Told> told(way.size(), std::array<double, 5>{});
  work.share.for_mine(
      state.bodies,
      [&](const Body<2> &body)
      {
        const unsigned int b = body.index;
        const BodyTerms<2> &terms = step_equations.terms(b);
        const Eigen::VectorXd &increment = equations.increment[b];
        const FrameState<2>::Vector resistance = terms.resistance(body, increment);
        told[b] = {terms.regularisation_work(body, increment),
                   terms.damping(body, trial[b], increment, equations.internal[b]), resistance[0],
                   resistance[1], terms.held_back(body, increment)};
        if (inertia)
          spread_imbalance(body, equations.missing(b) + plan.dt * contact_forces(b), trial[b]);
      },
      [&](BodyShare::Message &message)
      {
        message.add(state.bodies, trial);
        step_equations.tell(told, message);
      });
  return told;
}

// What rays of a step without inertia tell, and what they are for the next step.
void RayStep::note_rays(FoundStep &found, State &state_to_change) const
{
  for (unsigned int f = 0; f < frames.size() && !inertia; ++f)
  {
    frames[f].conditions().add_kinks(force[f], rubbing[f], found.kinks);
    found.dents += frames[f].conditions().dent_energy(force[f]);
    found.adhesion_work += FrameAdhesion<2>(frames[f]).adhesion_work(scene);
    for (const unsigned int side : {0, 1})
      if (const unsigned int b = frames[f].unknown(side); b != FrameState<2>::none)
        state_to_change.held_back[b] += FrameAdhesion<2>(frames[f]).pull_to_come(scene);
  }
  state_to_change.frames = frames_after();
}

void RayStep::accept(State &state_to_change)
{
  const std::vector<StepEquations::Told> told = tell_ends();
  Vectors rate(way.size());
  LoadTimes at_work = step_equations.load_times();
  if (!plan.held && !inertia)
    at_work.at = state.time + 0.5 * plan.dt; // which gives more exact work than their end
  FoundStep found{plan,
                  motion,
                  trial,
                  equations.internal,
                  equations.increment,
                  rate,
                  plan.held || inertia ? equations.external
                                       : external_forces(state.bodies, work.share, at_work),
                  at_work};
  found.balanced = !inertia;
  if (!inertia)
    state_to_change.held_back.resize(way.size());
  for (unsigned int b = 0; b < way.size(); ++b)
  {
    rate[b] = way[b] / plan.dt;
    found.losses.add(loss::regularisation, told[b][0]);
    found.losses.add(loss::scheme, told[b][1]);
    if (!inertia)
    {
      found.resistance.push_back(FrameState<2>::Vector({told[b][2], told[b][3]}));
      state_to_change.held_back[b] = told[b][4];
    }
    outcome.largest_move = std::max(outcome.largest_move, way[b].lpNorm<Eigen::Infinity>());
  }
  note_rays(found, state_to_change);
  accept_step(problem, state_to_change, work, found);
}
} // namespace

StepOutcome ray_step(const Problem &problem, State &state, Workspace &work, const StepPlan &plan)
{
  std::vector<WallMotion<2>> motion = begin_step(problem, state, work, plan);
  renew_outlines(state.bodies, work.outlines, state.frames);
  StepEquations equations(problem, state, work, plan);
  RayStep step(problem, state, work, plan, motion, equations);
  const StepOutcome outcome = try_ray_step(step, state);
  lay_denser_rays(step.verdict, state.walls.size(), problem.lattice->cell_size(), state.frames);
  return outcome;
}
} // namespace softgrain::mpm
