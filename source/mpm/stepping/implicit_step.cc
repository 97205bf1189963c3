// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/interruption.h>
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/contact/moved_boundary.h>
#include <softgrain/mpm/contact/row_velocity.h>
#include <softgrain/mpm/model/world.h>
#include <softgrain/mpm/stepping/following_rows.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/step_equations.h>
#include <softgrain/mpm/stepping/stress.h>

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
  ImplicitStep(World &world, const StepPlan &plan)
      : world(world)
      , plan(plan)
      , dt(plan.dt)
      , theta(world.settings.scheme.theta)
      , motion(walls_of_step(world, plan))
      , equations(world, plan)
      , rows(world, plan.dt, motion)
      , n_bodies(world.bodies.size())
      , trial(n_bodies)
      , direction(n_bodies)
  {
  }

  StepOutcome run()
  {
    if (!start())
      return reject(equations.why_not());
    for (outcome.newton_iterations = 0;; ++outcome.newton_iterations)
    {
      stop_if_interrupted();
      const bool settled = rows.settled(equations.increment);
      if (outcome.newton_iterations > 0 && converged() &&
          (settled || rows.searches() >= world.settings.max_searches))
      {
        outcome.rows_settled = settled;
        settle_free_walls(world, motion);
        const std::string overlap = too_deep();
        world.heed_laws(equations.stress_outcome(), outcome);
        if (outcome.law_asks)
          return outcome;
        return overlap.empty() ? finish() : reject(overlap);
      }
      if (rows_go_on(settled))
        find_rows_again();
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
  static std::vector<WallMotion<2>> walls_of_step(World &world, const StepPlan &plan)
  {
    press_walls(world, plan);
    return world.wall_motion(plan);
  }

  StepOutcome reject(const std::string &reason)
  {
    outcome.accepted = false;
    outcome.reason = reason;
    return outcome;
  }

  /// First guess: bodies go on as they did, without inertia they stay; a guess that turns a point inside out
  /// is replaced by rest. @return false when that fails too, and the step is too long
  bool start()
  {
    for (const bool rest : {!world.settings.scheme.inertia && plan.guess == nullptr, true})
    {
      for (unsigned int b = 0; b < n_bodies; ++b)
        trial[b] = rest                    ? Eigen::VectorXd::Zero(world.bodies[b].field.n_dofs())
                   : plan.guess == nullptr ? world.bodies[b].velocity
                                           : Eigen::VectorXd((*plan.guess)[b] / dt);
      if (!equations.evaluate(trial))
        continue;
      find_rows(false);
      return true;
    }
    return false;
  }

  void find_rows(const bool again)
  {
    follow_free_walls(world, motion);
    rows.find(equations.increment, again);
    equations.rows_changed();
    condensed_rows_are_old = true;
  }

  void find_rows_again()
  {
    Vectors next = equations.increment;
    // With inertia a few searches mostly do; mixing costs an evaluation of the stress.
    if ((!world.settings.scheme.inertia || rows.searches() >= searches_before_mixing) && rows.mix(next))
      move_to(next);
    find_rows(true);
  }

  /// Whether rows are found again. Those that stay make rotation unstable, and whatever else a tangent holds
  /// stable that has them follow; else the last few iterations are fast with rows that stay.
  bool rows_go_on(const bool settled) const
  {
    if (settled)
      return world.settings.rows_follow() && world.settings.scheme.inertia && outcome.newton_iterations > 0 &&
             equations.rotation_chases_rows();
    return rows.searches() < world.settings.max_searches || !equations.rotation_is_gauge() ||
           equations.pressure_follows();
  }

  /// Goes to these increments, unless a point turns inside out there.
  void move_to(const Vectors &increment)
  {
    const Vectors before = trial;
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (equations.moves(b))
        trial[b] += (increment[b] - equations.increment[b]) / (theta * dt);
    if (equations.evaluate(trial))
      return;
    trial = before;
    equations.evaluate(trial);
  }

  bool converged()
  {
    outcome.newton_residual = equations.residual();
    if (!contact_converged)
      return false;
    if (outcome.newton_residual > world.settings.residual_tolerance)
      return false;
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
      stop_if_interrupted();
      if (!trouble.empty())
        return trouble;
    }
    if (condensed && !world.contact.empty() && (!factors_serve || condensed_rows_are_old))
    {
      dealii::TimerOutput::Scope section(*world.timer, "condensation");
      world.contact.condense(world.bodies, world.solvers, world.subgrid(), dt, theta);
      condensed_rows_are_old = false;
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
    contact::SolverSettings settings = world.settings.contact_solver;
    // The iterations that come bring other rows and other problems; the last one must be solved.
    if (world.settings.rows_follow() && outcome.newton_iterations < rough_iterations)
      settings.passable = passable_residual;
    // Every iteration has other rows: what one leaves open, the next does not mend.
    if (world.settings.rows_follow() && world.settings.scheme.inertia && outcome.newton_iterations > 0)
      settings.tolerance =
          std::min(settings.tolerance, std::max(finest_tolerance, 0.1 * outcome.newton_residual));
    const contact::SolverReport report =
        world.contact.solve(row_velocity(world, v, motion, equations.start_relative, theta, dt,
                                         theta == 1. || world.settings.rows_follow(), relative),
                            settings, relative);
    outcome.contact_sweeps += report.sweeps;
    outcome.contact_residual = report.residual;
    // Rows denser than the nodes make W nearly singular, and with friction the sweeps may stand still a
    // little above the tolerance: the step is then right to five digits, its residual is reported, and
    // cutting it would not help.
    contact_converged = report.converged || report.limited_by_rounding ||
                        report.residual <= 100. * world.settings.contact_solver.tolerance;
    if (contact_converged || report.residual <= settings.passable)
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
    const Vectors x = trial, from = equations.increment;
    double best = std::numeric_limits<double>::max();
    for (double alpha = 1.; alpha > 0.01; alpha *= 0.5)
    {
      for (unsigned int b = 0; b < n_bodies; ++b)
        if (equations.moves(b))
          trial[b] = equations.go(b, x[b], alpha, direction[b], from[b]);
      if (!equations.evaluate(trial))
        continue;
      const double now = equations.unbalanced_norm();
      best = std::min(best, now);
      if (now <= (1. - 1e-4 * alpha) * merit || equations.residual() <= world.settings.residual_tolerance ||
          still_goes_down(work))
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

  /// Without inertia a step looks for least energy. With pressure that follows, the matrix is not the
  /// derivative and the imbalance may grow on the way down: good is what does not go far uphill again.
  /// @param work of the imbalance along the direction at its start
  bool still_goes_down(const double work) const
  {
    if (world.settings.scheme.inertia || !equations.pressure_follows() || work <= 0.)
      return false;
    double at_end = 0.;
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (equations.moves(b))
        at_end += direction[b].dot(equations.unbalanced(b));
    return at_end >= -0.5 * work;
  }

  /// Why the step may not end: bodies are deeper in each other than is allowed, and than they were; or empty.
  std::string too_deep()
  {
    outcome.max_penetration = rows.penetration(equations.increment);
    if (!world.settings.rows_follow())
      return "";
    const double allowed = world.settings.largest_penetration * world.lattice->cell_size();
    if (outcome.max_penetration <= std::max(allowed, rows.penetration_at_start()))
      return "";
    return "bodies are " + number(outcome.max_penetration / world.lattice->cell_size()) +
           " cells deep in each other or in walls, which is more than 'Contact/Largest penetration' allows";
  }

  StepOutcome finish()
  {
    Vectors rate(n_bodies);
    for (unsigned int b = 0; b < n_bodies; ++b)
      rate[b] = equations.increment[b] / dt;
    for (unsigned int b = 0; b < n_bodies; ++b)
      if (equations.moves(b))
      {
        outcome.largest_move =
            std::max(outcome.largest_move, largest_way(world.bodies[b], equations.increment[b]));
        world.balance.scheme_damping += equations.scheme_damping(b, trial[b]);
        world.bodies[b].internal_force = equations.internal[b];
        if (world.settings.scheme.inertia)
          spread_imbalance(world.bodies[b], equations.unbalanced(b), trial[b]);
      }
    world.balance.regularisation_work += equations.regularisation_work();
    accept_step(world, plan, trial, equations.increment, rate, motion, equations.external);
    outcome.accepted = true;
    return outcome;
  }

  /// Of a contact problem in an iteration that is not the last, relative to the speed of approach.
  static constexpr double passable_residual = 0.1;
  static constexpr double finest_tolerance = 1e-7; ///< of a contact problem, to which Newton brings it
  static constexpr unsigned int searches_before_mixing = 4; ///< with inertia
  static constexpr unsigned int rough_iterations = 8;       ///< in which that will do

  World &world;
  const StepPlan plan;
  const double dt, theta;
  std::vector<WallMotion<2>> motion;
  StepEquations equations;
  FollowingRows rows;
  const unsigned int n_bodies;
  StepOutcome outcome;
  Vectors trial, direction;
  bool condensed_rows_are_old = false; ///< the Delassus operator is not that of the present rows
  bool contact_converged = true;       ///< the last contact problem has been solved
  bool factors_serve = false;          ///< those of the iteration before are good enough for the next
  double first_length = 0., first_work = 0., last_length = 0., last_work = 0.;
};
} // namespace

StepOutcome implicit_step(World &world, const StepPlan &plan)
{
  return ImplicitStep(world, plan).run();
}
} // namespace softgrain::mpm
