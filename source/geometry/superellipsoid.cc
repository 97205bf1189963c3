// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/superellipsoid.h>
#include <softgrain/geometry/turned_axes.h>
#include <softgrain/parameters/parameter_values.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain
{
namespace
{
using Vector = dealii::Tensor<1, 3>;

constexpr double most_slender = 10.;
constexpr double largest_exponent = 20.; ///< edges are then a tenth of a semi-axis wide

/// N = (|u|^p + |v|^p)^(1/p).
double norm_of(const double u, const double v, const double p)
{
  const double most = std::max(std::abs(u), std::abs(v));
  return most > 0.
             ? most * std::pow(std::pow(std::abs(u) / most, p) + std::pow(std::abs(v) / most, p), 1. / p)
             : 0.;
}

/// N with its derivatives for u, v >= 0, one of them not 0.
struct Norm
{
  Norm(const double u, const double v, const double p) : value(norm_of(u, v, p))
  {
    const double a = u / value, b = v / value;
    by_u = std::pow(a, p - 1.);
    by_v = std::pow(b, p - 1.);
    u_u = (p - 1.) / value * (std::pow(a, p - 2.) - by_u * by_u);
    v_v = (p - 1.) / value * (std::pow(b, p - 2.) - by_v * by_v);
    u_v = -(p - 1.) / value * by_u * by_v;
  }
  double value, by_u, by_v, u_u, v_v, u_v;
};

/// The norm dual to that with exponent @p p.
double dual(const double u, const double v, const double p)
{
  return norm_of(u, v, p / (p - 1.));
}
} // namespace

Superellipsoid::Superellipsoid(const Place &center,
                               const Vector &semi_axes,
                               const std::array<double, 2> &exponents,
                               const Vector &rotation)
    : ConvexSolid(center, rotation), semi_axes(semi_axes), exponents(exponents)
{
}

void Superellipsoid::declare_axes(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  prm.declare_entry("Semi-axes", "0, 0, 0", List(Double(0), 3, 3, ","),
                    "Semi-axes of an ellipsoid or a superellipsoid, \"a, b, c\". Units: m.");
  declare_rotation(prm);
}

void Superellipsoid::parse_axes(const dealii::ParameterHandler &prm, const Place &body_center)
{
  parse_place(prm, body_center);
  semi_axes = vector_of_numbers<3>(prm.get("Semi-axes"));
}

void Superellipsoid::declare_parameters(dealii::ParameterHandler &prm) const
{
  declare_axes(prm);
  prm.declare_entry("Exponents", "2, 2", dealii::Patterns::List(dealii::Patterns::Double(), 2, 2, ","),
                    "Exponents \"n, m\" of a superellipsoid ((x/a)^m + (y/b)^m)^(n/m) + (z/c)^n = 1, from 2 "
                    "to 20: with \"2, 2\" it is an ellipsoid, with larger ones a box, and with a larger n "
                    "alone a cylinder, with round edges.");
}

void Superellipsoid::parse_parameters(const dealii::ParameterHandler &prm, const Place &body_center)
{
  parse_axes(prm, body_center);
  const dealii::Tensor<1, 2> both = vector_of_numbers<2>(prm.get("Exponents"));
  exponents = {{both[0], both[1]}};
}

void Superellipsoid::check(const std::string &body) const
{
  const auto [least, greatest] = std::minmax({semi_axes[0], semi_axes[1], semi_axes[2]});
  std::ostringstream axes;
  axes << "'" << body << "/Semi-axes' = '" << semi_axes[0] << ", " << semi_axes[1] << ", " << semi_axes[2]
       << "' ";
  if (!(least > 0.))
    throw InputError(axes.str() + "leaves the body empty: all must be greater than 0");
  if (greatest > most_slender * least)
    throw InputError(axes.str() + "is not allowed: one may be at most ten times another");
  for (const double exponent : exponents)
    if (!(exponent >= 2. && exponent <= largest_exponent))
    {
      std::ostringstream text;
      text << "'" << body << "/Exponents' = '" << exponents[0] << ", " << exponents[1]
           << "' is not allowed: both must be between 2 and " << largest_exponent;
      throw InputError(text.str());
    }
}

Superellipsoid::Vector Superellipsoid::over_axes(const Place &p) const
{
  Vector x = (p - center) * turn;
  for (unsigned int d = 0; d < 3; ++d)
    x[d] /= semi_axes[d];
  return x;
}

Gauge Superellipsoid::gauge(const Place &p) const
{
  Vector x = over_axes(p), sign;
  for (unsigned int d = 0; d < 3; ++d)
  {
    sign[d] = x[d] < 0. ? -1. : 1.;
    x[d] = std::abs(x[d]);
  }
  const double n = exponents[0], m = exponents[1];
  const bool at_pole = x[0] + x[1] < 1e-150;
  const Norm inner = at_pole ? Norm(1., 0., m) : Norm(x[0], x[1], m);
  const double r = at_pole ? 0. : inner.value;
  const Norm outer(r, x[2], n);
  // N_r times the second derivatives of r, which are as large as 1/r at the poles.
  const double slope = std::pow(r / outer.value, n - 2.) / outer.value * inner.value;
  const std::array<double, 2> along = {{inner.by_u, inner.by_v}};
  Vector gradient({outer.by_u * inner.by_u, outer.by_u * inner.by_v, outer.by_v});
  dealii::SymmetricTensor<2, 3> hessian;
  hessian[0][0] = slope * inner.u_u;
  hessian[0][1] = slope * inner.u_v;
  hessian[1][1] = slope * inner.v_v;
  for (unsigned int i = 0; i < 2; ++i)
  {
    for (unsigned int j = i; j < 2; ++j)
      hessian[i][j] += outer.u_u * along[i] * along[j];
    hessian[i][2] = outer.u_v * along[i];
  }
  hessian[2][2] = outer.v_v;
  Gauge result;
  result.value = outer.value;
  for (unsigned int d = 0; d < 3; ++d)
    gradient[d] *= sign[d] / semi_axes[d];
  result.gradient = turn * gradient;
  dealii::Tensor<2, 3> scaled;
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int e = 0; e < 3; ++e)
      scaled[d][e] = hessian[d][e] * sign[d] * sign[e] / (semi_axes[d] * semi_axes[e]);
  result.hessian = dealii::symmetrize(turn * scaled * dealii::transpose(turn));
  return result;
}

