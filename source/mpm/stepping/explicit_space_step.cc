// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/contact_system.h>
#include <softgrain/mpm/contact/frame_rows.h>
#include <softgrain/mpm/contact/told_rays.h>
#include <softgrain/mpm/stepping/explicit_space_step.h>
#include <softgrain/mpm/stepping/moving_step.h>
#include <softgrain/mpm/stepping/refused_step.h>

#include <algorithm>
#include <utility>

namespace softgrain::mpm
{
namespace
{
constexpr double margin = 0.05; ///< gap beyond what bodies close up to which a ray has a row [cells]

/// The forces of a step that solves no equations: velocities at its end are known from what it begins with.
class ExplicitEquations final : public SpaceEquations
{
public:
  ExplicitEquations(const std::vector<Body<3>> &bodies,
                    const Settings &settings,
                    SpaceWorkspace &work,
                    const StepPlan &plan,
                    const double time)
      : SpaceEquations(bodies, settings, work, plan, time, false)
  {
  }

private:
  void find_missing(const Body<3> &, const Eigen::VectorXd &) override {}
};

/// Symplectic Euler: impulses of rays on the velocities that forces at the start leave.
class ExplicitSpaceStep final : public MovingStep
{
public:
  ExplicitSpaceStep(SpaceState &state,
                    const SpaceScene &space,
                    SpaceMotion &motion,
                    const StepPlan &plan,
                    ExplicitEquations &equations)
      : MovingStep(state, space, motion, plan, equations)
      , state(state)
      , settings(space.settings)
      , timer(*space.work.timer)
      , equations(equations)
      , never_moved(state.bodies.size(), dealii::Tensor<1, 3>())
  {
  }

private:
  std::string find_ways() override;
  Eigen::VectorXd forces_on(unsigned int b) const override;
  /// Impulses act between the velocities before and after, which makes the balance of symplectic Euler exact
  /// up to the stored energy.
  Eigen::VectorXd way_at_work(const unsigned int b) const override
  {
    return 0.5 * (way[b] + plan.dt * state.bodies[b].nodes.velocity);
  }
  std::array<double, 2> end(const Body<3> &) override { return {{0., 0.}}; }

  void meet_halfway();
  void find_rows();
  void add_row(unsigned int f, unsigned int k, std::vector<ContactRow<3>> &rows, ContactMemory<3> &memory);
  void push(const Body<3> &body, const Eigen::VectorXd &forces);
  void push_freely();
  std::string solve_contacts();
  void take_impulses();

