// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/told_rays.h>
#include <softgrain/mpm/stepping/ray_equations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
/// Over the largest force, of one that is none. Where a body yields to another that comes nearer, their force
/// falls in each held step, until it is what rounding leaves of forces between 1e-16 and 1e-20 of the
/// largest.
constexpr double no_force = 1e-12;
} // namespace

template <int dim>
RayEquations<dim>::RayEquations(const RayWorld<dim> &world,
                                const StepPlan &plan,
                                BodyEquations<dim> &equations)
    : world(world)
    , plan(plan)
    , h(world.cell_size)
    , inertia(!world.settings.scheme.ends_in_balance())
    , theta(world.settings.scheme.theta)
    , equations(equations)
    , scene{world.bodies, world.surfaces, world.motion, h, world.subgrid, 0.5 * h}
    , system(world.share, world.bodies, world.solvers, theta * plan.dt * plan.dt)
{
  scene.dt = plan.dt;
  scene.instants.met_at = inertia ? 0.5 : 1.;
  scene.instants.theta = theta;
  scene.reach += 2. * walls_way();
}

template <int dim>
void RayEquations<dim>::lay()
{
  find_free_walls();
  for (const Body<dim> &body : world.bodies)
    at_rest.push_back(Eigen::VectorXd::Zero(body.field.n_dofs()));
  way = at_rest;
  dealii::TimerOutput::Scope section(world.timer, "contact search");
  scene.looking = &world.share;
  const std::vector<ContactFrame<dim>> found = find_frames(scene, world.frames);
  frames.reserve(found.size());
  force.reserve(found.size());
  rubbing.reserve(found.size());
  for (const ContactFrame<dim> &frame : found)
  {
    frames.emplace_back(frame, scene);
    force.emplace_back(frame.rays.size());
    rubbing.emplace_back(frame.rays.size());
  }
  softest_pair = std::numeric_limits<double>::max();
  for (const FrameState<dim> &frame : frames)
    softest_pair = std::min(softest_pair, frame.conditions().stiffness());
  take_forces_of_start();
  system.take(frames);
  path = h; // 0 is for rays that have never been met
}

template <int dim>
void RayEquations<dim>::take_forces_of_start()
{
  for (unsigned int f = 0; f < frames.size(); ++f)
    for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
    {
      force[f][k] = frames[f].conditions().start_force(k);
      rubbing[f][k] = frames[f].ray(k).left ? Across() : frames[f].layout().rays[k].friction;
    }
}

template <int dim>
typename RayEquations<dim>::Vectors RayEquations<dim>::free_way() const
{
  Vectors ways = at_rest;
  for (const Body<dim> &body : world.bodies)
    if (const Eigen::VectorXd &rate = inertia ? body.nodes.velocity : body.nodes.kept;
        !body.rigid.driven && rate.size() > 0)
      ways[body.index] = plan.dt * rate;
  return ways;
}

template <int dim>
double RayEquations<dim>::walls_way() const
{
  double way = 0.;
  for (unsigned int w = 0; w < scene.walls.size(); ++w)
    way = std::max(way, way_of_wall(scene, w).norm());
  return way;
}

template <int dim>
bool RayEquations<dim>::evaluate(const Vectors &to)
{
  move_free_walls();
  trial.resize(to.size());
  for (const Body<dim> &body : world.bodies)
    if (!body.rigid.driven && world.share.mine(body.index))
      trial[body.index] = equations.end_velocity(body, to[body.index]);
  not_met = none;
  return equations.evaluate(trial) && meet(to);
}

template <int dim>
bool RayEquations<dim>::meet(const Vectors &to)
{
  displacement.resize(to.size());
  for (unsigned int b = 0; b < to.size(); ++b)
    displacement[b] = world.bodies[b].nodes.displacement + scene.instants.met_at * to[b];
  dealii::TimerOutput::Scope section(world.timer, "contact rays");
  meet_frames(world.share, scene, force, displacement, to, path, 2. * candidates_within() + largest_way(),
              frames);
  for (unsigned int f = 0; f < frames.size() && not_met == none; ++f)
    if (!frames[f].meets(force[f]))
      not_met = f;
  return not_met == none;
}

template <int dim>
bool RayEquations<dim>::leave_unmet_rays()
{
  bool any = false;
  for (unsigned int f = 0; f < frames.size(); ++f)
    any = frames[f].leave_unmet(force[f], rubbing[f]) || any;
  return any;
}

