// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/assembly.h>
#include <softgrain/mpm/external_force.h>
#include <softgrain/mpm/row_velocity.h>
#include <softgrain/mpm/whole_rotation.h>
#include <softgrain/mpm/world.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
using Vectors = std::vector<Eigen::VectorXd>;

std::string number(const double value)
{
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

/// Newton iterations of one implicit step; see doc/theory.md for the equations.
class ImplicitStep
{
public:
  ImplicitStep(World &world, const double dt)
      : world(world)
      , scheme(world.settings.scheme)
      , dt(dt)
      , theta(scheme.theta)
      , motion(world.wall_motion(dt))
      , n_bodies(world.bodies.size())
  {
  }

  StepOutcome run()
  {
    prepare();
    for (unsigned int b = 0; b < n_bodies; ++b)
      trial[b] = world.bodies[b].velocity;
    if (!evaluate(trial))
    {
      // A first guess that turns a point inside out is replaced by rest; if that fails too the step is too
      // long.
      for (Eigen::VectorXd &v : trial)
        v.setZero();
      if (!evaluate(trial))
        return reject(inside_out());
    }
    for (outcome.newton_iterations = 0;; ++outcome.newton_iterations)
    {
      if (outcome.newton_iterations > 0 && converged())
        return finish();
      if (outcome.newton_iterations == world.settings.max_newton)
        return reject("Newton did not converge in " + std::to_string(world.settings.max_newton) +
                      " iterations ('Newton/Maximum iterations'); relative residual " +
                      number(outcome.newton_residual));
      std::string trouble = newton_step();
      if (!trouble.empty())
        return reject(trouble);
    }
  }

private:
  StepOutcome reject(const std::string &reason)
  {
    outcome.accepted = false;
    outcome.reason = reason;
    return outcome;
  }

  bool moves(const unsigned int b) const { return !world.bodies[b].driven; }

  /// Forces at the start of the step, contact rows and their warm start.
  void prepare()
  {
    for (Vectors *list : {&trial, &increment, &old_force, &external, &free_residual, &direction, &rotation})
      list->resize(n_bodies);
    shift.assign(n_bodies, 0.);
    rotation_stiffness.assign(n_bodies, 0.);
    {
      dealii::TimerOutput::Scope section(*world.timer, "contact search");
      for (Wall &wall : world.walls)
        if (wall.body != ContactRow<2>::none)
          world.bodies[wall.body].drive =
              motion[&wall - world.walls.data()].velocity * wall.description.normal;
      std::vector<ContactRow<2>> rows;
      world.geometry->find({world.bodies, motion, world.scene.friction, dt, world.lattice->cell_size()},
                           rows);
      world.contact.reinit(std::move(rows), world.bodies);
    }
    for (unsigned int b = 0; b < n_bodies; ++b)
    {
      Body<2> &body = world.bodies[b];
      if (!moves(b))
      {
        increment[b] = Eigen::VectorXd::Zero(body.field.n_dofs());
        continue;
      }
      // Loads at the middle of the step: second order, and the same work whatever theta is. newmark takes
      // those at the end, (3.21), and has those at the start in the acceleration.
      if (!external_force(body, world.scene.gravity,
                          world.time + (scheme.stored_acceleration ? 1. : 0.5) * dt, external[b]))
        external[b].resize(0);
      if (scheme.stored_acceleration)
      {
        old_force[b] = body.acceleration;
        for (unsigned int i = 0; i < body.mass.size(); ++i)
          old_force[b].segment<2>(2 * i) *= body.mass[i];
      }
      else if (theta < 1.)
        old_force[b] = body.internal_force;
      else
        old_force[b] = Eigen::VectorXd::Zero(body.field.n_dofs());
      // Without inertia a body that touches nothing has no stiffness against rigid motion: a weak spring on
      // the Newton increment alone, which leaves the equations as they are.
      if (!scheme.inertia)
      {
        shift[b] = 1e-3 * dt * dt * body.law->young_modulus() / body.mass.sum();
        rotation[b] = whole_rotation(body);
        rotation_stiffness[b] = rotation_resistance(body);
      }
    }
    start_relative = world.contact.empty() ? std::vector<double>()
                                           : world.contact.relative_velocity(world.bodies, velocities());
  }

  Vectors velocities() const
  {
    Vectors list;
    for (const Body<2> &body : world.bodies)
      list.push_back(body.velocity);
    return list;
  }

  /// Stress and unbalanced impulse without contact for the end velocities @p v.
  bool evaluate(const Vectors &v)
  {
    dealii::TimerOutput::Scope section(*world.timer, "stress and forces");
    bad_body = n_bodies;
    for (unsigned int b = 0; b < n_bodies; ++b)
    {
      if (!moves(b))
        continue;
      Body<2> &body = world.bodies[b];
      increment[b] = dt * ((1. - theta) * body.velocity + theta * v[b]);
      const double half_dt = world.settings.grid_update == GridUpdate::every_step ? 0.5 * dt : 0.;
      const StressOutcome stress = evaluate_stress(body, Eigen::VectorXd(body.displacement + increment[b]),
                                                   increment[b], half_dt, {true, true});
      if (!stress.good())
      {
        bad_body = b;
        bad_point = stress.bad_point;
        return false;
      }
      Eigen::VectorXd force;
      internal_force(body, force);
      new_internal.resize(n_bodies);
      new_internal[b] = force;
      Eigen::VectorXd &R = free_residual[b];
      R = -dt * ((1. - theta) * old_force[b] + theta * force);
      if (external[b].size() > 0)
        // newmark's stored acceleration already holds the load at the start of the step.
        R -= dt * (scheme.stored_acceleration ? theta : 1.) * external[b];
      if (scheme.inertia)
        for (unsigned int i = 0; i < body.mass.size(); ++i)
          R.segment<2>(2 * i) += body.mass[i] * (v[b] - body.velocity).segment<2>(2 * i);
      else
        R += dt * dt * rotation_stiffness[b] * rotation[b].dot(v[b]) * rotation[b];
    }
    return true;
  }

  /// Impulse that is missing for balance at every node of a body [N s/m].
  Eigen::VectorXd unbalanced(const unsigned int b) const
  {
    Eigen::VectorXd R = -free_residual[b];
    world.contact.add_impulses(b, world.contact.impulses(), R);
    return R;
  }

  /// Norm of the unbalanced impulse with contact, over the largest impulse of the step.
  double residual_norm()
  {
    double sum = 0., scale = 0., floor = 0.;
    for (unsigned int b = 0; b < n_bodies; ++b)
    {
      if (!moves(b))
        continue;
      const Body<2> &body = world.bodies[b];
      Eigen::VectorXd R = Eigen::VectorXd::Zero(body.field.n_dofs());
      world.contact.add_impulses(b, world.contact.impulses(), R);
      scale = std::max({scale, R.norm(), dt * new_internal[b].norm()});
      if (scheme.inertia)
        for (unsigned int i = 0; i < body.mass.size(); ++i)
          floor = std::max(floor, body.mass[i] * body.velocity.segment<2>(2 * i).norm());
      if (external[b].size() > 0)
        scale = std::max(scale, dt * external[b].norm());
      sum += unbalanced(b).squaredNorm();
      // Stresses below this are rounding: of a strain of order one, or of a gradient of what has moved far.
      const double h = world.lattice->cell_size();
      const double moved = body.displacement.lpNorm<Eigen::Infinity>();
      scale = std::max(scale, std::max(1e-9, 1e-10 * moved / h) * dt * body.law->wave_modulus() * h);
    }
    scale = std::max(scale, 1e-6 * floor);
    return std::sqrt(sum) / scale;
  }

  bool converged()
  {
    outcome.newton_residual = residual_norm();
    if (outcome.newton_residual > world.settings.residual_tolerance)
      return false;
    // A body between frictionless walls may turn at no cost, so without inertia increments need not die out.
    if (!scheme.inertia)
      return true;
    // Lumped contact is an iteration of its own: the bulk may be balanced while the contact velocities are
    // not yet right.
    if (!world.contact.empty() && world.settings.coupling == ContactCoupling::lumped)
      return lumped_contact_converged();
    // (3.22), with the velocity increment in place of the displacement increment: they differ by theta dt. In
    // free flight the first increment is rounding already.
    double speed = 0.;
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (moves(b))
        speed += trial[b].squaredNorm();
    return last_length <= 1e-10 * std::sqrt(speed) ||
           (last_length <= world.settings.displacement_tolerance * first_length &&
            std::abs(last_work) <= world.settings.energy_tolerance * std::abs(first_work)) ||
           outcome.newton_residual <= 0.1 * world.settings.residual_tolerance;
  }

  /// (3.22) down to the rounding of the velocities; a step that starts near its solution has a small first
  /// increment.
  bool lumped_contact_converged() const
  {
    double size = 0.;
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (moves(b))
        size += trial[b].squaredNorm();
    return last_length <=
           std::max(world.settings.displacement_tolerance * first_length, 1e-10 * std::sqrt(size));
  }

  /// A = M + theta^2 dt^2 K of every body, factorised; shifted when it is not positive definite.
  std::string factorise()
  {
    for (unsigned int b = 0; b < n_bodies; ++b)
    {
      if (!moves(b))
        continue;
      Body<2> &body = world.bodies[b];
      double extra = shift[b];
      for (unsigned int attempt = 0;; ++attempt)
      {
        {
          dealii::TimerOutput::Scope section(*world.timer, "assembly");
          world.matrices[b].set_zero();
          add_stiffness(body, theta * theta * dt * dt, !scheme.inertia, world.matrices[b]);
          world.matrices[b].add_mass<2>(body.mass, (scheme.inertia ? 1. : 0.) + extra);
        }
        dealii::TimerOutput::Scope section(*world.timer, "factorisation");
        if (world.solvers[b]->factorize(world.matrices[b]))
          break;
        if (attempt == 6)
          return "the stiffness of body '" + body.name +
                 "' is not positive definite: it buckles or the step is too long ('Time/Time step')";
        extra = std::max(10. * extra, 1e-2 * dt * dt * body.law->young_modulus() / body.mass.sum());
      }
    }
    return "";
  }

  std::string newton_step()
  {
    std::string trouble;
    // Lumped contact goes on long after the bulk is balanced; then the factors of the iteration before serve
    // as well.
    const bool balanced =
        outcome.newton_iterations > 0 && outcome.newton_residual <= world.settings.residual_tolerance;
    if (world.settings.coupling == ContactCoupling::condensed || !balanced)
      trouble = factorise();
    if (!trouble.empty())
      return trouble;
    Vectors free(n_bodies);
    {
      dealii::TimerOutput::Scope section(*world.timer, "linear solves");
      for (unsigned int b = 0; b < n_bodies; ++b)
        if (moves(b))
        {
          world.solvers[b]->solve(Eigen::VectorXd(-free_residual[b]), direction[b]);
          free[b] = trial[b] + direction[b];
        }
    }
    if (!world.contact.empty())
    {
      trouble =
          world.settings.coupling == ContactCoupling::condensed ? contact_condensed(free) : contact_lumped();
      if (!trouble.empty())
        return trouble;
      dealii::TimerOutput::Scope section(*world.timer, "linear solves");
      for (unsigned int b = 0; b < n_bodies; ++b)
        if (moves(b))
        {
          world.solvers[b]->solve(unbalanced(b), direction[b]);
        }
    }
    return line_search();
  }

  std::string contact_condensed(const Vectors &free)
  {
    {
      dealii::TimerOutput::Scope section(*world.timer, "condensation");
      world.contact.condense(world.bodies, world.solvers);
    }
    return solve_contact(row_velocity(world, free, motion, start_relative, theta, dt), false);
  }

  std::string contact_lumped()
  {
    world.contact.lump(world.bodies);
    // The momentum balance at the present iterate, solved for the contact velocities with the masses alone.
    Vectors v = trial;
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (moves(b))
      {
        const Eigen::VectorXd R = unbalanced(b);
        for (unsigned int i = 0; i < world.bodies[b].mass.size(); ++i)
          v[b].segment<2>(2 * i) += R.segment<2>(2 * i) / world.bodies[b].mass[i];
      }
    return solve_contact(row_velocity(world, v, motion, start_relative, theta, dt), true);
  }

  std::string solve_contact(std::vector<double> q, const bool relative)
  {
    dealii::TimerOutput::Scope section(*world.timer, "contact solve");
    const contact::SolverReport report =
        world.contact.solve(std::move(q), world.settings.contact_solver, relative);
    outcome.contact_sweeps += report.sweeps;
    outcome.contact_residual = report.residual;
    // Rows denser than the nodes make W nearly singular, and with friction the sweeps may stand still a
    // little above the tolerance: the step is then right to five digits, its residual is reported, and
    // cutting it would not help.
    if (report.converged || report.limited_by_rounding ||
        report.residual <= 100. * world.settings.contact_solver.tolerance)
      return "";
    if (!world.settings.failed_problem_directory.empty())
    {
      std::filesystem::create_directories(world.settings.failed_problem_directory);
      world.contact.save_problem(
          world.settings.failed_problem_directory + "/contact-" + number(world.time) + ".h5",
          "time " + number(world.time) + " s, step " + number(dt) + " s", world.settings.contact_solver);
    }
    return "the contact solver left a residual of " + number(report.residual) + " after " +
           std::to_string(report.sweeps) + " sweeps ('Contact/Maximum sweeps')";
  }

  /// Goes along the Newton direction as far as the unbalanced impulse falls and no point turns inside out.
  std::string line_search()
  {
    double length = 0., work = 0., merit = 0.;
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (moves(b))
      {
        const Eigen::VectorXd R = unbalanced(b);
        length += direction[b].squaredNorm();
        work += direction[b].dot(R);
        merit += R.squaredNorm();
      }
    last_length = std::sqrt(length);
    last_work = work;
    if (outcome.newton_iterations == 0)
    {
      first_length = last_length;
      first_work = last_work;
    }
    merit = std::sqrt(merit);
    const Vectors x = trial;
    double best = std::numeric_limits<double>::max();
    for (double alpha = 1.; alpha > 0.01; alpha *= 0.5)
    {
      for (unsigned int b = 0; b < n_bodies; ++b)
        if (moves(b))
          trial[b] = x[b] + alpha * direction[b];
      if (!evaluate(trial))
        continue;
      double now = 0.;
      for (unsigned int b = 0; b < n_bodies; ++b)
        if (moves(b))
        {
          now += unbalanced(b).squaredNorm();
        }
      now = std::sqrt(now);
      best = std::min(best, now);
      if (now <= (1. - 1e-4 * alpha) * merit || residual_norm() <= world.settings.residual_tolerance)
        return "";
    }
    return best == std::numeric_limits<double>::max() ? inside_out()
                                                      : "the line search found no smaller residual";
  }

  std::string inside_out() const
  {
    std::ostringstream text;
    const Body<2> &body = world.bodies[bad_body];
    text << "a material point of body '" << body.name << "' turned inside out near ("
         << body.points[bad_point].position()
         << ") m of its grid; a smaller 'Time/Time step' or 'Mesh/Cell size' may help";
    return text.str();
  }

  StepOutcome finish()
  {
    Vectors rate(n_bodies);
    for (unsigned int b = 0; b < n_bodies; ++b)
      rate[b] = increment[b] / dt;
    std::vector<double> gap =
        world.contact.empty() ? std::vector<double>() : end_gaps(world, increment, motion, dt);
    if (repair(gap))
      gap = end_gaps(world, increment, motion, dt);
    for (const double g : gap)
      outcome.max_penetration = std::max(outcome.max_penetration, -g);
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (moves(b))
      {
        world.bodies[b].internal_force = new_internal[b];
        if (scheme.inertia)
          spread_imbalance(world.bodies[b], unbalanced(b), trial[b]);
      }
    accept_step(world, dt, trial, increment, rate, motion, external);
    outcome.accepted = true;
    return outcome;
  }

  /// Takes back by positions alone what penetration is left; @return whether anything moved.
  bool repair(const std::vector<double> &gap)
  {
    const double tolerance = 1e-6 * world.lattice->cell_size();
    if (!world.settings.repair_positions || theta == 1. ||
        world.settings.coupling != ContactCoupling::condensed ||
        std::none_of(gap.begin(), gap.end(), [&](const double g) { return g < -tolerance; }))
      return false;
    dealii::TimerOutput::Scope section(*world.timer, "position repair");
    double before = 0., after = 0.;
    const std::vector<double> tau = world.contact.repair(gap, world.settings.contact_solver);
    const Vectors saved = increment;
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (moves(b))
      {
        Eigen::VectorXd push = Eigen::VectorXd::Zero(world.bodies[b].field.n_dofs()), moved;
        world.contact.add_impulses(b, tau, push);
        world.solvers[b]->solve(push, moved);
        increment[b] += moved;
        before += stored_energy(world.bodies[b]);
        const StressOutcome stress = evaluate_stress(
            world.bodies[b], Eigen::VectorXd(world.bodies[b].displacement + increment[b]), increment[b],
            world.settings.grid_update == GridUpdate::every_step ? 0.5 * dt : 0., {false, true});
        if (!stress.good())
        {
          increment = saved;
          evaluate(trial);
          return false;
        }
        internal_force(world.bodies[b], new_internal[b]);
        after += stored_energy(world.bodies[b]);
      }
    // Contact took this from the bodies when it let them overlap, and gives it back.
    world.balance.contact_loss -= after - before;
    return true;
  }

  World &world;
  const TimeScheme &scheme;
  const double dt, theta;
  const std::vector<WallMotion<2>> motion;
  const unsigned int n_bodies;
  StepOutcome outcome;

  Vectors trial, increment, old_force, new_internal, external, free_residual, direction, rotation;
  std::vector<double> shift, rotation_stiffness, start_relative;
  unsigned int bad_body = 0;
  std::size_t bad_point = 0;
  double first_length = 0., first_work = 0., last_length = 0., last_work = 0.;
};
} // namespace

StepOutcome implicit_step(World &world, const double dt)
{
  return ImplicitStep(world, dt).run();
}
} // namespace softgrain::mpm
