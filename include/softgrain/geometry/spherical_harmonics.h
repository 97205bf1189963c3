// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_spherical_harmonics_h
#define softgrain_geometry_spherical_harmonics_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <complex>
#include <functional>
#include <vector>

namespace softgrain
{
/**
 * @brief A smooth function of a direction: a sum of spherical harmonics up to a degree.
 *
 * With the regular solid harmonics R_lm = r^l P_lm(cos) exp(i m phi)/(l + m)! it is the real part of
 * sum_l sum_{m >= 0} a_lm R_lm of the unit vector. Derivatives of R_lm are R_(l-1)k again, with factors of 1
 * and 1/2, so the sum and its first and second derivatives need one table of them, and there is no pole (E.
 * J. Weniger, The spherical tensor gradient operator, 2005).
 */
class SphericalHarmonics
{
public:
  using Vector = dealii::Tensor<1, 3>;

  SphericalHarmonics() = default;

  /// The best of this degree for a function of unit vectors, in the mean square: by Gauss's quadrature in
  /// height and equal angles, where @p oversampling times as many places are looked at as it has unknowns in
  /// either direction. Harmonics of degree l are multiplied by exp(-@p damping l (l + 1)).
  SphericalHarmonics(unsigned int degree,
                     const std::function<double(const Vector &)> &function,
                     double damping,
                     unsigned int oversampling = 3);

  struct Value
  {
    double value = 0.;
    Vector gradient;                       ///< of the function of any vector that depends on its direction
    dealii::SymmetricTensor<2, 3> hessian; ///< alone, at the unit vector
  };
  Value at(const Vector &unit) const;
  double value(const Vector &unit) const;

  /// Multiplies the function.
  void scale(double factor);

  /// Integral of a function of the value over all directions, exact for powers up to @p power.
  double integral(const std::function<double(double)> &function, unsigned int power) const;

private:
  using Complex = std::complex<double>;
  using Coefficients = std::vector<Complex>; ///< see place()

  /// The coefficients of a derivative: those of degree l stand with the harmonics of degree l - 1.
  Coefficients derivative(const Coefficients &of, unsigned int direction) const;
  Coefficients table(const Vector &unit) const;
  /// Calls @p function(unit vector, weight) with @p n heights.
  template <class Function>
  static void for_directions(unsigned int n, const Function &function);
  static std::size_t place(const unsigned int l, const unsigned int m) { return l * (l + 1) / 2 + m; }

  unsigned int degree = 0;
  std::vector<double> over; ///< 1/((l + m)(l - m))
  Coefficients sum;
  std::array<Coefficients, 3> first;
  std::array<std::array<Coefficients, 3>, 3> second; ///< its lower half
};
} // namespace softgrain

#endif
