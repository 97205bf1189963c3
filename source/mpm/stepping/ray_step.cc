// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/interruption.h>
#include <softgrain/mpm/contact/frame_memory.h>
#include <softgrain/mpm/contact/frame_rows.h>
#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/frame_state.h>
#include <softgrain/mpm/contact/frame_system.h>
#include <softgrain/mpm/stepping/accept_step.h>
#include <softgrain/mpm/stepping/begin_step.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/judge_step.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/ray_step.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/step_equations.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace softgrain::mpm
{
namespace
{
using Vectors = StepEquations::Vectors;

constexpr double candidates_within = 0.15; ///< cells
constexpr double gap_tolerance = 1e-5;     ///< cells
constexpr unsigned int most_halvings = 8;  ///< of a way that cannot be gone
constexpr double rise = 10.;               ///< of what resists motion, where a step has no minimum
constexpr unsigned int most_rises = 8;
constexpr double longest_way = 0.3; ///< of a node in an iteration [cells]

class RayStep
{
public:
  RayStep(const Problem &problem,
          const State &state,
          Workspace &work,
          const StepPlan &plan,
          std::vector<WallMotion<2>> &motion)
      : problem(problem)
      , state(state)
      , work(work)
      , plan(plan)
      , motion(motion)
      , h(problem.lattice->cell_size())
      , cell(state.cell_motion(motion))
      , equations(problem, state, work, plan)
      , scene{state.bodies,
              work.outlines,
              motion,
              h,
              problem.subgrid(),
              0.5 * h + 2. * largest_way(),
              &problem.pairs,
              cell ? &*cell : nullptr,
              plan.dt,
              ways_of_bodies()}
      , system(work.share, state.bodies, work.solvers, plan.dt * plan.dt)
  {
  }

  std::string find();
  void accept(State &state_to_change);

  StepOutcome outcome;

private:
  FrameState::Vector way_of(const WallMotion<2> &wall) const
  {
    return plan.dt * (wall.velocity * wall.normal + wall.slide * wall.tangent());
  }
  std::vector<FrameState::Vector> ways_of_bodies() const;
  double largest_way() const;
  void move_free_walls();
  void find_free_walls();
  double unbalanced_free_walls() const;
  bool evaluate(const Vectors &way);
  void measure();
  bool converged() const;
  std::string iterate();
  void assemble();
  unsigned int factorise();

  const Problem &problem;
  const State &state;
  Workspace &work;
  const StepPlan &plan;
  std::vector<WallMotion<2>> &motion;
  const double h;
  std::optional<CellMotion> cell;
  StepEquations equations;
  FrameScene scene;
  std::vector<FrameState> frames;
  RayForces force, rubbing; ///< normal forces and friction of rays [N/m]
  FrameSystem system;
  Vectors zero, way, trial, displacement;
  double residual = 0.; ///< largest unbalanced force of a body over the largest force on one
  double deepest = 0.;  ///< largest gap of a pressed ray, or overlap of another one [m]
  bool right_inertia = false;
  double path = 0.; ///< no place has moved by more than this, all iterations summed [m]
};

/// By which bodies move beside what their nodes do, see FrameScene::carried.
std::vector<FrameState::Vector> RayStep::ways_of_bodies() const
{
  std::vector<FrameState::Vector> ways(state.bodies.size());
  for (const Body<2> &body : state.bodies)
    if (body.driven)
      ways[body.index] = plan.dt * work.drive[body.index];
    else if (cell)
      ways[body.index] = plan.dt * cell->velocity(body.center());
  return ways;
}

/// The largest by which something that is no unknown brings two places nearer [m].
double RayStep::largest_way() const
{
  double way = 0.;
  for (const WallMotion<2> &wall : motion)
    way = std::max(way, way_of(wall).norm());
  for (const Body<2> &body : state.bodies)
    if (body.driven)
      way = std::max(way, plan.dt * work.drive[body.index].norm());
  return way;
}

/// Puts walls under loads where they have come to.
void RayStep::move_free_walls()
{
  std::vector<FreeWall<2>> &list = work.contact.free_walls.list;
  for (unsigned int w = 0; w < list.size(); ++w)
    list[w].speed = system.ways[w].at / plan.dt;
  if (list.empty())
    return;
  settle_free_walls(problem, state, work, motion);
  cell = state.cell_motion(motion);
  scene.carried = ways_of_bodies();
}

bool RayStep::evaluate(const Vectors &to)
{
  move_free_walls();
  trial.resize(to.size());
  displacement.resize(to.size());
  for (unsigned int b = 0; b < to.size(); ++b)
  {
    trial[b] = to[b] / plan.dt;
    displacement[b] = state.bodies[b].displacement + to[b];
  }
  if (!equations.evaluate(trial))
    return false;
  dealii::TimerOutput::Scope section(*work.timer, "contact search");
  std::vector<char> met(frames.size(), 1);
  parallel_for(frames.size(), 4,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t f = begin; f < end; ++f)
                 {
                   const unsigned int w = frames[f].layout().wall;
                   met[f] =
                       frames[f].evaluate(scene, displacement, to,
                                          w == FrameState::none ? FrameState::Vector() : way_of(motion[w]),
                                          force[f], path, candidates_within * h + largest_way());
                 }
               });
  return std::find(met.begin(), met.end(), 0) == met.end();
}