  const SpaceState &state;
  const Settings &settings;
  dealii::TimerOutput &timer;
  ExplicitEquations &equations;
  ContactSystem<3> contact;
  double within = 0.;                                     ///< gap up to which a ray has a row [m]
  const std::vector<dealii::Tensor<1, 3>> never_moved;    ///< as no body is driven
  std::vector<std::pair<unsigned int, unsigned int>> ray; ///< of every row: frame and number
};

/// Rays meet the bodies where they are halfway if they keep their velocities. They know first where they are
/// when the step begins.
void ExplicitSpaceStep::meet_halfway()
{
  lay();
  const Vectors ahead = free_way();
  double of_bodies = 0.;
  for (const Eigen::VectorXd &gone : ahead)
  {
    path = std::max(path, h + gone.lpNorm<Eigen::Infinity>());
    of_bodies = std::max(of_bodies, gone.lpNorm<Eigen::Infinity>());
  }
  within = margin * h + largest_way() + 2. * of_bodies;
  dealii::TimerOutput::Scope section(timer, "contact rays");
  for (const Vectors &gone : {at_rest, ahead})
  {
    Vectors displacement;
    for (const Body<3> &body : state.bodies)
      displacement.push_back(body.nodes.displacement + scene.instants.met_at * gone[body.index]);
    meet_frames(world.share, scene, force, displacement, gone, path, within, frames);
  }
}

void ExplicitSpaceStep::add_row(const unsigned int f,
                                const unsigned int k,
                                std::vector<ContactRow<3>> &rows,
                                ContactMemory<3> &memory)
{
  const FrameState<3> &frame = frames[f];
  const FrameState<3>::RayHere &here = frame.ray(k);
  if (!here.met || !here.near || !(here.gap < within || force[f][k] != 0.))
    return;
  const ContactFrame<3> &layout = frame.layout();
  const dealii::Tensor<1, 3> resultant = frame.derivatives().resultant(k);
  ContactRow<3> row;
  row.body = layout.body;
  row.partner = layout.partner;
  row.wall = layout.wall;
  row.normal = resultant / resultant.norm();
  row.place = here.side[1].place.position;
  tell_row(scene, frame, k, row);
  if (layout.partner == none)
    row.velocity_of_place = way_of_partner(frame, k) / plan.dt;
  row.key = rows.size();
  const dealii::Tensor<1, 3> given = force_on_body(f, k);
  for (unsigned int c = 0; c < 3; ++c)
    memory.impulses[row.key][c] = plan.dt * (given * direction_of(row, c));
  ray.emplace_back(f, k);
  rows.push_back(std::move(row));
}

void ExplicitSpaceStep::find_rows()
{
  std::vector<ContactRow<3>> rows;
  ContactMemory<3> memory;
  memory.step = plan.dt;
  for (unsigned int f = 0; f < frames.size(); ++f)
    for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
      add_row(f, k, rows, memory);
  contact.reinit(std::move(rows), world.share, true, state.bodies, plan.dt, memory);
}

/// What forces do to the velocities of a body in the step.
void ExplicitSpaceStep::push(const Body<3> &body, const Eigen::VectorXd &forces)
{
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    trial[body.index].segment<3>(3 * i) += plan.dt / body.nodes.mass[i] * forces.segment<3>(3 * i);
}

/// What forces and loads do to the velocities in the step, without contact.
void ExplicitSpaceStep::push_freely()
{
  trial.resize(state.bodies.size());
  world.share.for_mine(state.bodies,
                       [&](const Body<3> &body)
                       {
                         const unsigned int b = body.index;
                         Eigen::VectorXd pushes = body.nodes.internal_force;
                         if (equations.external[b].size() > 0)
                           pushes += equations.external[b];
                         trial[b] = body.nodes.velocity;
                         push(body, pushes);
                       });
}

/// An open gap may close, but no further; a closed one holds at velocity level.
std::string ExplicitSpaceStep::solve_contacts()
{
  if (contact.empty())
    return "";
  dealii::TimerOutput::Scope section(timer, "contact solve");
  contact.lump(state.bodies, plan.dt);
  std::vector<double> relative =
      contact.relative_velocity(world.share, state.bodies, never_moved,
                                [this](const unsigned int b) -> const Eigen::VectorXd & { return trial[b]; });
  const unsigned int n = contact.n_components();
  const auto &rows = contact.contact_rows();
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    for (unsigned int c = 0; c < n && rows[r].velocity_of_place; ++c)
      relative[r * n + c] -= *rows[r].velocity_of_place * direction_of(rows[r], c);
    relative[r * n] += std::max(0., rows[r].gap) / plan.dt;
  }
  take_back_softness(contact, plan.dt, relative);
  const contact::SolverReport report = contact.solve(std::move(relative), settings.contact_solver);
  outcome.contact_sweeps = report.sweeps;
  outcome.contact_residual = report.residual;
  return report.converged ? "" : not_solved(report);
}

/// Forces of rays add up to those of their rows.
void ExplicitSpaceStep::take_impulses()
{
  for (std::vector<double> &of_frame : force)
    std::fill(of_frame.begin(), of_frame.end(), 0.);
  for (auto &of_frame : rubbing)
    std::fill(of_frame.begin(), of_frame.end(), Across());
  const std::vector<double> &P = contact.impulses();
  const unsigned int n = contact.n_components();
  const auto &rows = contact.contact_rows();
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    const auto [f, k] = ray[r];
    const double opened = plan.dt * contact.velocities()[r * n];
    outcome.max_penetration = std::max(outcome.max_penetration, -(std::min(0., rows[r].gap) + opened));
    const dealii::Tensor<1, 3> resultant = frames[f].derivatives().resultant(k);
    force[f][k] = P[r * n] / (plan.dt * resultant.norm());
    if (!frames[f].conditions().rubs(k))
      continue;
    dealii::Tensor<1, 3> given;
    for (unsigned int c = 0; c < n; ++c)
      given += P[r * n + c] / plan.dt * direction_of(rows[r], c);
    // Friction of a ray lies across what its normals were when the step began: a little along the resultant.
    dealii::Tensor<2, 3> directions;
    for (unsigned int d = 0; d < 3; ++d)
    {
      directions[d][0] = resultant[d];
      for (unsigned int m = 0; m < 2; ++m)
        directions[d][1 + m] = frames[f].ray(k).rub.e[m][d];
    }
    const dealii::Tensor<1, 3> parts = invert(directions) * given;
    force[f][k] = parts[0];
    rubbing[f][k] = Across({parts[1], parts[2]});
  }
}

Eigen::VectorXd ExplicitSpaceStep::forces_on(const unsigned int b) const
{
  Eigen::VectorXd impulse = at_rest[b];
  contact.add_impulses(b, impulse);
  return impulse / plan.dt;
}

std::string ExplicitSpaceStep::find_ways()
{
  meet_halfway();
  find_rows();
  push_freely();
  if (std::string trouble = or_why_it_failed([this]() { return solve_contacts(); }); !trouble.empty())
    return trouble;
  take_impulses();
  way = at_rest;
  world.share.for_mine(
      state.bodies,
      [&](const Body<3> &body)
      {
        const unsigned int b = body.index;
        push(body, forces_on(b));
        way[b] = plan.dt * trial[b];
      },
      [&](BodyShare::Message &message)
      {
        for (const Body<3> &body : state.bodies)
          message.add(body.index, way[body.index].data(), way[body.index].size());
      });
  return equations.evaluate(trial) ? "" : equations.why_not();
}
} // namespace

StepOutcome
explicit_space_step(SpaceState &state, const SpaceScene &scene, const SpaceMotion &motion, const double dt)
{
  const StepPlan plan{dt, false, 0.};
  ExplicitEquations equations(state.bodies, scene.settings, scene.work, plan, state.time);
  SpaceMotion planned = motion;
  ExplicitSpaceStep step(state, scene, planned, plan, equations);
  return try_ray_step(step, state);
}
} // namespace softgrain::mpm
