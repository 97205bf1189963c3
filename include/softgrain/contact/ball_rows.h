// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_ball_rows_h
#define softgrain_contact_ball_rows_h

#include <softgrain/contact/disk_rows.h>

#include <algorithm>
#include <cmath>

namespace softgrain::contact
{
/**
 * @brief Kinematics of one contact of balls and its exact solution.
 *
 * Centres and contact are in line, so normal and tangents are not coupled and all tangents are alike: a
 * compliance of three by three has one number for the normal and another for both tangents. Friction is a
 * vector across the normal in the axes of space, so that no tangents need be chosen.
 *
 * @tparam n impulses: 1 normal, 4 with friction
 * @tparam wall b is a wall, which neither turns nor gives way
 */
template <unsigned int n, bool wall>
struct DiskContact<n, wall, 3>
{
  static_assert(n == 1 || n == 4);
  using State = DiskState<(n > 1), 3>;
  using Row = DiskRow<n, 3>;

  static DiskCompliance<n> compliance(const Row &row, const State &a, const State &b)
  {
    DiskCompliance<n> W{a.inverse_mass + b.inverse_mass};
    if constexpr (n > 1)
    {
      W.tangential = W.normal + row.arm_a * row.arm_a * a.inverse_inertia;
      if constexpr (!wall)
        W.tangential += row.arm_b * row.arm_b * b.inverse_inertia;
    }
    return W;
  }

  /// Relative velocities: along the normal, and the vector across it [m/s].
  static void velocity(const Row &row, const State &a, const State &b, double (&w)[n])
  {
    const double *const m = row.normal;
    double u[3];
    for (unsigned int d = 0; d < 3; ++d)
      u[d] = a.velocity[d] - b.velocity[d];
    const double normal = m[0] * u[0] + m[1] * u[1] + m[2] * u[2];
    w[0] = normal + row.gap_velocity;
    if constexpr (n > 1)
    {
      double spin[3];
      for (unsigned int d = 0; d < 3; ++d)
        spin[d] = row.arm_a * a.angular_velocity[d];
      if constexpr (!wall)
        for (unsigned int d = 0; d < 3; ++d)
          spin[d] += row.arm_b * b.angular_velocity[d];
      w[1] = u[0] - normal * m[0] - (spin[1] * m[2] - spin[2] * m[1]);
      w[2] = u[1] - normal * m[1] - (spin[2] * m[0] - spin[0] * m[2]);
      w[3] = u[2] - normal * m[2] - (spin[0] * m[1] - spin[1] * m[0]);
    }
  }

  /// Adds @p change to the impulse's effect on the bodies.
  static void apply(const Row &row, State &a, State &b, const double (&change)[n])
  {
    const double *const m = row.normal;
    double force[3] = {m[0] * change[0], m[1] * change[0], m[2] * change[0]};
    if constexpr (n > 1)
    {
      for (unsigned int d = 0; d < 3; ++d)
        force[d] += change[1 + d];
      const double moment[3] = {m[1] * change[3] - m[2] * change[2], m[2] * change[1] - m[0] * change[3],
                                m[0] * change[2] - m[1] * change[1]};
      for (unsigned int d = 0; d < 3; ++d)
      {
        a.angular_velocity[d] -= a.inverse_inertia * row.arm_a * moment[d];
        if constexpr (!wall)
          b.angular_velocity[d] -= b.inverse_inertia * row.arm_b * moment[d];
      }
    }
    for (unsigned int d = 0; d < 3; ++d)
    {
      a.velocity[d] += a.inverse_mass * force[d];
      b.velocity[d] -= b.inverse_mass * force[d];
    }
  }

  /// The impulse by which @p row obeys Signorini and Coulomb, given @p w with the impulse @p y.
  static void solve(
      const Row &row, const DiskCompliance<n> &W, const double (&w)[n], const double (&y)[n], double (&P)[n])
  {
    P[0] = W.normal > 0. ? std::max(0., y[0] - w[0] / W.normal) : 0.;
    if constexpr (n > 1)
    {
      for (unsigned int c = 1; c < 4; ++c)
        P[c] = W.tangential > 0. ? y[c] - w[c] / W.tangential : 0.;
      shorten(row.friction * P[0], P);
    }
  }

  /// Puts @p P back where the conditions allow an impulse to be.
  static void project(const Row &row, double (&P)[n])
  {
    P[0] = std::max(0., P[0]);
    if constexpr (n > 1)
    {
      const double *const m = row.normal;
      const double along = m[0] * P[1] + m[1] * P[2] + m[2] * P[3];
      for (unsigned int d = 0; d < 3; ++d)
        P[1 + d] -= along * m[d];
      shorten(row.friction * P[0], P);
    }
  }

  /// Natural map of the contact as a velocity [m/s], largest over its conditions; 0 exactly where all hold.
  static double natural_map(const Row &row, const DiskCompliance<n> &W, const double (&w)[n])
  {
    double worst = W.normal > 0. ? std::abs(std::min(w[0], W.normal * row.impulse[0])) : 0.;
    if constexpr (n > 1)
    {
      double x[n] = {}, sum = 0.;
      for (unsigned int c = 1; c < 4; ++c)
        x[c] = W.tangential * row.impulse[c] - w[c];
      shorten(W.tangential * row.friction * row.impulse[0], x);
      for (unsigned int c = 1; c < 4; ++c)
        sum += (W.tangential * row.impulse[c] - x[c]) * (W.tangential * row.impulse[c] - x[c]);
      const double map = std::sqrt(sum);
      worst = map <= worst ? worst : map; // takes what is not a number
    }
    return worst;
  }

private:
  /// Shortens the friction in @p P to @p bound.
  static void shorten(const double bound, double (&P)[n])
  {
    const double square = P[1] * P[1] + P[2] * P[2] + P[3] * P[3];
    if (square <= bound * bound)
      return;
    const double factor = bound / std::sqrt(square);
    for (unsigned int c = 1; c < 4; ++c)
      P[c] *= factor;
  }
};
} // namespace softgrain::contact

#endif