template <int dim>
std::string RayEquations<dim>::why_not() const
{
  if (not_met == none)
    return equations.why_not();
  const ContactFrame<dim> &frame = frames[not_met].layout();
  std::ostringstream text;
  text << "body '" << world.bodies[frame.body].name << "' and " << partner_of(frame)
       << "' turn away from where they press each other, near (" << frame.origin << ") m";
  return text.str();
}

/// What rays do to the nodes of a body.
template <int dim>
Eigen::VectorXd RayEquations<dim>::contact_forces(const unsigned int b) const
{
  Eigen::VectorXd contact = at_rest[b];
  const auto add = [&](const unsigned int node, const Vector &value)
  {
    for (unsigned int d = 0; d < dim; ++d)
      contact[dim * node + d] += value[d];
  };
  for (const auto &[f, side] : system.frames_of[b])
  {
    const FrameState<dim> &frame = frames[f];
    const FrameDerivatives<dim> derivatives = frame.derivatives();
    for (unsigned int k = 0; k < frame.n_rays(); ++k)
    {
      if (force[f][k] != 0.)
        derivatives.for_gradient(k, side, force[f][k], add);
      if (rubbing[f][k] != Across())
        derivatives.for_slide(k, side, rubbing[f][k], add);
    }
    const typename FrameState<dim>::Across tangential = derivatives.tangential(force[f]);
    for (unsigned int m = 0; m < dim - 1; ++m)
      derivatives.for_mean(side, m, -tangential[m], add);
  }
  return contact;
}

/// How far the rays of a frame are from their conditions.
template <int dim>
void RayEquations<dim>::measure_frame(const unsigned int f, double &wrong_friction)
{
  const FrameState<dim> &frame = frames[f];
  const FrameConditions<dim> conditions = frame.conditions();
  const double harder = conditions.stiffness() / softest_pair;
  const auto note = [&](const double off)
  {
    deepest = std::max(deepest, off);
    deepest_by_force = std::max(deepest_by_force, harder * off);
  };
  for (unsigned int k = 0; k < frame.n_rays(); ++k)
  {
    if (!frame.ray(k).met)
      continue;
    const double gap = conditions.free_gap(k) + conditions.ray_softness() * force[f][k];
    const bool closed = conditions.closed(k, force[f][k]);
    note(closed ? std::abs(gap) : -gap);
    if (!conditions.rubs(k) || !closed)
      continue;
    const double most = conditions.most_friction(k, force[f][k]), rubs = rubbing[f][k].norm();
    Across slide = conditions.free_slide(k) + conditions.ray_softness() * rubbing[f][k];
    wrong_friction = std::max(wrong_friction, rubs - most);
    if (frame.ray(k).rub.keeps)
      continue;
    // Friction below its bound holds; at its bound it holds across its own direction.
    if (rubs >= (1. - 1e-6) * most)
      slide -= rubs > 0. ? Across((slide * rubbing[f][k]) / (rubs * rubs) * rubbing[f][k]) : slide;
    note(slide.norm());
  }
}

/// Root of the sum of squares of the momentum of all nodes [N s/m].
template <int dim>
double RayEquations<dim>::momentum_of_nodes(const Body<dim> &body) const
{
  double sum = 0.;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    sum += (body.nodes.mass[i] * body.nodes.velocity.template segment<dim>(dim * i)).squaredNorm();
  return std::sqrt(sum);
}

template <int dim>
void RayEquations<dim>::measure()
{
  double worst = 0., scale = 0., wrong_friction = 0.;
  deepest = deepest_by_force = 0.;
  for (unsigned int f = 0; f < frames.size(); ++f)
    measure_frame(f, wrong_friction);
  // Of every body what is unbalanced, and the largest force on it.
  const auto measured = world.share.template numbers<2>(
      world.bodies,
      [&](const Body<dim> &body)
      {
        const unsigned int b = body.index;
        const Eigen::VectorXd contact = contact_forces(b);
        double largest = std::max({contact.norm(), equations.internal[b].norm(),
                                   1e-8 * body.material.law->wave_modulus() * (dim == 2 ? h : h * h)});
        if (inertia)
          largest =
              std::max({largest, 1e-6 / plan.dt * momentum_of_nodes(body), equations.external[b].norm()});
        return std::array<double, 2>{(equations.missing(b) / plan.dt + contact).norm(), largest};
      });
  for (const auto &[unbalanced, largest] : measured)
  {
    worst = std::max(worst, unbalanced);
    scale = std::max(scale, largest);
  }
  for (const FreeWay<dim> &free : system.ways)
    scale = std::max(scale, std::abs(free.load));
  residual = std::max({worst, wrong_friction, unbalanced_free_walls()}) / scale;
}

