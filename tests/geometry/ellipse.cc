// SPDX-License-Identifier: LGPL-2.1-or-later
// An ellipse: area and second moments of its outline are those of the formulas; outlines have edges of one
// length and lie on it; depth and projection agree with a search along the boundary; what it overlaps.
#include <softgrain/geometry/ellipse.h>
#include <softgrain/geometry/shapes_2d.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace softgrain;

namespace
{
const double pi = std::acos(-1.);

std::string below(const double limit, const double value)
{
  return std::abs(value) < limit ? "small" : std::to_string(value);
}

/// Second moments of a polygon about the axes through @p center, x x and y y and x y [m^4].
std::array<double, 3> second_moments(const Polygon &polygon, const dealii::Point<2> &center)
{
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const auto a = polygon[i] - center, b = polygon[(i + 1) % polygon.size()] - center;
    const double cross = a[0] * b[1] - a[1] * b[0];
    sum[0] += cross * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) / 12.;
    sum[1] += cross * (a[1] * a[1] + a[1] * b[1] + b[1] * b[1]) / 12.;
    sum[2] += cross * (2. * a[0] * a[1] + a[0] * b[1] + b[0] * a[1] + 2. * b[0] * b[1]) / 24.;
  }
  return sum;
}

void look(const double a, const double b, const double angle)
{
  const dealii::Point<2> center(0.3, -0.2);
  const Ellipse2D ellipse(center, dealii::Tensor<1, 2>({a, b}), angle);
  const Polygon fine = ellipse.outline(1e-3)[0];
  const auto moments = second_moments(fine, center);
  const double along = pi * a * a * a * b / 4., across = pi * a * b * b * b / 4., c = std::cos(angle),
               s = std::sin(angle);
  std::cout << "axes " << a << ' ' << b << ": area off by "
            << below(1e-5, signed_area(fine) / ellipse.area() - 1.) << ", moments off by "
            << below(1e-5, moments[0] / (along * c * c + across * s * s) - 1.) << ' '
            << below(1e-5, moments[1] / (along * s * s + across * c * c) - 1.) << ' '
            << below(1e-5, moments[2] - (along - across) * s * c);

  const Polygon coarse = ellipse.outline(0.07)[0];
  double shortest = 1e9, longest = 0., off = 0., between = 0.;
  for (std::size_t i = 0; i < coarse.size(); ++i)
  {
    const dealii::Point<2> &p = coarse[i], &q = coarse[(i + 1) % coarse.size()];
    shortest = std::min(shortest, p.distance(q));
    longest = std::max(longest, p.distance(q));
    off = std::max(off, std::abs(ellipse.depth(p)));
    between = std::max(between, std::abs(ellipse.depth(ellipse.project(p + 0.3 * (q - p), p))));
  }
  std::cout << "\n  edges of an outline " << (longest <= 0.07 ? "short" : "TOO LONG")
            << ", the shortest over the longest "
            << (shortest / longest > (std::min(a, b) > 0.3 * std::max(a, b) ? 0.97 : 0.6)
                    ? "as the tips have it"
                    : std::to_string(shortest / longest))
            << ", off the ellipse by " << below(1e-12, off) << ", projected by " << below(1e-12, between)
            << '\n';

  double worst = 0.;
  for (int i = -12; i <= 12; ++i)
    for (int j = -12; j <= 12; ++j)
    {
      const dealii::Point<2> p = center + dealii::Tensor<1, 2>({0.1 * i, 0.1 * j});
      const double expected = (is_inside(p, fine) ? 1. : -1.) * distance_to_boundary(p, fine);
      worst = std::max(worst, std::abs(ellipse.depth(p) - expected));
    }
  const auto box = ellipse.bounding_box();
  double outside = -1e9;
  for (const auto &p : fine)
    for (unsigned int d = 0; d < 2; ++d)
      outside = std::max({outside, p[d] - box.second[d], box.first[d] - p[d]});
  std::cout << "  depth off by " << below(2e-5, worst) << ", box off by " << below(1e-6, outside) << '\n';
}
} // namespace

int main()
{
  look(1., 1., 0.);
  look(1., 0.5, 0.4);
  look(0.4, 1.1, -1.);
  look(1., 0.1, 2.);
  const Ellipse2D lies({0., 0.}, dealii::Tensor<1, 2>({2., 1.}), 0.),
      stands({0., 3.}, dealii::Tensor<1, 2>({2., 1.}), 0.5 * pi);
  std::cout << "overlap: touching from above " << overlap(lies, stands, 1e-3) << ", a little nearer "
            << overlap(lies, Ellipse2D({0., 2.9}, dealii::Tensor<1, 2>({2., 1.}), 0.5 * pi), 1e-3)
            << ", a disk beside " << overlap(lies, Disk2D({3.01, 0.}, 1.), 1e-3)
            << overlap(lies, Disk2D({2.9, 0.}, 1.), 1e-3) << '\n';
}
