// SPDX-License-Identifier: LGPL-2.1-or-later
// Growth: a free body grows without stress, a confined one is under the pressure of the closed form, in the
// plane and along a direction; the energy that growth brings in: none where it is free, all that is stored
// where nothing moves, and of second order in the step where a body is pulled as it grows; a shorter step.
#include <deal.II/base/numbers.h>

#include "law_point.h"
#include "law_properties.h"

#include <iomanip>

using namespace softgrain;
using namespace softgrain::test;

namespace
{
/// Energy less work and what growth brought in, over the energy, of a body that is pulled as it grows.
double not_booked(const Settings &settings, const unsigned int n_steps)
{
  LawPoint<2> point("growth", settings);
  for (unsigned int i = 1; i <= n_steps; ++i)
  {
    const double t = 1. * i / n_steps;
    Tensor<2, 2> F = dealii::unit_symmetric_tensor<2>();
    F[0][0] += 0.4 * t * t;
    F[1][1] -= 0.2 * t;
    point.go_to(F, 1. / n_steps);
  }
  return (point.last.energy - point.work - point.supplied) / point.last.energy;
}
} // namespace

int main()
{
  std::cout << std::setprecision(9);
  const double E = 1e5, nu = 0.3, lambda = E * nu / (1 + nu) / (1 - 2 * nu), mu = E / 2 / (1 + nu);
  const Tensor<2, 2> one = dealii::unit_symmetric_tensor<2>();
  for (const std::string along : {"plane", "30"})
  {
    const Settings settings = {
        {"Young's modulus", "1e5"}, {"Poisson's ratio", "0.3"}, {"Rate", "0.4 * t"}, {"Along", along}};
    // d ln J_g / dt = 0.4 t
    const auto grown = [](const double t) { return std::exp(0.2 * t * t); };
    Tensor<1, 2> a;
    a[0] = std::cos(dealii::numbers::PI / 6);
    a[1] = 0.5;
    LawPoint<2> free("growth", settings), confined("growth", settings);
    for (const double dt : {0.1, 0.5, 0.4, 1.})
    {
      const double g = grown(free.time + dt);
      free.go_to(along == "plane" ? std::sqrt(g) * one : one + (g - 1) * dealii::outer_product(a, a), dt);
      confined.go_to(one, dt);
    }
    const double g = grown(2.);
    std::cout << along << ": J_g / expected: " << free.history[0] / g << '\n'
              << "  free, stress in the plane and out of it below 1e-12 E: "
              << (free.last.stress.norm() + std::abs(free.last.out_of_plane_stress) < 1e-12 * E ? "yes"
                                                                                                : "no")
              << '\n';
    // b_e = 1/J_g in the plane, or 1/J_g^2 along a.
    const double b = along == "plane" ? 1 / g : 1 / (g * g);
    const double normal = g * (mu * (b - 1) - lambda * std::log(g)), zz = -g * lambda * std::log(g);
    const double across = along == "plane" ? normal : zz;
    Tensor<1, 2> c;
    c[0] = -a[1];
    c[1] = a[0];
    std::cout << "  confined, stress / expected: " << a * confined.last.stress * a / normal << ' '
              << c * confined.last.stress * c / across << ' ' << confined.last.out_of_plane_stress / zz
              << '\n'
              << "  energy brought in / energy: " << confined.supplied / confined.last.energy
              << ", dissipated: " << confined.dissipated << '\n'
              << "  free, energy brought in below 1e-12 of that: "
              << (std::abs(free.supplied) < 1e-12 * confined.supplied ? "yes" : "no") << '\n';
    const double coarse = not_booked(settings, 20), fine = not_booked(settings, 40);
    std::cout << "  pulled, not booked in 40 steps below 1e-3: " << (std::abs(fine) < 1e-3 ? "yes" : "no")
              << ", falls by four when steps are halved: "
              << (std::abs(coarse / fine - 4) < 0.1 ? "yes" : "no") << '\n';

    const auto plane = make_law<2>("growth", settings);
    const auto space = make_law<3>("growth", settings);
    const bool holds = LawProperties<2>(*plane).check() && LawProperties<3>(*space).check() &&
                       check_plane_strain(*plane, *space);
    std::cout << "  every property holds: " << (holds ? "yes" : "no") << '\n';

    const std::vector<double> history = initial_history(*plane);
    double share = 1;
    Outputs<2> out;
    out.step_share = &share;
    plane->update({1, &one, nullptr, history.data(), 2., 2.}, out);
    std::cout << "  share of a step of 2 s that is allowed / expected: " << share / (std::log(1.1) / 0.8)
              << '\n';
  }
}
