// SPDX-License-Identifier: LGPL-2.1-or-later
// Areas of aggregates that plane geometry gives, and outlines of random debris that must not cross
// themselves.
#include <softgrain/geometry/aggregate_outline.h>

#include <cmath>
#include <iostream>
#include <random>

using namespace softgrain;
using Point = dealii::Point<2>;
using Rings = std::vector<std::vector<Point>>;

namespace
{
double cross(const Point &a, const Point &b, const Point &c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double area(const Rings &rings)
{
  double twice = 0;
  for (const auto &ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      twice += cross(Point(), ring[i], ring[(i + 1) % ring.size()]);
  return twice / 2;
}

/// Area that a chain of @p n disks of radius r, at distance d, has outside the closed polygon of its centres
/// that turns by @p turn altogether, where a probe of radius p rolls along it.
double rim(const unsigned int n, const double r, const double d, const double p, const double turn)
{
  const double h = std::sqrt((r + p) * (r + p) - d * d / 4), beta = std::acos(d / 2 / (r + p));
  double probe = p * p * std::asin(d / 2 / (r + p)); // its sector inside the triangle of both disks and it
  if (h < p)
    probe -= p * p * std::acos(h / p) - h * std::sqrt(p * p - h * h);
  return n * (d * h / 2 - probe) + r * r / 2 * (n * (M_PI - 2 * beta) + turn);
}

std::vector<Point> hexagon(const int side)
{
  std::vector<Point> centers;
  for (int j = -side; j <= side; ++j)
    for (int i = -side; i <= side; ++i)
      if (std::abs(i + j) <= side)
        centers.emplace_back(2. * i + j, std::sqrt(3.) * j);
  return centers;
}

void report(const std::string &what, const Rings &rings, const double exact)
{
  std::cout << what << ": rings " << rings.size() << ", area / exact - 1 " << area(rings) / exact - 1 << '\n';
}

unsigned int n_crossings(const Rings &rings)
{
  std::vector<std::pair<Point, Point>> edges;
  for (const auto &ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  unsigned int n = 0;
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (std::size_t f = 0; f < e; ++f)
    {
      const auto &[a, b] = edges[e];
      const auto &[c, d] = edges[f];
      // A margin, since edges that follow each other touch and a neck of no width lies on itself.
      const auto apart = [](const double s, const double t)
      { return s * t < 0 && std::min(std::abs(s), std::abs(t)) > 1e-6; };
      n += apart(cross(a, b, c), cross(a, b, d)) && apart(cross(c, d, a), cross(c, d, b));
    }
  return n;
}
} // namespace

int main()
{
  report("one disk", aggregate_outline({{3., 4.}}, {2.}, 1.), M_PI * 4);
  report("its double and one inside", aggregate_outline({{3., 4.}, {3., 4.}, {4., 4.}}, {2., 2., 1.}, 1.),
         M_PI * 4);
  std::cout.precision(3);
  report("two that touch", aggregate_outline({{0., 0.}, {2., 0.}}, {1., 1.}, 0.8),
         rim(2, 1, 2, 0.8, 2 * M_PI));
  report("two with a neck", aggregate_outline({{0., 0.}, {0., 3.}}, {1., 1.}, 1.), rim(2, 1, 3, 1, 2 * M_PI));
  report("two with a neck of no width", aggregate_outline({{0., 0.}, {0., 3.7}}, {1., 1.}, 1.),
         rim(2, 1, 3.7, 1, 2 * M_PI));
  report("two fragments", aggregate_outline({{0., 0.}, {1e3, 4.1}}, {1., 0.5}, 1.), M_PI * 1.25);

  // 3 * 8 * 9 + 1 disks; at a probe of radius 1 every edge passes through the centres of others.
  const std::vector<Point> lattice = hexagon(8);
  for (const double p : {0.5, 1., 1.5})
    report("hexagon of " + std::to_string(lattice.size()),
           aggregate_outline(lattice, std::vector<double>(lattice.size(), 1.), p),
           6 * std::sqrt(3.) / 4 * 16 * 16 + rim(48, 1, 2, p, 2 * M_PI));

  std::vector<Point> circle;
  const unsigned int n = 40;
  const double distance = 2 * 20 * std::sin(M_PI / n);
  for (unsigned int i = 0; i < n; ++i)
    circle.emplace_back(20 * std::cos(2 * M_PI * i / n), 20 * std::sin(2 * M_PI * i / n));
  const std::vector<double> radii(n, 1.5);
  const double inside = n * 400 * std::sin(2 * M_PI / n) / 2,
               outer = inside + rim(n, 1.5, distance, 1, 2 * M_PI);
  report("ring, filled", aggregate_outline(circle, radii, 1.), outer);
  report("ring with its hole", aggregate_outline(circle, radii, 1., true),
         outer - inside + rim(n, 1.5, distance, 1, -2 * M_PI));

  // Disks left over from the lattice: any number of fragments; from exact places and from places a little
  // off.
  std::mt19937 random(7);
  for (const double left : {0.9, 0.6, 0.4})
  {
    std::vector<Point> exact, shaken;
    for (const Point &center : lattice)
      if (random() < left * 4294967296.)
      {
        exact.push_back(center);
        shaken.push_back(center + 1e-9 * Point(std::cos(1. * random()), std::sin(1. * random())));
      }
    for (const double p : {0.7, 1., 1.3})
    {
      const Rings a = aggregate_outline(exact, std::vector<double>(exact.size(), 1.), p);
      const Rings b = aggregate_outline(shaken, std::vector<double>(exact.size(), 1.), p);
      std::cout << "debris: crossings " << n_crossings(a) << ' ' << n_crossings(b) << ", largest first "
                << (area({a.front()}) >= area({a.back()}));
      if (p != 1.) // a probe of radius 1 may or may not pass where one disk is missing
        std::cout << ", rings " << a.size() << " = " << b.size() << ", same area "
                  << (std::abs(area(a) / area(b) - 1) < 1e-6);
      std::cout << '\n';
    }
  }
}