double Superellipsoid::depth(const Place &p) const
{
  const Vector x = over_axes(p);
  return (1. - norm_of(norm_of(x[0], x[1], exponents[1]), x[2], exponents[0])) *
         std::min({semi_axes[0], semi_axes[1], semi_axes[2]});
}

double Superellipsoid::volume() const
{
  const double s = 2. / exponents[0], t = 2. / exponents[1];
  return 2. * semi_axes[0] * semi_axes[1] * semi_axes[2] * s * t * std::beta(0.5 * s + 1., s) *
         std::beta(0.5 * t, 0.5 * t);
}

std::pair<double, double> Superellipsoid::distances_from_plane(const Place &point, const Vector &normal) const
{
  Vector along;
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int e = 0; e < 3; ++e)
      along[d] += semi_axes[d] * turn[e][d] * normal[e];
  const double reach = dual(dual(along[0], along[1], exponents[1]), along[2], exponents[0]),
               middle = (center - point) * normal;
  return {middle - reach, middle + reach};
}

double Superellipsoid::beyond_extents() const
{
  return std::sqrt(3.) * std::pow(3., -1. / std::max(exponents[0], exponents[1]));
}

SurfacePlace<3> Superellipsoid::place(const Place &x) const
{
  return place_on_ray(center, x, gauge(x));
}

std::vector<double> Superellipsoid::numbers() const
{
  std::vector<double> all(exponents.begin(), exponents.end());
  for (const auto &of_three : {Vector(center), semi_axes, rotation})
    for (unsigned int d = 0; d < 3; ++d)
      all.push_back(of_three[d]);
  return all;
}

namespace
{
[[maybe_unused]] const bool registered =
    Registry<Shape<3>>::instance().add(
        "ellipsoid", "Semi-axes and Rotation", [] { return std::make_unique<Ellipsoid>(); }) &&
    Registry<Shape<3>>::instance().add("superellipsoid",
                                       "Semi-axes, Exponents and Rotation: also boxes and cylinders with "
                                       "round edges",
                                       [] { return std::make_unique<Superellipsoid>(); });
} // namespace
} // namespace softgrain
