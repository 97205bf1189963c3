// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_principal_stretches_h
#define softgrain_constitutive_principal_stretches_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace softgrain::constitutive
{
/// Logarithms of the singular values of F and the spatial directions (left singular vectors) they belong to.
template <int dim>
struct PrincipalStretches
{
  std::array<double, dim> log;
  std::array<dealii::Tensor<1, dim>, dim> direction;
};

/**
 * @brief Principal stretches of F in closed form; @p J = det F > 0.
 *
 * With the complex numbers alpha and beta of F z = alpha z + beta conj(z) the stretches are |alpha| + |beta|
 * and |alpha| - |beta|, and alpha beta points at twice the angle of the first direction. Unlike the
 * eigenvalues of b this keeps all digits when the stretches are nearly equal and when their ratio is extreme.
 */
inline PrincipalStretches<2> principal_stretches(const dealii::Tensor<2, 2> &F, const double J)
{
  const double alpha_re = (F[0][0] + F[1][1]) / 2, alpha_im = (F[1][0] - F[0][1]) / 2;
  const double beta_re = (F[0][0] - F[1][1]) / 2, beta_im = (F[1][0] + F[0][1]) / 2;
  const double alpha = std::sqrt(alpha_re * alpha_re + alpha_im * alpha_im);
  const double beta = std::sqrt(beta_re * beta_re + beta_im * beta_im);
  const double largest = alpha + beta, smallest = J / largest;

  // half the logarithm of the ratio of the stretches
  const double mean = std::log(J) / 2;
  const double half = beta < smallest ? std::log1p(2 * beta / smallest) / 2 : std::log(largest) - mean;

  // Equal stretches leave the direction open; any will do.
  double cos2 = 1, sin2 = 0;
  if (beta > std::numeric_limits<double>::min())
  {
    cos2 = (alpha_re * beta_re - alpha_im * beta_im) / (alpha * beta);
    sin2 = (alpha_re * beta_im + alpha_im * beta_re) / (alpha * beta);
  }
  // the half angle, from the side on which no digits cancel
  dealii::Tensor<1, 2> n;
  if (cos2 >= 0)
  {
    n[0] = std::sqrt((1 + cos2) / 2);
    n[1] = sin2 / (2 * n[0]);
  }
  else
  {
    n[1] = std::sqrt((1 - cos2) / 2);
    n[0] = sin2 / (2 * n[1]);
  }
  PrincipalStretches<2> result;
  result.log = {{mean + half, mean - half}};
  result.direction[0] = n;
  result.direction[1][0] = -n[1];
  result.direction[1][1] = n[0];
  return result;
}

/**
 * @brief Principal stretches of F by one-sided Jacobi rotations.
 *
 * The columns of F are rotated in pairs until they are orthogonal; then their lengths are the stretches. It
 * needs no gap between the stretches and, working on F and not on b, keeps the digits of a small one beside a
 * large one.
 */
inline PrincipalStretches<3> principal_stretches(const dealii::Tensor<2, 3> &F, const double /*J*/)
{
  std::array<dealii::Tensor<1, 3>, 3> column;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      column[j][i] = F[i][j];

  // Convergence is quadratic: five or six sweeps do; the limit only guards against rounding going in circles.
  bool rotated = true;
  for (unsigned int sweep = 0; rotated && sweep < 30; ++sweep)
  {
    rotated = false;
    for (const auto &pair : {std::make_pair(0, 1), std::make_pair(0, 2), std::make_pair(1, 2)})
    {
      dealii::Tensor<1, 3> &a = column[pair.first], &b = column[pair.second];
      const double aa = a * a, bb = b * b, ab = a * b;
      if (!(std::abs(ab) > std::numeric_limits<double>::epsilon() * std::sqrt(aa) * std::sqrt(bb)))
        continue;
      rotated = true;
      const double zeta = (bb - aa) / (2 * ab);
      const double tangent = std::copysign(1., zeta) / (std::abs(zeta) + std::hypot(1., zeta));
      const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
      const dealii::Tensor<1, 3> a_old = a;
      a = cosine * a_old - sine * b;
      b = sine * a_old + cosine * b;
    }
  }
  PrincipalStretches<3> result;
  for (unsigned int i = 0; i < 3; ++i)
  {
    // The floor is reached only by a stretch below the range of doubles, beside a positive det F by rounding.
    const double length =
        std::max(std::hypot(column[i][0], column[i][1], column[i][2]), std::numeric_limits<double>::min());
    result.log[i] = std::log(length);
    result.direction[i] = column[i] / length;
  }
  return result;
}
} // namespace softgrain::constitutive

#endif
