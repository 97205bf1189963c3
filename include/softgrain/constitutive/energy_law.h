// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_energy_law_h
#define softgrain_constitutive_energy_law_h

#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/elastic_law.h>

#include <deal.II/base/config.h>

#ifndef DEAL_II_TRILINOS_WITH_SACADO
#error "energy_law.h needs a deal.II with Trilinos' Sacado"
#endif

#include <Sacado.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

// deal.II's tensors of Sacado's numbers of fixed size, as its sacado_product_types.h has them for those of
// any size: no memory is allocated for them, which makes them several times as fast.
namespace dealii
{
namespace internal
{
template <typename T, int n>
struct ProductTypeImpl<Sacado::Fad::SFad<T, n>, Sacado::Fad::SFad<T, n>>
{
  using type = Sacado::Fad::SFad<T, n>;
};
template <typename T, int n>
struct ProductTypeImpl<Sacado::Fad::SFad<T, n>, double>
{
  using type = Sacado::Fad::SFad<T, n>;
};
template <typename T, int n>
struct ProductTypeImpl<double, Sacado::Fad::SFad<T, n>>
{
  using type = Sacado::Fad::SFad<T, n>;
};
} // namespace internal

template <typename T, int n>
struct EnableIfScalar<Sacado::Fad::SFad<T, n>>
{
  using type = Sacado::Fad::SFad<T, n>;
};
} // namespace dealii

namespace softgrain::constitutive
{
/**
 * @brief An elastic law that gives its energy alone: stress and tangent are exact derivatives by Sacado.
 *
 * @p Derived has a member template, for numbers of any type,
 * @code
 * template <typename Number>
 * Number energy(const dealii::Tensor<2, 3, Number> &F, const Number &log_J) const;
 * @endcode
 * which is psi(F) [J/m^3], with ln det F handed in because the logarithm of a determinant next to nothing has
 * no derivative in the range of numbers. In the plane F has a zz of 1. With F(h) = (I + h) F,
 *
 *   tau_ij = d psi / d h_ij,   c_ijkl = d^2 psi / (d h_ij d h_kl) - delta_ik tau_jl   at h = 0.
 */
template <int dim, typename Derived>
class EnergyLaw : public ElasticLaw<dim>
{
public:
  std::size_t update(const Inputs<dim> &in, const Outputs<dim> &out) const override
  {
    for (std::size_t q = 0; q < in.n_points; ++q)
    {
      const double J = dealii::determinant(in.deformation_gradient[q]);
      if (!is_admissible(J))
        return q;
      const bool good = out.tangent ? write<Second>(in.deformation_gradient[q], J, out, q)
                                    : write<First>(in.deformation_gradient[q], J, out, q);
      if (!good)
        return q;
    }
    return in.n_points;
  }

private:
  /// Derivatives are taken by the entries of h, zz among them in the plane.
  static constexpr int n = dim * dim + (dim == 2 ? 1 : 0);
  using First = Sacado::Fad::SFad<double, n>;
  using Second = Sacado::Fad::SFad<First, n>;

  static double value(const First &x) { return x.val(); }
  static double value(const Second &x) { return x.val().val(); }
  static double slope(const First &x, const int i) { return x.fastAccessDx(i); }
  static double slope(const Second &x, const int i) { return x.fastAccessDx(i).val(); }

  static void seed(First &x, const int i, const double at) { x = First(n, i, at); }
  static void seed(Second &x, const int i, const double at) { x = Second(n, i, First(n, i, at)); }

  /// Writes point @p q. @return false when the energy or the stress is not finite
  template <typename Number>
  bool
  write(const dealii::Tensor<2, dim> &F, const double J, const Outputs<dim> &out, const std::size_t q) const
  {
    dealii::Tensor<2, dim, Number> moved; // I + h
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        seed(moved[i][j], i * dim + j, i == j);
    Number volume = moved[0][0] * moved[1][1] - moved[0][1] * moved[1][0];
    if constexpr (dim == 3)
      volume = volume * moved[2][2] + moved[0][2] * (moved[1][0] * moved[2][1] - moved[1][1] * moved[2][0]) -
               moved[1][2] * (moved[0][0] * moved[2][1] - moved[0][1] * moved[2][0]);
    dealii::Tensor<2, 3, Number> gradient;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
      {
        Number sum = moved[i][0] * F[0][j];
        for (int k = 1; k < dim; ++k)
          sum += moved[i][k] * F[k][j];
        gradient[i][j] = sum;
      }
    if constexpr (dim == 2)
    {
      seed(gradient[2][2], n - 1, 1.);
      volume *= gradient[2][2];
    }
    using std::log;
    const Number log_J = log(volume) + std::log(J);
    const Number psi = static_cast<const Derived *>(this)->energy(gradient, log_J);

    dealii::SymmetricTensor<2, dim> tau;
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j)
        tau[i][j] = (slope(psi, i * dim + j) + slope(psi, j * dim + i)) / 2;
    if (!std::isfinite(value(psi)) || !std::isfinite(tau.norm()))
      return false;
    if (out.stress)
      out.stress[q] = tau;
    if constexpr (std::is_same_v<Number, Second>)
      out.tangent[q] = modulus(psi, tau);
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[q] = slope(psi, n - 1);
    if (out.energy)
      out.energy[q] = value(psi);
    if (out.dissipation)
      out.dissipation[q] = 0;
    return true;
  }

  static dealii::SymmetricTensor<4, dim> modulus(const Second &psi,
                                                 const dealii::SymmetricTensor<2, dim> &tau)
  {
    const auto entry = [&](const int i, const int j, const int k, const int l)
    { return psi.fastAccessDx(i * dim + j).fastAccessDx(k * dim + l) - (i == k ? tau[j][l] : 0.); };
    dealii::SymmetricTensor<4, dim> c;
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j)
        for (int k = 0; k < dim; ++k)
          for (int l = k; l < dim; ++l)
            // Equal up to rounding.
            c[i][j][k][l] =
                (entry(i, j, k, l) + entry(j, i, k, l) + entry(i, j, l, k) + entry(j, i, l, k)) / 4;
    return c;
  }
};
} // namespace softgrain::constitutive

#endif
