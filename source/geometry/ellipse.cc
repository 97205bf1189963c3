// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/ellipse.h>
#include <softgrain/parameters/parameter_values.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>

namespace softgrain
{
namespace
{
using Vector = dealii::Tensor<1, 2>;
using dealii::numbers::PI;

/// Axes that differ by more than this make tips that no grid resolves.
constexpr double most_slender = 100.;

/// Root t of (a x / (t + a²))² + (b y / (t + b²))² = 1 above -b², for a >= b and x, y >= 0: the foot of (x,
/// y) is then (a² x / (t + a²), b² y / (t + b²)). The function falls there, so that halving always finds it.
double foot_parameter(const double a, const double b, const double x, const double y)
{
  double low = -b * b + b * y, high = -b * b + std::hypot(a * x, b * y);
  while (true)
  {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high))
      return middle;
    const double u = a * x / (middle + a * a), v = b * y / (middle + b * b);
    (u * u + v * v > 1. ? low : high) = middle;
  }
}

/// The place of the quarter x, y >= 0 of an ellipse with axes a >= b along x and y nearest to (x, y).
Vector foot_in_quarter(const double a, const double b, const double x, const double y)
{
  if (y > 0.)
  {
    const double t = foot_parameter(a, b, x, y);
    return Vector({a * a * x / (t + a * a), b * b * y / (t + b * b)});
  }
  // On the long axis: near the middle the sides are nearest, else the tip.
  const double inner = (a * a - b * b) / a;
  if (x < inner)
  {
    const double u = a * a * x / (a * a - b * b);
    return Vector({u, b * std::sqrt(std::max(0., 1. - u * u / (a * a)))});
  }
  return Vector({a, 0.});
}
} // namespace

void Ellipse2D::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  prm.declare_entry("Semi-axes", "0, 0", List(Double(0), 2, 2, ","), "Semi-axes of an ellipse. Units: m.");
  prm.declare_entry("Angle", "0", Double(-360, 360),
                    "Rotation of a rectangle or an ellipse, counter-clockwise. Units: degrees.");
}

void Ellipse2D::parse_parameters(const dealii::ParameterHandler &prm, const Place &body_center)
{
  center = body_center;
  semi_axes = pair_of_numbers(prm.get("Semi-axes"));
  angle = prm.get_double("Angle") * PI / 180.;
}

void Ellipse2D::check(const std::string &body) const
{
  std::ostringstream value;
  value << "'" << body << "/Semi-axes' = '" << semi_axes[0] << ", " << semi_axes[1] << "' ";
  const double shorter = std::min(semi_axes[0], semi_axes[1]);
  if (!(shorter > 0.))
    throw InputError(value.str() + "leaves the body empty: both must be greater than 0");
  if (std::max(semi_axes[0], semi_axes[1]) > most_slender * shorter)
    throw InputError(value.str() + "is not allowed: one may be at most a hundred times the other");
}

Vector Ellipse2D::to_axes(const Vector &v) const
{
  const double c = std::cos(angle), s = std::sin(angle);
  return Vector({c * v[0] + s * v[1], c * v[1] - s * v[0]});
}

Vector Ellipse2D::from_axes(const Vector &v) const
{
  const double c = std::cos(angle), s = std::sin(angle);
  return Vector({c * v[0] - s * v[1], s * v[0] + c * v[1]});
}

std::vector<double> Ellipse2D::lengths() const
{
  // Midpoints are exact to rounding on a closed curve as smooth as this one.
  constexpr unsigned int n = 4096;
  std::vector<double> length(n + 1, 0.);
  const double step = 2. * PI / n;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double t = (i + 0.5) * step;
    length[i + 1] = length[i] + step * std::hypot(semi_axes[0] * std::sin(t), semi_axes[1] * std::cos(t));
  }
  return length;
}

Polygon Ellipse2D::places(const unsigned int n, const std::vector<double> &length) const
{
  Polygon polygon;
  std::size_t i = 0;
  for (unsigned int k = 0; k < n; ++k)
  {
    const double wanted = length.back() * k / n;
    while (i + 2 < length.size() && length[i + 1] <= wanted)
      ++i;
    const double t = 2. * PI / (length.size() - 1) * (i + (wanted - length[i]) / (length[i + 1] - length[i]));
    polygon.push_back(center + from_axes(Vector({semi_axes[0] * std::cos(t), semi_axes[1] * std::sin(t)})));
  }
  return polygon;
}

std::vector<Polygon> Ellipse2D::outline(const double spacing) const
{
  const std::vector<double> length = lengths();
  // Whole quarters, as of circle(): the mirror image of the places is that of the mirrored ellipse.
  return {places(4 * std::max(3, static_cast<int>(std::ceil(0.25 * std::min(length.back() / spacing, 1e8)))),
                 length)};
}

Polygon Ellipse2D::corners() const
{
  return places(256, lengths());
}

Shape<2>::Place Ellipse2D::nearest(const Place &p) const
{
  const Vector local = to_axes(p - center);
  const bool lies = semi_axes[0] >= semi_axes[1];
  const double x = std::abs(local[lies ? 0 : 1]), y = std::abs(local[lies ? 1 : 0]);
  const Vector quarter =
      foot_in_quarter(std::max(semi_axes[0], semi_axes[1]), std::min(semi_axes[0], semi_axes[1]), x, y);
  return center + from_axes(Vector({std::copysign(quarter[lies ? 0 : 1], local[0]),
                                    std::copysign(quarter[lies ? 1 : 0], local[1])}));
}

Shape<2>::Place Ellipse2D::project(const Place &on_edge, const Place &) const
{
  return nearest(on_edge);
}

double Ellipse2D::area() const
{
  return PI * semi_axes[0] * semi_axes[1];
}

std::pair<double, double> Ellipse2D::distances_from_plane(const Place &point, const Vector &normal) const
{
  const double distance = (center - point) * normal;
  const Vector n = to_axes(normal);
  const double reach = std::hypot(semi_axes[0] * n[0], semi_axes[1] * n[1]);
  return {distance - reach, distance + reach};
}

double Ellipse2D::depth(const Place &p) const
{
  const Vector local = to_axes(p - center);
  const double inside = std::hypot(local[0] / semi_axes[0], local[1] / semi_axes[1]);
  return (inside <= 1. ? 1. : -1.) * p.distance(nearest(p));
}

void Ellipse2D::describe(std::ostream &out, const Place &) const
{
  out << "ellipse " << semi_axes[0] << ' ' << semi_axes[1] << ' ' << angle << ';';
}

std::vector<double> Ellipse2D::numbers() const
{
  return {center[0], center[1], semi_axes[0], semi_axes[1], angle};
}

namespace
{
[[maybe_unused]] const bool registered = Registry<Shape<2>>::instance().add(
    "ellipse", "Center, Semi-axes, Angle", [] { return std::make_unique<Ellipse2D>(); });
} // namespace
} // namespace softgrain