void RayStep::measure()
{
  double worst = 0., scale = 0., wrong_friction = 0.;
  deepest = 0.;
  Vectors contact(way.size());
  for (unsigned int b = 0; b < way.size(); ++b)
    contact[b].setZero(way[b].size());
  for (unsigned int f = 0; f < frames.size(); ++f)
  {
    const FrameState &frame = frames[f];
    const double tau = frame.tangential(force[f]);
    for (unsigned int side = 0; side < 2; ++side)
    {
      const unsigned int b = frame.unknown(side);
      if (b == FrameState::none)
        continue;
      const auto add = [&](const unsigned int node, const FrameState::Vector &value)
      {
        for (unsigned int d = 0; d < 2; ++d)
          contact[b][2 * node + d] += value[d];
      };
      for (unsigned int k = 0; k < frame.n_rays(); ++k)
      {
        if (force[f][k] > 0.)
          frame.for_gradient(k, side, force[f][k], add);
        if (rubbing[f][k] != 0.)
          frame.for_slide(k, side, rubbing[f][k], add);
      }
      frame.for_mean(side, -tau, add);
    }
    for (unsigned int k = 0; k < frame.n_rays(); ++k)
      if (frame.ray(k).met)
      {
        const double gap = frame.free_gap(k) + frame.ray_softness() * force[f][k];
        deepest = std::max(deepest, force[f][k] > 0. ? std::abs(gap) : -gap);
        if (!frame.rubs(k) || !(force[f][k] > 0.))
          continue;
        const double most = frame.ray(k).bound * force[f][k],
                     slide = frame.free_slide(k) + frame.ray_softness() * rubbing[f][k];
        wrong_friction = std::max(wrong_friction, std::abs(rubbing[f][k]) - most);
        // Friction below its bound holds.
        if (std::abs(rubbing[f][k]) < (1. - 1e-6) * most)
          deepest = std::max(deepest, std::abs(slide));
      }
  }
  for (unsigned int b = 0; b < way.size(); ++b)
  {
    if (state.bodies[b].driven)
      continue;
    worst = std::max(worst, (equations.missing(b) / plan.dt + contact[b]).norm());
    scale = std::max({scale, contact[b].norm(), equations.internal[b].norm(),
                      1e-8 * state.bodies[b].law->wave_modulus() * h});
  }
  for (const FreeWay &free : system.ways)
    scale = std::max(scale, std::abs(free.load));
  residual = std::max({worst, wrong_friction, unbalanced_free_walls()}) / scale;
}

bool RayStep::converged() const
{
  return residual < problem.settings.residual_tolerance && deepest < gap_tolerance * h && right_inertia;
}

void RayStep::assemble()
{
  dealii::TimerOutput::Scope section(*work.timer, "assembly");
  std::vector<std::vector<std::pair<unsigned int, unsigned int>>> of_body(way.size());
  for (unsigned int f = 0; f < frames.size(); ++f)
    for (unsigned int side = 0; side < 2; ++side)
      if (frames[f].unknown(side) != FrameState::none)
        of_body[frames[f].unknown(side)].emplace_back(f, side);
  work.share.for_mine(state.bodies,
                      [&](const Body<2> &body)
                      {
                        const unsigned int b = body.index;
                        equations.assemble_static(body);
                        Eigen::MatrixXd block;
                        for (const auto &[f, side] : of_body[b])
                          for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
                            if (force[f][k] > 0.)
                            {
                              const RaySide<2> &ray = frames[f].ray(k).side[side];
                              const double factor = (side == 0 ? 1. : -1.) * force[f][k] * plan.dt * plan.dt;
                              ray.second_derivative(block);
                              work.matrices[b].add_cell<2>(
                                  ray.function.cell,
                                  [&](const unsigned int i, const unsigned int d, const unsigned int j,
                                      const unsigned int e) { return block(2 * i + d, 2 * j + e); },
                                  factor);
                            }
                      });
}

