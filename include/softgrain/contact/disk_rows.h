// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_disk_rows_h
#define softgrain_contact_disk_rows_h

#include <softgrain/contact/disk_system.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace softgrain::contact
{
/// A body as the sweeps see it; in the plane without rotations half a cache line, in space with them a whole
/// one.
template <bool rotates, int dim = 2>
struct DiskState
{
  double velocity[dim]; ///< [m/s]
  double inverse_mass;  ///< [m/kg]
  double unused;        ///< keeps a state inside one cache line
};

template <>
struct DiskState<true, 2>
{
  double velocity[2];
  double inverse_mass;
  double angular_velocity; ///< [rad/s]
  double inverse_inertia;  ///< [1/(kg m)]
  double unused;
};

template <>
struct DiskState<false, 3>
{
  double velocity[3];
  double inverse_mass;
};

template <>
struct DiskState<true, 3>
{
  double velocity[3];
  double inverse_mass;
  std::array<double, 3> angular_velocity; ///< [rad/s]
  double inverse_inertia;                 ///< [1/(kg m^2)]
};

/// What a contact knows beyond the normal direction.
template <unsigned int n>
struct DiskRowExtra
{
};

template <>
struct DiskRowExtra<2>
{
  double friction, arm_a, arm_b; ///< arm_b of a wall: its velocity along t [m/s]
};

template <>
struct DiskRowExtra<3> : DiskRowExtra<2>
{
  double rolling; ///< [m]
};

/// What it knows in space is the same as with friction in the plane.
template <>
struct DiskRowExtra<4> : DiskRowExtra<2>
{
};

/**
 * @brief A contact as the sweeps see it: in the plane 48 bytes without friction, 88 with it, 112 with rolling
 * resistance.
 *
 * @tparam n impulses: 1 normal; in the plane 2 with friction, 3 with rolling resistance; in space 4 with
 * friction, which is a vector
 */
template <unsigned int n, int dim = 2>
struct DiskRow : DiskRowExtra<n>
{
  std::uint32_t a, b; ///< indices into the packed bodies
  double normal[dim];
  double gap_velocity; ///< [m/s]
  double impulse[n];
  double previous[n]; ///< impulse before the last sweep, for the momentum
};

/// A row in a cell that deforms.
template <unsigned int n>
struct DiskRowInCell : DiskRow<n>
{
  double branch[2]; ///< [m]
};

/// Compliance of a contact; normal and other directions are not coupled, because centres and contact are in
/// line.
template <unsigned int n>
struct DiskCompliance
{
  double normal;                                       ///< [m/kg]
  double tangential = 0., rolling = 0., coupling = 0.; ///< [m/kg], [1/(kg m)], [1/kg]

  /// Compliance of component @p c of the impulse.
  double of(const unsigned int c) const { return c == 0 ? normal : n == 4 || c == 1 ? tangential : rolling; }
};

/**
 * @brief Kinematics of one contact and its exact solution.
 *
 * @tparam n as for DiskRow
 * @tparam wall b is a wall: impulses move it along the normal, and with inverse_inertia for an inverse mass
 *              along the tangent; it does not turn
 */
template <unsigned int n, bool wall, int dim = 2>
struct DiskContact
{
  static_assert(dim == 2);
  using State = DiskState<(n > 1)>;
  using Row = DiskRow<n>;

  static DiskCompliance<n> compliance(const Row &row, const State &a, const State &b)
  {
    DiskCompliance<n> W{a.inverse_mass + b.inverse_mass};
    if constexpr (n > 1)
    {
      W.tangential = a.inverse_mass + row.arm_a * row.arm_a * a.inverse_inertia;
      W.rolling = a.inverse_inertia;
      W.coupling = -row.arm_a * a.inverse_inertia;
      if constexpr (!wall)
      {
        W.tangential += b.inverse_mass + row.arm_b * row.arm_b * b.inverse_inertia;
        W.rolling += b.inverse_inertia;
        W.coupling += row.arm_b * b.inverse_inertia;
      }
      else
        W.tangential += b.inverse_inertia;
    }
    return W;
  }

  /// Relative velocities [m/s], [m/s], [rad/s].
  static void velocity(const Row &row, const State &a, const State &b, double (&w)[n])
  {
    const double u[2] = {a.velocity[0] - b.velocity[0], a.velocity[1] - b.velocity[1]};
    w[0] = row.normal[0] * u[0] + row.normal[1] * u[1] + row.gap_velocity;
    if constexpr (n > 1)
    {
      if constexpr (wall)
        w[1] =
            (row.normal[0] * a.velocity[1] - row.normal[1] * a.velocity[0] - row.arm_a * a.angular_velocity) -
            (row.normal[0] * b.velocity[1] - row.normal[1] * b.velocity[0]) - row.arm_b;
      else
        w[1] = row.normal[0] * u[1] - row.normal[1] * u[0] - row.arm_a * a.angular_velocity -
               row.arm_b * b.angular_velocity;
    }
    if constexpr (n > 2)
      w[2] = a.angular_velocity - b.angular_velocity;
  }

  /// Adds @p change to the impulse's effect on the bodies.
  static void apply(const Row &row, State &a, State &b, const double (&change)[n])
  {
    double force[2] = {row.normal[0] * change[0], row.normal[1] * change[0]};
    for (unsigned int d = 0; d < 2; ++d)
      if constexpr (wall)
        b.velocity[d] -= b.inverse_mass * force[d];
    if constexpr (n > 1)
    {
      force[0] -= row.normal[1] * change[1];
      force[1] += row.normal[0] * change[1];
      double moment_a = -row.arm_a * change[1];
      if constexpr (n > 2)
        moment_a += change[2];
      a.angular_velocity += a.inverse_inertia * moment_a;
      if constexpr (!wall)
      {
        double moment_b = -row.arm_b * change[1];
        if constexpr (n > 2)
          moment_b -= change[2];
        b.angular_velocity += b.inverse_inertia * moment_b;
      }
      else
      {
        b.velocity[0] += b.inverse_inertia * (row.normal[1] * change[1]);
        b.velocity[1] -= b.inverse_inertia * (row.normal[0] * change[1]);
      }
    }
    for (unsigned int d = 0; d < 2; ++d)
    {
      a.velocity[d] += a.inverse_mass * force[d];
      if constexpr (!wall)
        b.velocity[d] -= b.inverse_mass * force[d];
    }
  }

  /// The impulse by which @p row obeys Signorini, Coulomb and rolling, given @p w with the impulse @p y.
  static void solve(
      const Row &row, const DiskCompliance<n> &W, const double (&w)[n], const double (&y)[n], double (&P)[n])
  {
    // 0 where both sides are prescribed: an impulse would change nothing
    P[0] = W.normal > 0. ? std::max(0., y[0] - w[0] / W.normal) : 0.;
    if constexpr (n == 2)
      P[1] = within(W.tangential > 0. ? y[1] - w[1] / W.tangential : 0., row.friction * P[0]);
    if constexpr (n == 3)
    {
      const double q[2] = {w[1] - W.tangential * y[1] - W.coupling * y[2],
                           w[2] - W.coupling * y[1] - W.rolling * y[2]};
      solve_box(W, q, row.friction * P[0], row.rolling * P[0], P[1], P[2]);
    }
  }

  /// Puts @p P back where the conditions allow an impulse to be.
  static void project(const Row &row, double (&P)[n])
  {
    P[0] = std::max(0., P[0]);
    if constexpr (n > 1)
      P[1] = within(P[1], row.friction * P[0]);
    if constexpr (n > 2)
      P[2] = within(P[2], row.rolling * P[0]);
  }

  /// Natural map of the contact as a velocity [m/s], largest over its conditions; 0 exactly where all hold.
  static double natural_map(const Row &row, const DiskCompliance<n> &W, const double (&w)[n])
  {
    double worst = W.normal > 0. ? std::abs(std::min(w[0], W.normal * row.impulse[0])) : 0.;
    if constexpr (n > 1)
      worst = larger(worst, map(W.tangential, row.impulse[1], w[1], row.friction * row.impulse[0]));
    if constexpr (n > 2) // the arm makes a velocity of the rotation
      worst = larger(worst, row.arm_a * map(W.rolling, row.impulse[2], w[2], row.rolling * row.impulse[0]));
    return worst;
  }

private:
  static double within(const double x, const double bound) { return std::max(-bound, std::min(bound, x)); }

  static double larger(const double a, const double b) { return b <= a ? a : b; } // b when it is not a number

  static double map(const double W, const double P, const double w, const double bound)
  {
    return std::abs(W * P - within(W * P - w, W * bound));
  }

  /// min ½ W_t t² + c t r + ½ W_r r² + q·(t, r) over |t| <= bound_t, |r| <= bound_r.
  static void solve_box(const DiskCompliance<n> &W,
                        const double (&q)[2],
                        const double bound_t,
                        const double bound_r,
                        double &t,
                        double &r)
  {
    const double determinant = W.tangential * W.rolling - W.coupling * W.coupling;
    t = r = 0.;
    if (determinant > 0.)
    {
      t = (W.coupling * q[1] - W.rolling * q[0]) / determinant;
      r = (W.coupling * q[0] - W.tangential * q[1]) / determinant;
      if (std::abs(t) <= bound_t && std::abs(r) <= bound_r)
        return;
    }
    // The minimum is on an edge: the lowest of the minima of the four.
    double lowest = 0.;
    bool first = true;
    const auto consider = [&](const double t_edge, const double r_edge)
    {
      const double value = t_edge * (0.5 * W.tangential * t_edge + W.coupling * r_edge + q[0]) +
                           r_edge * (0.5 * W.rolling * r_edge + q[1]);
      if (!first && !(value < lowest))
        return;
      first = false;
      lowest = value;
      t = t_edge;
      r = r_edge;
    };
    for (const double sign : {-1., 1.})
    {
      const double t_edge = sign * bound_t, r_edge = sign * bound_r;
      if (W.rolling > 0.)
        consider(t_edge, within(-(q[1] + W.coupling * t_edge) / W.rolling, bound_r));
      if (W.tangential > 0.)
        consider(within(-(q[0] + W.coupling * r_edge) / W.tangential, bound_t), r_edge);
    }
    if (first) // no compliance
      t = r = 0.;
  }
};

/// What a cell that deforms adds to the kinematics of a contact.
template <unsigned int n>
struct DiskCellContact
{
  using Row = DiskRowInCell<n>;

  static void add_velocity(const Row &row, const DiskCell &cell, double (&w)[n])
  {
    const double u[2] = {cell.gradient[0][0] * row.branch[0] + cell.gradient[0][1] * row.branch[1],
                         cell.gradient[1][0] * row.branch[0] + cell.gradient[1][1] * row.branch[1]};
    w[0] += row.normal[0] * u[0] + row.normal[1] * u[1];
    if constexpr (n > 1)
      w[1] += row.normal[0] * u[1] - row.normal[1] * u[0];
  }

  static void add_compliance(const Row &row, const DiskCell &cell, DiskCompliance<n> &W)
  {
    const double tangent[2] = {-row.normal[1], row.normal[0]};
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int l = 0; l < 2; ++l)
      {
        const double part = cell.inverse_mass[k][l] * row.branch[l] * row.branch[l];
        W.normal += part * row.normal[k] * row.normal[k];
        if constexpr (n > 1)
          W.tangential += part * tangent[k] * tangent[k];
      }
  }

  static void apply(const Row &row, DiskCell &cell, const double (&change)[n])
  {
    double force[2] = {row.normal[0] * change[0], row.normal[1] * change[0]};
    if constexpr (n > 1)
    {
      force[0] -= row.normal[1] * change[1];
      force[1] += row.normal[0] * change[1];
    }
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int l = 0; l < 2; ++l)
        cell.gradient[k][l] += cell.inverse_mass[k][l] * force[k] * row.branch[l];
  }
};
} // namespace softgrain::contact

#endif
