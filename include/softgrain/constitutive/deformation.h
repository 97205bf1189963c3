// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_deformation_h
#define softgrain_constitutive_deformation_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <limits>

namespace softgrain::constitutive
{
/// Whether a volume ratio det F is positive and finite; false for NaN.
inline bool is_admissible(const double volume_ratio)
{
  return volume_ratio > 0. && volume_ratio <= std::numeric_limits<double>::max();
}

/// Left Cauchy-Green tensor b = F F^T.
template <int dim>
inline dealii::SymmetricTensor<2, dim> left_cauchy_green(const dealii::Tensor<2, dim> &F)
{
  dealii::SymmetricTensor<2, dim> b;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = i; j < dim; ++j)
      b[i][j] = F[i] * F[j];
  return b;
}

/// Isotropic linear elasticity: volumetric I x I + 2 shear II_s, II_s the identity on symmetric tensors.
template <int dim>
inline dealii::SymmetricTensor<4, dim> isotropic_modulus(const double volumetric, const double shear)
{
  dealii::SymmetricTensor<4, dim> c;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
    {
      c[i][i][j][j] = volumetric + (i == j ? 2 * shear : 0.);
      if (i < j)
        c[i][j][i][j] = shear;
    }
  return c;
}
} // namespace softgrain::constitutive

#endif