template <int dim>
std::vector<ContactFrame<dim>> RayEquations<dim>::frames_after() const
{
  double largest = 0.;
  for (const std::vector<double> &of_frame : force)
    for (const double of_ray : of_frame)
      largest = std::max(largest, std::abs(of_ray));
  std::vector<ContactFrame<dim>> result;
  for (unsigned int f = 0; f < frames.size(); ++f)
  {
    std::vector<double> normal = force[f];
    std::vector<Across> friction = rubbing[f];
    for (unsigned int k = 0; k < normal.size(); ++k)
      if (std::abs(normal[k]) <= no_force * largest)
      {
        normal[k] = 0.;
        friction[k] = Across();
      }
    result.push_back(frames[f].after(scene, normal, friction));
  }
  return result;
}

template <int dim>
bool RayEquations<dim>::at_rounding() const
{
  const auto beyond = world.share.template numbers<1>(
      world.bodies,
      [&](const Body<dim> &body)
      {
        const unsigned int b = body.index;
        const Eigen::VectorXd contact = plan.dt * contact_forces(b);
        return std::array<double, 1>{(equations.missing(b) + contact).norm() -
                                     equations.rounding(body, contact.norm())};
      });
  return std::all_of(beyond.begin(), beyond.end(), [](const auto &of_body) { return of_body[0] <= 0.; });
}

template <int dim>
void RayEquations<dim>::assemble()
{
  dealii::TimerOutput::Scope section(world.timer, "assembly");
  world.share.for_mine(world.bodies,
                       [&](const Body<dim> &body)
                       {
                         const unsigned int b = body.index;
                         equations.assemble_exact(body);
                         Eigen::MatrixXd block;
                         for (const auto &[f, side] : system.frames_of[b])
                           for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
                             if (force[f][k] != 0.)
                             {
                               const RaySide<dim> &ray = frames[f].ray(k).side[side];
                               const double factor = (side == 0 ? 1. : -1.) * frames[f].derivatives().bend() *
                                                     force[f][k] * theta * plan.dt * plan.dt;
                               ray.second_derivative(block);
                               world.matrices[b].template add_cell<dim>(
                                   ray.function.cell,
                                   [&](const unsigned int i, const unsigned int d, const unsigned int j,
                                       const unsigned int e) { return block(dim * i + d, dim * j + e); },
                                   factor);
                             }
                       });
}

template <int dim>
std::optional<unsigned int> RayEquations<dim>::factorise()
{
  dealii::TimerOutput::Scope section(world.timer, "factorisation");
  constexpr double not_factorised = -1.;
  const auto told = world.share.template numbers<1>(
      world.bodies,
      [&](const Body<dim> &body)
      {
        BodySolver<dim> &solver = *world.solvers[body.index];
        if constexpr (dim == 2)
          solver.takes_indefinite = true;
        return std::array<double, 1>{
            solver.factorize(world.matrices[body.index]) ? solver.n_negative().value_or(0) : not_factorised};
      });
  unsigned int sum = 0;
  for (const auto &[negative] : told)
  {
    if (negative == not_factorised)
      return std::nullopt;
    sum += static_cast<unsigned int>(negative);
  }
  return sum;
}

/// The largest force that a wall under a load lacks, those at their stops apart [N/m].
template <int dim>
double RayEquations<dim>::unbalanced_free_walls() const
{
  double worst = 0.;
  for (const FreeWay<dim> &way : system.ways)
  {
    if (way.stopped != 0)
      continue;
    double sum = way.load - way.stiffness * way.at;
    for (unsigned int f = 0; f < frames.size(); ++f)
    {
      const auto moves = way.moves(scene, frames[f]);
      for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
        if (force[f][k] != 0.)
          sum += force[f][k] * frames[f].derivatives().gap_by(k, moves) +
                 rubbing[f][k] * frames[f].derivatives().slide_by(k, moves);
      sum -= frames[f].derivatives().tangential(force[f]) * frames[f].derivatives().motion_by(moves);
    }
    worst = std::max(worst, std::abs(sum));
  }
  return worst;
}

template class RayEquations<2>;
template class RayEquations<3>;
} // namespace softgrain::mpm
