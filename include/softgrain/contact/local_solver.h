// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_local_solver_h
#define softgrain_contact_local_solver_h

#include <algorithm>
#include <cmath>

namespace softgrain::contact
{
/// Where the solution of one contact lies on the graphs of Signorini and Coulomb.
enum class LocalStatus
{
  separated,
  stick,
  slip,
  prescribed ///< W_nn = 0: no impulse can change the velocity, so the impulse is 0
};

/**
 * @brief Exact solution of one contact: w = W P + q with Signorini and Coulomb.
 *
 * An impulse of a closed contact is P = P_n (1, τ), |τ| <= mu. The condition w_n = 0 gives P_n = -q_n / (W_nn
 * + W_nt·τ), and then w_t has the direction of `G(τ) = A τ + d`, where `A = q_t W_tn - q_n W_tt` and `d =
 * W_nn q_t - q_n W_tn`, which is linear in τ. So the contact sticks at G(τ) = 0 and slips at G(τ) = -λ τ, |τ|
 * = mu, λ > 0. Nothing is inverted but A + λ, so singular blocks need no special care. When W is so oblique
 * that several solutions exist (Painlevé), separation is preferred to stick and stick to slip.
 *
 * @tparam n components of the contact: 1, 2 or 3
 * @param W local block, row by row, n * n values, symmetric positive semi-definite
 * @param q local free relative velocity (m/s): everything but this contact's own impulse
 * @param mu friction coefficient, >= 0, not read when n is 1
 * @param P the impulse (out)
 */
template <unsigned int n>
LocalStatus solve_local(const double *W, const double (&q)[n], double mu, double (&P)[n]);

template <>
inline LocalStatus solve_local<1>(const double *W, const double (&q)[1], double, double (&P)[1])
{
  P[0] = 0.;
  if (!(W[0] > 0.))
    return LocalStatus::prescribed;
  if (q[0] >= 0.)
    return LocalStatus::separated;
  P[0] = -q[0] / W[0];
  return LocalStatus::stick;
}

template <>
inline LocalStatus solve_local<2>(const double *W, const double (&q)[2], const double mu, double (&P)[2])
{
  const double a = W[0], b = W[1], c = W[3];
  P[0] = P[1] = 0.;
  if (!(a > 0.))
    return LocalStatus::prescribed;
  if (q[0] >= 0.)
    return LocalStatus::separated;
  const double d = a * q[1] - q[0] * b, A = q[1] * b - q[0] * c;
  double tau = A != 0. ? -d / A : (d == 0. ? 0. : 2. * mu);
  LocalStatus status = LocalStatus::stick;
  if (!(std::abs(tau) <= mu) || !(a + b * tau > 0.))
  {
    // G has the sign of d on both ends, or stick lies where P_n < 0. Where a + b mu <= 0 in a direction the
    // contact jams before it slips that way, so the other direction is the solution.
    status = LocalStatus::slip;
    tau = d - A * mu >= 0. ? -mu : mu;
    if (a + b * tau <= 0.)
      tau = -tau;
  }
  P[0] = -q[0] / (a + b * tau);
  P[1] = tau * P[0];
  return status;
}

/// Slip direction in space: the σ, |σ| = 1, and λ >= 0 with (A + λ) σ = -d; @p A is 2 x 2, row by row.
void solve_slip_direction(const double (&A)[4], const double (&d)[2], double (&sigma)[2]);

template <>
inline LocalStatus solve_local<3>(const double *W, const double (&q)[3], const double mu, double (&P)[3])
{
  const double a = W[0], b[2] = {W[1], W[2]};
  P[0] = P[1] = P[2] = 0.;
  if (!(a > 0.))
    return LocalStatus::prescribed;
  if (q[0] >= 0.)
    return LocalStatus::separated;
  // divided by -q_n a, so that A and d have no unit and the size of W_tt / W_nn and q_t / q_n
  const double g[2] = {-q[1] / q[0], -q[2] / q[0]};
  if (!std::isfinite(g[0]) || !std::isfinite(g[1]))
    return LocalStatus::separated; // q_n below what can be divided by: the impulse is 0 to rounding
  const double A[4] = {(g[0] * b[0] + W[4]) / a, (g[0] * b[1] + W[5]) / a, (g[1] * b[0] + W[7]) / a,
                       (g[1] * b[1] + W[8]) / a};
  const double d[2] = {g[0] + b[0] / a, g[1] + b[1] / a};
  const double determinant = A[0] * A[3] - A[1] * A[2];
  double tau[2] = {0., 0.};
  LocalStatus status = LocalStatus::stick;
  if (mu > 0. && (d[0] != 0. || d[1] != 0.))
  {
    tau[0] = (-A[3] * d[0] + A[1] * d[1]) / determinant;
    tau[1] = (A[2] * d[0] - A[0] * d[1]) / determinant;
    if (!(tau[0] * tau[0] + tau[1] * tau[1] <= mu * mu) || !(a + b[0] * tau[0] + b[1] * tau[1] > 0.))
    {
      const double d_unit[2] = {d[0] / mu, d[1] / mu};
      double sigma[2];
      solve_slip_direction(A, d_unit, sigma);
      status = LocalStatus::slip;
      tau[0] = mu * sigma[0];
      tau[1] = mu * sigma[1];
    }
  }
  const double oblique = a + b[0] * tau[0] + b[1] * tau[1];
  if (!(oblique > 0.))
    return LocalStatus::prescribed; // only a singular W gets here: the impulse would be infinite
  P[0] = -q[0] / oblique;
  P[1] = tau[0] * P[0];
  P[2] = tau[1] * P[0];
  return status;
}
} // namespace softgrain::contact

#endif