unsigned int RayStep::factorise()
{
  dealii::TimerOutput::Scope section(*work.timer, "factorisation");
  std::vector<unsigned int> negative(way.size(), 0);
  work.share.for_mine(state.bodies,
                      [&](const Body<2> &body)
                      {
                        RankOneSolver &solver = *work.solvers[body.index];
                        solver.takes_indefinite = true;
                        if (!solver.factorize(work.matrices[body.index]))
                          negative[body.index] = 1000;
                        else
                          negative[body.index] = solver.n_negative().value_or(0);
                      });
  unsigned int sum = 0;
  for (const unsigned int n : negative)
    sum += n;
  return sum;
}

std::string RayStep::iterate()
{
  Vectors direction = zero, y(way.size());
  for (unsigned int attempt = 0;; ++attempt)
  {
    assemble();
    const unsigned int negative = factorise();
    bool solved = negative < 1000;
    int wrong = 1000;
    if (solved)
    {
      {
        dealii::TimerOutput::Scope section(*work.timer, "linear solves");
        work.share.for_mine(state.bodies,
                            [&](const Body<2> &body)
                            {
                              work.solvers[body.index]->solve(equations.missing(body.index), y[body.index]);
                              y[body.index] *= plan.dt;
                            });
      }
      {
        dealii::TimerOutput::Scope section(*work.timer, "condensation");
        // In the first iteration walls have moved and bodies have not.
        system.condense(scene, frames, force, rubbing,
                        candidates_within * h + (outcome.newton_iterations == 0 ? largest_way() : 0.));
      }
      dealii::TimerOutput::Scope section(*work.timer, "contact solve");
      solved = system.solve(y, h, negative);
      wrong = system.wrong_inertia(negative);
    }
    if (wrong == 0 && solved)
    {
      right_inertia = true;
      break;
    }
    if (attempt == most_rises)
      return "no forces of contacts are found";
    outcome.raised *= rise;
    equations.resist_more(rise);
    if (!evaluate(way))
      return equations.why_not();
  }
  {
    dealii::TimerOutput::Scope section(*work.timer, "linear solves");
    work.share.for_mine(state.bodies,
                        [&](const Body<2> &body)
                        {
                          const unsigned int b = body.index;
                          work.solvers[b]->solve(equations.missing(b) + plan.dt * system.force_on(b),
                                                 direction[b]);
                          direction[b] *= plan.dt;
                        });
  }
  double largest = 0.;
  for (const Eigen::VectorXd &d : direction)
    largest = std::max(largest, d.lpNorm<Eigen::Infinity>());
  std::vector<double> gone;
  for (unsigned int w = 0; w < system.ways.size(); ++w)
  {
    gone.push_back(system.ways[w].at);
    largest = std::max(largest, std::abs(system.found_ways[w] - gone[w]));
  }
  double share = std::min(1., longest_way * h / largest);
  const RayForces before = force, rubbed = rubbing;
  const Vectors from = way;
  for (unsigned int halving = 0;; ++halving, share *= 0.5)
  {
    if (halving == most_halvings)
      return "no way along Newton's direction: " + equations.why_not();
    path += share * largest;
    for (unsigned int b = 0; b < way.size(); ++b)
      way[b] = from[b] + share * direction[b];
    for (unsigned int f = 0; f < force.size(); ++f)
      for (unsigned int k = 0; k < force[f].size(); ++k)
      {
        force[f][k] = before[f][k] + share * (system.found[f][k] - before[f][k]);
        rubbing[f][k] = rubbed[f][k] + share * (system.found_rubbing[f][k] - rubbed[f][k]);
      }
    for (unsigned int w = 0; w < gone.size(); ++w)
      system.ways[w].at = gone[w] + share * (system.found_ways[w] - gone[w]);
    if (evaluate(way))
      break;
  }
  measure();
  return "";
}

/// Walls under loads become unknowns.
void RayStep::find_free_walls()
{
  const PeriodicCell<2> *repeats = cell ? &cell->cell : nullptr;
  for (const FreeWall<2> &free : work.contact.free_walls.list)
  {
    const Wall &wall = state.walls[free.wall];
    const double load = free.slides() ? wall.slide_load : wall.load, net = load + wall.force * free.way;
    // The spring is that of bodies that resist no more than they must.
    system.ways.emplace_back(
        free, wall.body == Wall::no_body ? FrameState::none : wall.body, wall.repeats() ? repeats : nullptr,
        std::abs(net) < 0.5 * std::abs(load) ? 0. : net, load, problem.settings.wall_motion * h,
        free.mass / (plan.dt * plan.dt) * problem.settings.regularisation / plan.regularisation);
  }
}

