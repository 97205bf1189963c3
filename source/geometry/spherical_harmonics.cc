// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/spherical_harmonics.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
using dealii::numbers::PI;
} // namespace

/// Angles are the same in the mirrors of all three axes.
template <class Function>
void SphericalHarmonics::for_directions(const unsigned int n, const Function &function)
{
  const dealii::QGauss<1> heights(n);
  const unsigned int n_angles = 4 * ((n + 1) / 2);
  for (unsigned int i = 0; i < n; ++i)
  {
    const double height = 2. * heights.point(i)[0] - 1., beside = std::sqrt(1. - height * height);
    for (unsigned int k = 0; k < n_angles; ++k)
    {
      const double angle = 2. * PI * (k + 0.5) / n_angles;
      function(Vector({beside * std::cos(angle), beside * std::sin(angle), height}),
               4. * PI * heights.weight(i) / n_angles);
    }
  }
}

SphericalHarmonics::SphericalHarmonics(const unsigned int degree,
                                       const std::function<double(const Vector &)> &function,
                                       const double damping,
                                       const unsigned int oversampling)
    : degree(degree), over(place(degree + 1, 0)), sum(place(degree + 1, 0))
{
  for (unsigned int l = 0; l <= degree; ++l)
    for (unsigned int m = 0; m < l; ++m)
      over[place(l, m)] = 1. / (static_cast<double>(l + m) * (l - m));
  for_directions(oversampling * (degree + 1),
                 [&](const Vector &unit, const double weight)
                 {
                   const Coefficients here = table(unit);
                   const double f = weight * function(unit);
                   for (std::size_t i = 0; i < sum.size(); ++i)
                     sum[i] += f * std::conj(here[i]);
                 });
  for (unsigned int l = 0; l <= degree; ++l)
    for (unsigned int m = 0; m <= l; ++m)
    {
      const double square =
          (m == 0 ? 2. : 1.) * PI * 2. / ((2. * l + 1.) * std::tgamma(l + m + 1.) * std::tgamma(l - m + 1.));
      sum[place(l, m)] *= std::exp(-damping * l * (l + 1.)) / square;
    }
  for (unsigned int d = 0; d < 3; ++d)
  {
    first[d] = derivative(sum, d);
    for (unsigned int e = 0; e <= d; ++e)
      second[d][e] = derivative(first[d], e);
  }
}

/// d/dz R_lm = R_(l-1)m, (d/dx - i d/dy) R_lm = R_(l-1)(m-1), (d/dx + i d/dy) R_lm = -R_(l-1)(m+1), where
/// R_l(-1) = -conj(R_l1).
SphericalHarmonics::Coefficients SphericalHarmonics::derivative(const Coefficients &of,
                                                                const unsigned int direction) const
{
  Coefficients result(of.size());
  for (unsigned int l = 1; l <= degree; ++l)
    for (unsigned int m = 0; m <= l; ++m)
    {
      const Complex a = of[place(l, m)];
      if (direction == 2)
      {
        if (m < l)
          result[place(l - 1, m)] += a;
        continue;
      }
      const Complex half = direction == 0 ? 0.5 * a : Complex(0., 0.5) * a;
      if (m > 0)
        result[place(l - 1, m - 1)] += half;
      else if (l > 1)
        result[place(l - 1, 1)] -= std::conj(half);
      if (m + 1 < l)
        result[place(l - 1, m + 1)] += direction == 0 ? -half : half;
    }
  return result;
}

/// R_lm of a unit vector, which is (x + i y)/(2m) R_(m-1)(m-1) for l = m, and for greater l
/// ((2l - 1) z R_(l-1)m - R_(l-2)m)/((l + m)(l - m)).
SphericalHarmonics::Coefficients SphericalHarmonics::table(const Vector &unit) const
{
  Coefficients R(place(degree + 1, 0));
  double re = 1., im = 0.; // of R_mm
  for (unsigned int m = 0; m <= degree; ++m)
  {
    if (m > 0)
    {
      const double before = re;
      re = (unit[0] * re - unit[1] * im) / (2. * m);
      im = (unit[0] * im + unit[1] * before) / (2. * m);
    }
    R[place(m, m)] = {re, im};
    Complex last, here(re, im);
    for (unsigned int l = m + 1; l <= degree; ++l)
    {
      const double share = over[place(l, m)];
      const Complex next = (share * (2. * l - 1.) * unit[2]) * here - share * last;
      R[place(l, m)] = next;
      last = here;
      here = next;
    }
  }
  return R;
}

SphericalHarmonics::Value SphericalHarmonics::at(const Vector &unit) const
{
  const Coefficients R = table(unit);
  const auto of_degree = [&](const Coefficients &a, const unsigned int l)
  {
    double sum = 0.;
    for (unsigned int m = 0; m <= l; ++m)
      sum += a[place(l, m)].real() * R[place(l, m)].real() - a[place(l, m)].imag() * R[place(l, m)].imag();
    return sum;
  };
  // A part of degree l is divided by the l-th power of the length, so that only the direction counts.
  Value result;
  Vector slope;                 // sum of l grad
  double once = 0., twice = 0.; // sums of l and of l (l + 2) times the part
  dealii::Tensor<2, 3> bend;
  for (unsigned int l = 0; l <= degree; ++l)
  {
    const double part = of_degree(sum, l);
    result.value += part;
    once += l * part;
    twice += l * (l + 2.) * part;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double by_d = of_degree(first[d], l); // of degree l + 1
      result.gradient[d] += by_d;
      slope[d] += (l + 1.) * by_d;
      for (unsigned int e = 0; e <= d; ++e)
        bend[d][e] += of_degree(second[d][e], l);
    }
  }
  result.gradient -= once * unit;
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int e = 0; e <= d; ++e)
      result.hessian[d][e] = bend[d][e] - slope[d] * unit[e] - slope[e] * unit[d] +
                             twice * unit[d] * unit[e] - (d == e ? once : 0.);
  return result;
}

double SphericalHarmonics::value(const Vector &unit) const
{
  const Coefficients R = table(unit);
  double result = 0.;
  for (std::size_t i = 0; i < sum.size(); ++i)
    result += sum[i].real() * R[i].real() - sum[i].imag() * R[i].imag();
  return result;
}

void SphericalHarmonics::scale(const double factor)
{
  const auto multiply = [factor](Coefficients &all)
  {
    for (Complex &a : all)
      a *= factor;
  };
  multiply(sum);
  for (unsigned int d = 0; d < 3; ++d)
  {
    multiply(first[d]);
    for (unsigned int e = 0; e <= d; ++e)
      multiply(second[d][e]);
  }
}

double SphericalHarmonics::integral(const std::function<double(double)> &function,
                                    const unsigned int power) const
{
  double result = 0.;
  for_directions(power * degree / 2 + 1,
                 [&](const Vector &unit, const double weight) { result += weight * function(value(unit)); });
  return result;
}
} // namespace softgrain
