// SPDX-License-Identifier: LGPL-2.1-or-later
// A gel in a solvent: swollen freely it is without stress and stores nothing, at any chemical potential, by
// the equation of Flory and Rehner; a confined one has the pressure of the closed form, and what swelling
// brings in is what it stores; osmotic and shear moduli; in the plane; what is not booked falls with the
// square of the step where a gel is pulled as it swells; a shorter step; what has no sense is refused.
#include "law_point.h"
#include "law_properties.h"

#include <softgrain/base/exceptions.h>

#include <iomanip>

using namespace softgrain;
using namespace softgrain::test;

namespace
{
const double G = 4e4, q = 1.36e8, chi = 0.4;

Settings gel(const std::string &potential, const std::string &interaction = "0.4")
{
  return {{"Shear modulus", "4e4"},
          {"Mixing pressure", "1.36e8"},
          {"Interaction", interaction},
          {"Chemical potential", potential},
          {"Largest swelling", "0"}};
}

/// Stress of a gel with stretch @p across and swelling J along that stretch, per dry volume.
double dry_stress(const double squared_stretch, const double J, const double m)
{
  return G * (squared_stretch - 1) + q * (J * std::log1p(-1 / J) + 1 + chi / J - m * J);
}

/// The root of a function that rises, by bisection.
template <class Function>
double root(double low, double high, const Function &function)
{
  for (unsigned int i = 0; i < 200; ++i)
  {
    const double middle = std::sqrt(low * high);
    (function(middle) < 0 ? low : high) = middle;
  }
  return low;
}

double free_swelling(const double m)
{
  return root(1.06, 1e4, [m](const double J) { return dry_stress(std::pow(J, 2. / 3.), J, m); });
}

std::string yes(const bool good)
{
  return good ? "yes" : "no";
}

/// Energy less work and what swelling brought in, over the energy, of a gel that is pulled as it swells.
double not_booked(const unsigned int n_steps)
{
  LawPoint<2> point("flory_rehner", gel("-0.004*exp(-t)"));
  double work = 0;
  for (unsigned int i = 1; i <= n_steps; ++i)
  {
    const double t = 1. * i / n_steps, dt = 1. / n_steps;
    Tensor<2, 2> F = dealii::unit_symmetric_tensor<2>(), middle = F;
    const auto stretch = [](const double s) { return std::exp(0.3 * s * s); };
    F[0][0] = stretch(t);
    middle[0][0] = stretch(t - dt / 2);
    // Simpson's rule for the work, whose error is of fourth order too.
    const double before = point.last.stress[0][0], between = point.try_step(middle, dt / 2).stress[0][0];
    const double begin = 0.6 * (t - dt), at_middle = 0.6 * (t - dt / 2), end = 0.6 * t;
    point.go_to(F, dt);
    work += dt / 6 * (before * begin + 4 * between * at_middle + point.last.stress[0][0] * end);
  }
  return (point.last.energy - work - point.supplied) / point.last.energy;
}
} // namespace

int main()
{
  std::cout << std::setprecision(9);
  const Tensor<2, 3> one = dealii::unit_symmetric_tensor<3>();
  const auto potential = [](const double t) { return -0.004 * std::exp(-t); };
  const double J_0 = free_swelling(potential(0));
  LawPoint<3> free("flory_rehner", gel("-0.004*exp(-t)")), confined("flory_rehner", gel("-0.004*exp(-t)"));
  const double shear = G * std::pow(J_0, -1. / 3.), E = free.law->young_modulus();
  double worst = 0, stored = 0;
  for (const double dt : {0.1, 0.5, 0.4, 1., 3.})
  {
    const double J = free_swelling(potential(free.time + dt));
    free.go_to(std::cbrt(J / J_0) * one, dt);
    confined.go_to(one, dt);
    worst = std::max(worst, free.last.stress.norm() / E);
    stored = std::max(stored, std::abs(free.last.energy) / E);
  }
  std::cout << "swollen at rest " << J_0 << ", at the end " << free_swelling(potential(5)) << '\n'
            << "free: stress below 1e-9 E " << yes(worst < 1e-9) << ", stores below 1e-12 E "
            << yes(stored < 1e-12) << '\n'
            << "confined: pressure / expected "
            << -confined.last.stress[0][0] / (q * (potential(5) - potential(0)))
            << ", energy brought in / energy " << confined.supplied / confined.last.energy << '\n';

  // Where a gel is swollen freely its osmotic modulus is that of the closed form.
  const double m = potential(0),
               bulk = (2. / 3. * G * std::pow(J_0, 2. / 3.) +
                       q * (J_0 * std::log1p(-1 / J_0) + 1 / (1 - 1 / J_0) - chi / J_0 - m * J_0)) /
                      J_0;
  const double nu = free.law->poisson_ratio();
  std::cout << "moduli / expected: shear " << E / (2 * (1 + nu)) / shear << ", bulk "
            << E / (3 * (1 - 2 * nu)) / bulk << "; Poisson's ratio " << nu << '\n';

  // In the plane the gel keeps its stretch out of it.
  LawPoint<2> sheet("flory_rehner", gel("-0.004*exp(-t)"));
  const double out_of_plane = std::cbrt(J_0), at_end = potential(2);
  const double wide = root(1., 1e3,
                           [&](const double stretch) {
                             return dry_stress(stretch * stretch, stretch * stretch * out_of_plane, at_end);
                           });
  sheet.go_to(wide / out_of_plane * dealii::unit_symmetric_tensor<2>(), 2.);
  const double normal = dry_stress(out_of_plane * out_of_plane, wide * wide * out_of_plane, at_end) / J_0;
  std::cout << "in the plane: stress below 1e-9 E " << yes(sheet.last.stress.norm() < 1e-9 * E)
            << ", out of it / expected " << sheet.last.out_of_plane_stress / normal << '\n';

  const double coarse = not_booked(32), fine = not_booked(64);
  std::cout << "pulled, not booked in 64 steps below 2e-3 " << yes(std::abs(fine) < 2e-3)
            << ", falls by four when steps are halved " << yes(std::abs(coarse / fine - 4) < 0.05) << "\n";

  for (const auto &settings : {gel("-0.004*exp(-t)"), gel("0"), gel("-0.02", "0.9")})
  {
    const auto plane = make_law<2>("flory_rehner", settings);
    const auto space = make_law<3>("flory_rehner", settings);
    std::cout << "every property holds: "
              << yes(LawProperties<2>(*plane).check() && LawProperties<3>(*space).check() &&
                     check_plane_strain(*plane, *space))
              << '\n';
  }

  // A shorter step, and what is refused.
  Settings careful = gel("-0.004*exp(-t)");
  careful.back().second = "0.1";
  const auto law = make_law<3>("flory_rehner", careful);
  const std::vector<double> history = initial_history(*law);
  double share = 1;
  Outputs<3> out;
  out.step_share = &share;
  law->update({1, &one, nullptr, history.data(), 2., 2.}, out);
  std::cout << "share of a step / expected "
            << share / (std::log(1.1) / std::log(free_swelling(potential(2)) / J_0)) << '\n';
  const auto above = make_law<3>("flory_rehner", gel("0.01*t-0.01"));
  std::cout << "above the pure solvent: good points "
            << above->update({1, &one, nullptr, history.data(), 2., 2.}, {}) << '\n';
  for (const Settings &wrong : {gel("0.1"), gel("1/0")})
    try
    {
      make_law<3>("flory_rehner", wrong);
    }
    catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}
