// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/local_solver.h>

namespace softgrain::contact
{
void solve_slip_direction(const double (&A)[4], const double (&d)[2], double (&sigma)[2])
{
  // |(A + λ)⁻¹ d| = 1 is the quartic f(λ) = det(A + λ)² - |adj(A + λ) d|² = 0. Above the largest real root of
  // det(A + λ) the left side falls from above 1 to 0 without a jump, so that the branch holds a root, and for
  // a positive semi-definite W every point of it has P_n > 0: any root bracketed there is a solution. Scaled
  // so that λ is about 1.
  const double scale = std::max(
      {std::abs(A[0]), std::abs(A[1]), std::abs(A[2]), std::abs(A[3]), std::abs(d[0]), std::abs(d[1])});
  sigma[0] = sigma[1] = 0.;
  if (!(scale > 0.) || !std::isfinite(scale))
    return;
  const double a[4] = {A[0] / scale, A[1] / scale, A[2] / scale, A[3] / scale};
  const double b[2] = {d[0] / scale, d[1] / scale};
  const double determinant = a[0] * a[3] - a[1] * a[2], trace = a[0] + a[3];
  const double e[2] = {a[3] * b[0] - a[1] * b[1], a[0] * b[1] - a[2] * b[0]}; // adj(A) d

  const auto f = [&](const double x, double &derivative)
  {
    const double D = determinant + x * (trace + x), n0 = e[0] + x * b[0], n1 = e[1] + x * b[1];
    derivative = 2. * D * (trace + 2. * x) - 2. * (n0 * b[0] + n1 * b[1]);
    return D * D - n0 * n0 - n1 * n1;
  };

  const double discriminant = 0.25 * trace * trace - determinant;
  double low = discriminant >= 0. ? std::max(0., -0.5 * trace + std::sqrt(discriminant)) : 0.;
  double high =
      std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3]) + std::sqrt(b[0] * b[0] + b[1] * b[1]);
  double x = high, slope;
  // Newton from above; bisection whenever it leaves the bracket or is slow.
  for (unsigned int iteration = 0; iteration < 100; ++iteration)
  {
    const double value = f(x, slope);
    if (value == 0.)
      break;
    (value > 0. ? high : low) = x;
    double next = x - value / slope;
    if (!(next > low && next < high) || iteration % 8 == 7)
      next = 0.5 * (low + high);
    if (std::abs(next - x) <= 1e-16 * high || next == low || next == high)
    {
      x = next;
      break;
    }
    x = next;
  }
  sigma[0] = -(e[0] + x * b[0]);
  sigma[1] = -(e[1] + x * b[1]);
  const double length = std::sqrt(sigma[0] * sigma[0] + sigma[1] * sigma[1]);
  if (length > 0.)
  {
    sigma[0] /= length;
    sigma[1] /= length;
  }
}
} // namespace softgrain::contact
