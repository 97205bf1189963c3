// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_time_scheme_h
#define softgrain_mpm_stepping_time_scheme_h

#include <algorithm>
#include <memory>
#include <string>

namespace softgrain::mpm
{
class TimeIntegrator;

/**
 * @brief A time scheme as a choice of terms in one equation for the velocity v+ at the end of the step:
 *
 *     M (v+ - v) = dt [(1 - theta) f_old + theta f(x + u)] + H^T P,   u = dt [(1 - theta) v + theta v+]
 *
 * | name         | theta | inertia | f_old                                     |
 * |--------------|-------|---------|-------------------------------------------|
 * | moreau_jean  | 0.55  | yes     | f(t)                                      |
 * | newmark      | 1/2   | yes     | f(t): M a(t) of (3.14)-(3.16) without contact |
 * | explicit     | -     | yes     | f(t) alone, u = dt v+ (symplectic Euler)  |
 * | quasi_static | 1     | no      | none                                      |
 *
 * A scheme with other terms in the equation of a body brings its own BodyTerms: see TimeIntegrator.
 */
struct TimeScheme
{
  enum class Steps
  {
    implicit_motion,
    explicit_motion,
    balance ///< without inertia
  };

  std::string name = "moreau_jean";
  double theta = 0.55; ///< weight of v+ in the mean velocity of the step
  Steps steps = Steps::implicit_motion;
  std::shared_ptr<const TimeIntegrator> integrator; ///< makes its steps

  /// Whether every step ends where forces are in balance: bodies have no velocity that lasts.
  bool ends_in_balance() const { return steps == Steps::balance; }
  /// Whether steps solve equations with the matrices of bodies.
  bool solves_equations() const { return steps != Steps::explicit_motion; }
  /// The velocity that places move with over a step, for one that is @p before and then @p after.
  double over_step(const double before, const double after) const
  {
    return (1. - theta) * before + theta * after;
  }
  /// The velocity with which impulses of the step do their work: those of an explicit one act between the
  /// velocities before and after.
  double at_work(const double before, const double after) const
  {
    return solves_equations() ? over_step(before, after) : 0.5 * (before + after);
  }
  /// The instant that forces of a step of @p dt belong to, which ends at @p end: its impulses balance what is
  /// inside at its beginning with 1 - theta and at its end with theta, so it is theta of the way [s].
  double force_time(const double end, const double dt) const
  {
    return end - (solves_equations() ? 1. - theta : 1.) * dt;
  }
  /// Where in a step loads are taken: with inertia in its middle, which is of second order and does the same
  /// work whatever theta is; steps without it end in balance with those at the end.
  double loads_at() const { return ends_in_balance() ? 1. : 0.5; }
  /// The longest step over that in which a wave crosses a cell, of which @p wanted is asked for. Symplectic
  /// Euler is stable to about one; half of it leaves room for compressed cells.
  double cfl_multiple(const double wanted) const
  {
    return solves_equations() ? wanted : std::min(wanted, 0.5);
  }
  /// @param cfl in which a wave crosses a cell [s] @throw InputError when a @p step is so long that it may
  /// not be stable
  void check_step(double step, double cfl) const;
  /// What it takes from a wall under a load, of this mass, whose velocity changes in a step [J/m].
  double loss_of_wall(const double mass, const double change) const
  {
    return solves_equations() ? (theta - 0.5) * mass * change * change : 0.;
  }
  /// The name, and theta where that is a choice.
  std::string in_words() const;

  /// The terms of a TimeIntegrator. @throw InputError when the name is unknown or theta is outside of [1/2,
  /// 1]
  static TimeScheme create(const std::string &name, double theta);
};
} // namespace softgrain::mpm

#endif
