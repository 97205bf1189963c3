// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_logarithmic_strain_h
#define softgrain_constitutive_logarithmic_strain_h

#include <softgrain/constitutive/principal_stretches.h>

namespace softgrain::constitutive
{
/// First divided difference of the logarithm at exp(2 a) and exp(2 b).
inline double log_difference(const double a, const double b)
{
  const double x = a - b;
  return (x != 0 ? x / std::sinh(x) : 1.) / std::exp(a + b);
}

/// Second divided difference of the logarithm at exp(2 e) of three values.
inline double log_difference(std::array<double, 3> e)
{
  std::sort(e.begin(), e.end());
  const std::array<double, 3> c = {{std::exp(2 * e[0]), std::exp(2 * e[1]), std::exp(2 * e[2])}};
  if (e[2] - e[0] > 0.1)
    return (log_difference(e[2], e[1]) - log_difference(e[1], e[0])) / (c[2] - c[0]);
  // Close together: the series about the mean, h_j the complete symmetric polynomials of the distances u.
  const double mean = (c[0] + c[1] + c[2]) / 3;
  const double u = c[0] / mean - 1, v = c[1] / mean - 1, w = c[2] / mean - 1;
  const double e2 = u * v + v * w + w * u, e3 = u * v * w;
  double h[3] = {1, 0, 0}, sum = -0.5; // h_j, h_{j-1}, h_{j-2}; u + v + w = 0
  for (unsigned int j = 1; j < 24; ++j)
  {
    const double next = -e2 * h[1] + e3 * h[2];
    h[2] = h[1];
    h[1] = h[0];
    h[0] = next;
    sum += (j % 2 == 1 ? 1 : -1) * next / (j + 2);
  }
  return sum / (mean * mean);
}

/**
 * @brief Logarithmic strain E = ln U of F = R U, and what a stress T conjugate to it is in space.
 *
 * With lambda_a the principal stretches, N_a and n_a = R N_a their directions before and after, and
 * components in these: tau_ab = h_ab T_ab with h_ab = x / sinh(x), x = ln(lambda_a / lambda_b); Miehe, Apel
 * and Lambrecht (2002), section 2.
 */
template <int dim>
class LogarithmicStrain
{
public:
  using Symmetric = dealii::SymmetricTensor<2, dim>;

  LogarithmicStrain(const dealii::Tensor<2, dim> &F, const double J) : after(principal_stretches(F, J))
  {
    double largest = after.log[0];
    for (unsigned int a = 0; a < dim; ++a)
    {
      for (unsigned int j = 0; j < dim; ++j)
        for (unsigned int i = 0; i < dim; ++i)
          before[a][j] += after.direction[a][i] * F[i][j];
      before[a] /= std::exp(after.log[a]); // first, because the square of a tiny length is zero
      before[a] /= before[a].norm();
      largest = std::max(largest, after.log[a]);
      strain += after.log[a] * pair(a, a);
    }
    // A ratio beyond e^150 counts as that: it only keeps squares within the range of numbers.
    for (unsigned int a = 0; a < dim; ++a)
      relative[a] = std::max(after.log[a] - largest, -150.);
  }

  /// Kirchhoff stress.
  Symmetric stress(const Symmetric &T) const
  {
    Symmetric tau;
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = i; j < dim; ++j)
            tau[i][j] += factor(a, b) * (T * pair(a, b)) * after.direction[a][i] * after.direction[b][j];
    return tau;
  }

  /// Spatial modulus (see Outputs::tangent) from @p T and D = dT/dE.
  dealii::SymmetricTensor<4, dim> modulus(const Symmetric &T, const dealii::SymmetricTensor<4, dim> &D) const
  {
    double c[dim][dim][dim][dim] = {};
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
      {
        const Symmetric image = factor(a, b) * (D * pair(a, b));
        const double T_ab = T * pair(a, b);
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int l = 0; l < dim; ++l)
            c[k][l][a][b] += factor(k, l) * (image * pair(k, l));
        // T : second derivative of E, a sum of products d_ak d'_kb
        for (unsigned int k = 0; k < dim; ++k)
        {
          const double g = T_ab * 2 * log_difference({{relative[a], relative[k], relative[b]}}) *
                           std::exp(relative[a] + 2 * relative[k] + relative[b]);
          c[a][k][k][b] += g;
          c[k][b][a][k] += g;
        }
      }
    return in_space(c);
  }

  /// G exp(-E) exp(E - D): F G^-1 keeps its rotation, and its logarithmic strain falls from E to E - D.
  dealii::Tensor<2, dim> relaxed(const dealii::Tensor<2, dim> &G, const Symmetric &D) const
  {
    const double mean = dealii::trace(strain) / dim;
    Symmetric rest = strain - D;
    dealii::Tensor<2, dim> inverse;
    for (unsigned int a = 0; a < dim; ++a)
    {
      rest[a][a] -= mean;
      inverse += std::exp(mean - after.log[a]) * dealii::Tensor<2, dim>(pair(a, a));
    }
    return G * inverse * exponential(rest);
  }

  Symmetric strain;

private:
  Symmetric pair(const unsigned int a, const unsigned int b) const
  {
    return dealii::symmetrize(dealii::outer_product(before[a], before[b]));
  }

  double factor(const unsigned int a, const unsigned int b) const
  {
    const double x = relative[a] - relative[b];
    return x != 0 ? x / std::sinh(x) : 1.;
  }

  dealii::SymmetricTensor<4, dim> in_space(const double (&c)[dim][dim][dim][dim]) const
  {
    const auto &n = after.direction;
    dealii::SymmetricTensor<4, dim> result;
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int l = 0; l < dim; ++l)
            result +=
                c[a][b][k][l] * dealii::outer_product(dealii::symmetrize(dealii::outer_product(n[a], n[b])),
                                                      dealii::symmetrize(dealii::outer_product(n[k], n[l])));
    return result;
  }

  /// Series of a part that is small enough, squared as often as it was halved.
  static dealii::Tensor<2, dim> exponential(const Symmetric &exponent)
  {
    const dealii::Tensor<2, dim> one = dealii::unit_symmetric_tensor<dim>();
    const int halvings = std::max(0, 2 + std::ilogb(std::max(exponent.norm(), 1.)));
    const dealii::Tensor<2, dim> small = std::ldexp(1., -halvings) * exponent;
    dealii::Tensor<2, dim> result = one;
    for (unsigned int i = 16; i > 0; --i)
      result = one + (1. / i) * small * result;
    for (int i = 0; i < halvings; ++i)
      result = result * result;
    return result;
  }

  PrincipalStretches<dim> after;
  std::array<dealii::Tensor<1, dim>, dim> before;
  std::array<double, dim> relative;
};
} // namespace softgrain::constitutive

#endif
