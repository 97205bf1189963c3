// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/row_velocity.h>
#include <softgrain/mpm/step_equations.h>
#include <softgrain/mpm/stress.h>
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
using Vectors = StepEquations::Vectors;

std::string number(const double value)
{
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

/// Newton's method with contact for one implicit step; see doc/theory.md.
class ImplicitStep
{
public:
  ImplicitStep(World &world, const double dt)
      : world(world)
      , dt(dt)
      , theta(world.settings.scheme.theta)
      , motion(world.begin_step(dt))
      , equations(world, dt)
      , n_bodies(world.bodies.size())
      , trial(n_bodies)
      , direction(n_bodies)
  {
  }

  StepOutcome run()
  {
    for (unsigned int b = 0; b < n_bodies; ++b)
      trial[b] = world.bodies[b].velocity;
    if (!equations.evaluate(trial))
    {
      // A first guess that turns a point inside out is replaced by rest; if that fails too the step is too
      // long.
      for (Eigen::VectorXd &v : trial)
        v.setZero();
      if (!equations.evaluate(trial))
        return reject(equations.why_not());
    }
    for (outcome.newton_iterations = 0;; ++outcome.newton_iterations)
    {
      if (outcome.newton_iterations > 0 && converged())
        return finish();
      if (outcome.newton_iterations == world.settings.max_newton)
        return reject("Newton did not converge in " + std::to_string(world.settings.max_newton) +
                      " iterations ('Newton/Maximum iterations'); relative residual " +
                      number(outcome.newton_residual));
      const bool old_factors = factors_serve;
      std::string trouble = newton_step();
      if (!trouble.empty() && old_factors)
      {
        factors_serve = false;
        trouble = newton_step();
      }
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

  bool converged()
  {
    outcome.newton_residual = equations.residual();
    if (outcome.newton_residual > world.settings.residual_tolerance)
      return false;
    // A body between frictionless walls may turn at no cost, so without inertia increments need not die out.
    if (!world.settings.scheme.inertia)
      return true;
    // Lumped contact is an iteration of its own: the bulk may be balanced while the contact velocities are
    // not yet right.
    if (!world.contact.empty() && world.settings.coupling == ContactCoupling::lumped)
      // (3.22) down to the rounding of the velocities; a step that starts near its solution has a small first
      // increment.
      return last_length <=
             std::max(world.settings.displacement_tolerance * first_length, 1e-10 * trial_length());
    // (3.22), with the velocity increment in place of the displacement increment: they differ by theta dt. In
    // free flight the first increment is rounding already.
    return last_length <= 1e-10 * trial_length() ||
           (last_length <= world.settings.displacement_tolerance * first_length &&
            std::abs(last_work) <= world.settings.energy_tolerance * std::abs(first_work)) ||
           outcome.newton_residual <= 0.1 * world.settings.residual_tolerance;
  }

  double trial_length() const
  {
    double sum = 0.;
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (equations.moves(b))
        sum += trial[b].squaredNorm();
    return std::sqrt(sum);
  }

  std::string newton_step()
  {
    std::string trouble;
    const bool condensed = world.settings.coupling == ContactCoupling::condensed;
    if (!factors_serve)
    {
      trouble = equations.factorise();
      if (!trouble.empty())
        return trouble;
      if (condensed && !world.contact.empty())
      {
        dealii::TimerOutput::Scope section(*world.timer, "condensation");
        world.contact.condense(world.bodies, world.solvers);
      }
    }
    if (world.contact.empty() || condensed)
      equations.solve(false, direction);
    if (!world.contact.empty())
    {
      trouble = condensed ? contact_condensed() : contact_lumped();
      if (!trouble.empty())
        return trouble;
      equations.solve(true, direction);
    }
    return line_search();
  }

  std::string contact_condensed()
  {
    Vectors free(n_bodies);
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (equations.moves(b))
        free[b] = trial[b] + direction[b];
    return solve_contact(free, false);
  }

  std::string contact_lumped()
  {
    world.contact.lump(world.bodies);
    // The momentum balance at the present iterate, solved for the contact velocities with the masses alone.
    Vectors v = trial;
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (equations.moves(b))
      {
        const Eigen::VectorXd R = equations.unbalanced(b);
        for (unsigned int i = 0; i < world.bodies[b].mass.size(); ++i)
          v[b].segment<2>(2 * i) += R.segment<2>(2 * i) / world.bodies[b].mass[i];
      }
    return solve_contact(v, true);
  }

  std::string solve_contact(const Vectors &v, const bool relative)
  {
    dealii::TimerOutput::Scope section(*world.timer, "contact solve");
    const contact::SolverReport report =
        world.contact.solve(row_velocity(world, v, motion, equations.start_relative, theta, dt, theta == 1.),
                            world.settings.contact_solver, relative);
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
      if (equations.moves(b))
      {
        const Eigen::VectorXd R = equations.unbalanced(b);
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
        if (equations.moves(b))
          trial[b] = x[b] + alpha * direction[b];
      if (!equations.evaluate(trial))
        continue;
      const double now = equations.unbalanced_norm();
      best = std::min(best, now);
      if (now <= (1. - 1e-4 * alpha) * merit || equations.residual() <= world.settings.residual_tolerance)
      {
        // Factors that leave so little of the imbalance once do so again, for a fraction of the work. With
        // lumped contact iterations go on long after the bulk is balanced.
        factors_serve = now <= 0.03 * merit || (world.settings.coupling == ContactCoupling::lumped &&
                                                equations.residual() <= world.settings.residual_tolerance);
        return "";
      }
    }
    return best == std::numeric_limits<double>::max() ? equations.why_not()
                                                      : "the line search found no smaller residual";
  }

  StepOutcome finish()
  {
    Vectors rate(n_bodies);
    for (unsigned int b = 0; b < n_bodies; ++b)
      rate[b] = equations.increment[b] / dt;
    std::vector<double> gap = gaps();
    if (repair(gap))
      gap = gaps();
    for (const double g : gap)
      outcome.max_penetration = std::max(outcome.max_penetration, -g);
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (equations.moves(b))
      {
        world.bodies[b].internal_force = equations.internal[b];
        if (world.settings.scheme.inertia)
          spread_imbalance(world.bodies[b], equations.unbalanced(b), trial[b]);
      }
    accept_step(world, dt, trial, equations.increment, rate, motion, equations.external);
    outcome.accepted = true;
    return outcome;
  }

  std::vector<double> gaps() const
  {
    return world.contact.empty() ? std::vector<double>() : end_gaps(world, equations.increment, motion, dt);
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
    const std::vector<double> tau = world.contact.repair(gap, world.settings.contact_solver);
    const Vectors saved = equations.increment;
    std::vector<double> energy(n_bodies, 0.);
    std::vector<char> good(n_bodies, 1);
    const double half_dt = world.settings.grid_update == GridUpdate::every_step ? 0.5 * dt : 0.;
    world.for_moving_bodies(
        [&](Body<2> &body)
        {
          Eigen::VectorXd &increment = equations.increment[body.index];
          Eigen::VectorXd push = Eigen::VectorXd::Zero(body.field.n_dofs()), moved;
          world.contact.add_impulses(body.index, tau, push);
          if (push.isZero(0.))
            return;
          world.solvers[body.index]->solve(push, moved);
          const Eigen::VectorXd before = body.displacement + increment, after = before + moved;
          energy[body.index] = -measure_points(body, before, increment).energy;
          increment += moved;
          energy[body.index] += measure_points(body, after, increment).energy;
          good[body.index] = evaluate_stress(body, after, increment, {half_dt, false, 0.}).good();
          if (good[body.index])
            internal_force(body, equations.internal[body.index]);
        });
    if (std::count(good.begin(), good.end(), 0) > 0)
    {
      equations.increment = saved;
      equations.evaluate(trial);
      return false;
    }
    // Contact took this from the bodies when it let them overlap, and gives it back.
    for (const double gain : energy)
      world.balance.contact_loss -= gain;
    return true;
  }

  World &world;
  const double dt, theta;
  const std::vector<WallMotion<2>> motion;
  StepEquations equations;
  const unsigned int n_bodies;
  StepOutcome outcome;
  Vectors trial, direction;
  bool factors_serve = false; ///< those of the iteration before are good enough for the next
  double first_length = 0., first_work = 0., last_length = 0., last_work = 0.;
};
} // namespace

StepOutcome implicit_step(World &world, const double dt)
{
  return ImplicitStep(world, dt).run();
}
} // namespace softgrain::mpm