/// The largest force that a wall under a load lacks, those at their stops apart [N/m].
double RayStep::unbalanced_free_walls() const
{
  double worst = 0.;
  for (const FreeWay &way : system.ways)
  {
    if (way.stopped != 0)
      continue;
    double sum = way.load - way.stiffness * way.at;
    for (unsigned int f = 0; f < frames.size(); ++f)
    {
      const auto moves = way.moves(scene, frames[f]);
      for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
        if (force[f][k] > 0.)
          sum += force[f][k] * frames[f].gap_by(k, moves) + rubbing[f][k] * frames[f].slide_by(k, moves);
      sum -= frames[f].tangential(force[f]) * frames[f].motion_by(moves);
    }
    worst = std::max(worst, std::abs(sum));
  }
  return worst;
}

std::string RayStep::find()
{
  find_free_walls();
  outcome.unsolved = true;
  for (const Body<2> &body : state.bodies)
    zero.push_back(Eigen::VectorXd::Zero(body.field.n_dofs()));
  way = zero;
  {
    dealii::TimerOutput::Scope section(*work.timer, "contact search");
    const std::vector<ContactFrame<2>> laid = find_frames(scene, state.frames);
    for (const ContactFrame<2> &frame : laid)
    {
      frames.emplace_back(frame, scene);
      force.emplace_back();
      rubbing.emplace_back();
      for (const auto &ray : frame.rays)
      {
        force.back().push_back(ray.force);
        rubbing.back().push_back(ray.friction);
      }
    }
  }
  path = h; // 0 is for rays that have never been met
  if (!evaluate(way))
    return equations.why_not();
  measure();
  for (outcome.newton_iterations = 0;; ++outcome.newton_iterations)
  {
    stop_if_interrupted();
    if (outcome.newton_iterations > 0 && converged())
      break;
    if (outcome.newton_iterations == problem.settings.max_newton)
      return "Newton did not converge in " + std::to_string(problem.settings.max_newton) +
             " iterations ('Newton/Maximum iterations'); relative residual " + short_number(residual);
    if (std::string trouble = iterate(); !trouble.empty())
      return trouble;
  }
  outcome.newton_residual = residual;
  outcome.unsolved = false;
  outcome.max_penetration = deepest;
  outcome.contact_sweeps = system.passes;
  return judge_step(problem, state, work, motion, plan.dt, equations.increment, outcome);
}

void RayStep::accept(State &state_to_change)
{
  ContactMemory<2> memory;
  memory.step = plan.dt;
  std::vector<ContactRow<2>> rows = rows_of_frames(scene, frames, force, rubbing, memory);
  work.contact.held = false; // dents are those of the frames
  work.contact.reinit(std::move(rows), work.share, false, state.bodies, plan.dt, &memory);
  Vectors rate(way.size());
  FoundStep found{plan,
                  motion,
                  trial,
                  equations.internal,
                  equations.increment,
                  rate,
                  plan.held ? equations.external
                            : external_forces(state.bodies, work.share, problem.scene.gravity,
                                              state.time + 0.5 * plan.dt), // for their work
                  std::vector<double>(way.size(), 0.),
                  0.,
                  {}};
  state_to_change.held_back.resize(way.size());
  for (unsigned int b = 0; b < way.size(); ++b)
  {
    rate[b] = way[b] / plan.dt;
    const bool driven = state.bodies[b].driven;
    found.regularisation_work += driven ? 0. : equations.regularisation_work(b);
    found.resistance.push_back(driven ? FrameState::Vector() : equations.resistance(b));
    state_to_change.held_back[b] = driven ? 0. : equations.held_back(b);
    outcome.largest_move = std::max(outcome.largest_move, way[b].lpNorm<Eigen::Infinity>());
  }
  std::vector<ContactFrame<2>> &kept = state_to_change.frames;
  kept.clear();
  for (unsigned int f = 0; f < frames.size(); ++f)
    kept.push_back(frames[f].after(force[f], rubbing[f]));
  accept_step(problem, state_to_change, work, found);
}
} // namespace

StepOutcome ray_step(const Problem &problem, State &state, Workspace &work, const StepPlan &plan)
{
  std::vector<WallMotion<2>> motion = begin_step(problem, state, work, plan);
  renew_outlines(state.bodies, work.outlines, state.frames);
  RayStep step(problem, state, work, plan, motion);
  step.outcome.reason = step.find();
  step.outcome.accepted = step.outcome.reason.empty();
  if (step.outcome.accepted)
    step.accept(state);
  return step.outcome;
}
} // namespace softgrain::mpm
