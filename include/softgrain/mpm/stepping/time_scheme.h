// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_time_scheme_h
#define softgrain_mpm_stepping_time_scheme_h

#include <string>

namespace softgrain::mpm
{
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
 */
struct TimeScheme
{
  std::string name = "moreau_jean";
  double theta = 0.55;
  bool inertia = true;
  bool implicit = true;

  /// The terms of a TimeIntegrator. @throw InputError when the name is unknown or theta is outside of [1/2,
  /// 1]
  static TimeScheme create(const std::string &name, double theta);
};
} // namespace softgrain::mpm

#endif
