// SPDX-License-Identifier: LGPL-2.1-or-later
// A neo-Hookean ball, three cells in radius, between two plates without friction, against axisymmetric finite
// elements (1200 quadratic elements), on three cuts of the grid: within 2 % from a travel of a fifth of the
// radius on, and within 9 % at a tenth, where the contact is a cell wide. Newton's method converges
// quadratically: three or four iterations a step. Both plates feel the same. Work that the plates do is
// stored in the ball, by the trapezoidal rule, but for the first touch.
#include "ball.h"

#include <softgrain/mpm/stepping/pressed_body.h>
#include <softgrain/mpm/stepping/stress.h>

#include <cmath>
#include <iostream>
#include <map>

using namespace softgrain;

namespace
{
/// F/(E R²) over the travel of each plate over R, for a Poisson's ratio of .45.
const std::map<double, double> elements = {{.1, .061156}, {.2, .191906}, {.3, .399657}, {.4, .725853}};

constexpr double radius = 2., cell = radius / 3., poisson_ratio = 0.45;

mpm::PressedBody<3>::FlatWall plate(const Ball &ball, const double approach, const double side)
{
  mpm::PressedBody<3>::FlatWall wall;
  wall.point = ball.sphere.center;
  wall.point[2] += side * radius * (1. - approach);
  wall.normal[2] = -side;
  wall.dent = mpm::HertzDent(1. / (1. - poisson_ratio * poisson_ratio), radius, cell);
  return wall;
}

void press(const double cut)
{
  const mpm::Settings settings;
  Ball ball(radius, cell, "neo_hookean", poisson_ratio, cut * cell);
  mpm::PressedBody<3> pressed(ball.body, ball.places, settings, cell);
  unsigned int most_iterations = 0;
  double worst = 0., difference = 0., work = 0., before = 0., residual = 0.;
  constexpr unsigned int n_steps = 40;
  for (unsigned int n = 1; n <= n_steps; ++n)
  {
    const double approach = 0.4 * n / n_steps;
    const auto outcome = pressed.balance({plate(ball, approach, -1.), plate(ball, approach, 1.)});
    if (!outcome.trouble.empty())
      std::cout << outcome.trouble << '\n';
    const double force = pressed.total_force(0);
    work += (before + force) * radius * 0.4 / n_steps;
    before = force;
    most_iterations = std::max(most_iterations, outcome.iterations);
    residual = std::max(residual, outcome.residual);
    difference = std::max(difference, std::abs(pressed.total_force(1) / force - 1.));
    for (const auto &[at, of_elements] : elements)
      if (std::abs(at - approach) < 1e-9)
        worst = std::max(worst,
                         std::abs(force / (radius * radius) / of_elements - 1.) / (at < 0.15 ? 0.09 : 0.02));
  }
  const double energy =
      measure_points(ball.body, ball.body.displacement, Eigen::VectorXd::Zero(ball.body.displacement.size()))
          .energy;
  std::cout << "cut " << cut << ": forces near enough: " << (worst < 1.)
            << ", no more than 5 iterations: " << (most_iterations <= 5)
            << ", residual small: " << (residual < 1e-5) << ", plates alike: " << (difference < 1e-4)
            << ", work is energy within 1 %: " << (std::abs(energy / work - 1.) < 0.01) << '\n';
}
} // namespace

int main()
{
  for (const double cut : {0., 0.3, 0.6})
    press(cut);
}
