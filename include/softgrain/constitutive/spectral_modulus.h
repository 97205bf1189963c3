// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_spectral_modulus_h
#define softgrain_constitutive_spectral_modulus_h

#include <softgrain/constitutive/principal_stretches.h>

namespace softgrain::constitutive
{
/// sum_a value_a n_a x n_a.
template <int dim>
inline dealii::SymmetricTensor<2, dim> spectral_tensor(const std::array<double, dim> &value,
                                                       const PrincipalStretches<dim> &stretches)
{
  dealii::SymmetricTensor<2, dim> result;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        result[i][j] += value[a] * stretches.direction[a][i] * stretches.direction[a][j];
  return result;
}

/**
 * @brief Spatial modulus of an isotropic solid in its principal directions.
 *
 * For tau_a(ln lambda_1, …) and b_a = lambda_a^2: normal_ab = d tau_a / d ln lambda_b - 2 tau_a delta_ab and
 * shear_ab = (tau_a b_b - tau_b b_a) / (b_a - b_b), read for a < b only.
 */
template <int dim>
struct SpectralModulus
{
  double normal[dim][dim];
  double shear[dim][dim];

  /// sum_ab normal_ab N_a x N_b + sum_{a<b} shear_ab T_ab x T_ab with N_a = n_a n_a, T_ab = n_a n_b + n_b
  /// n_a.
  dealii::SymmetricTensor<4, dim> rotated_to(const PrincipalStretches<dim> &stretches) const
  {
    constexpr unsigned int n = dealii::SymmetricTensor<2, dim>::n_independent_components;
    const auto &d = stretches.direction;
    // Row r of the basis holds component r of N_1, …, N_dim, then of T_12, …
    double basis[n][n], modulus[n][n] = {};
    unsigned int shear_column = dim;
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = a; b < dim; ++b)
      {
        const unsigned int column = a == b ? a : shear_column++;
        for (unsigned int r = 0; r < n; ++r)
        {
          const auto ij = dealii::SymmetricTensor<2, dim>::unrolled_to_component_indices(r);
          basis[r][column] = d[a][ij[0]] * d[b][ij[1]] + (a == b ? 0. : d[b][ij[0]] * d[a][ij[1]]);
        }
        modulus[column][column] = a == b ? normal[a][a] : shear[a][b];
        if (a != b)
        {
          modulus[a][b] = normal[a][b];
          modulus[b][a] = normal[b][a];
        }
      }
    dealii::SymmetricTensor<4, dim> result;
    for (unsigned int r = 0; r < n; ++r)
    {
      double row[n] = {};
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int l = 0; l < n; ++l)
          row[l] += basis[r][k] * modulus[k][l];
      const auto ij = dealii::SymmetricTensor<2, dim>::unrolled_to_component_indices(r);
      for (unsigned int s = 0; s < n; ++s)
      {
        double sum = 0;
        for (unsigned int l = 0; l < n; ++l)
          sum += row[l] * basis[s][l];
        const auto kl = dealii::SymmetricTensor<2, dim>::unrolled_to_component_indices(s);
        result[ij[0]][ij[1]][kl[0]][kl[1]] = sum;
      }
    }
    return result;
  }
};
} // namespace softgrain::constitutive

#endif
