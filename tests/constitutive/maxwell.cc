// SPDX-License-Identifier: LGPL-2.1-or-later
// Relaxation of a generalised Maxwell solid, E_inf + sum E_i exp(-t/tau_i), in tension and in a large shear
// that turns; stress at a steady rate; energy; and the properties of every law with two branches.
#include "law_point.h"
#include "law_properties.h"

#include <iomanip>

int main()
{
  using namespace softgrain;
  using namespace softgrain::test;
  std::cout << std::setprecision(9);
  const double E = 1e6, nu = 0.3, share[] = {0.5, 0.3}, tau[] = {0.1, 2.};
  const Settings settings = {{"Young's modulus", "1e6"},
                             {"Poisson's ratio", "0.3"},
                             {"Shares", "0.5, 0.3"},
                             {"Relaxation times", "0.1, 2"}};
  const auto relaxed = [&](const double t)
  { return 0.2 + share[0] * std::exp(-t / tau[0]) + share[1] * std::exp(-t / tau[1]); };

  // Pulled at once, then held.
  LawPoint<3> held("maxwell", settings);
  const double strain = 0.4;
  Tensor<2, 3> F;
  F[0][0] = std::exp(strain);
  F[1][1] = F[2][2] = std::exp(-nu * strain);
  held.go_to(F);
  const double stored = held.last.energy;
  for (const double dt : {0.01, 0.05, 0.3, 1., 5.})
  {
    held.go_to(F, dt);
    std::cout << "pulled and held for " << held.time
              << " s, stress / expected: " << held.last.stress[0][0] / (E * strain * relaxed(held.time))
              << '\n';
  }
  std::cout << "dissipated / fall of the energy: " << held.dissipated / (stored - held.last.energy) << '\n';

  // Sheared at once, then held while it turns.
  LawPoint<2> turned("maxwell", settings);
  Tensor<2, 2> shear = dealii::unit_symmetric_tensor<2>();
  shear[0][1] = 1.5;
  turned.go_to(shear);
  const double at_once = turned.last.stress.norm();
  for (unsigned int i = 1; i <= 10; ++i)
  {
    Tensor<2, 2> Q;
    Q[0][0] = Q[1][1] = std::cos(0.2 * i);
    Q[1][0] = std::sin(0.2 * i);
    Q[0][1] = -Q[1][0];
    turned.go_to(Q * shear, 0.07);
  }
  std::cout << "sheared by 1.5, held and turned, stress / expected: "
            << turned.last.stress.norm() / (at_once * relaxed(turned.time)) << '\n';

  // Pulled at a steady rate, in steps of any length.
  LawPoint<3> steady("maxwell", settings);
  const double rate = 0.05;
  for (const double dt : {0.1, 0.4, 0.01, 1.5})
  {
    const double e = rate * (steady.time + dt);
    F[0][0] = std::exp(e);
    F[1][1] = F[2][2] = std::exp(-nu * e);
    steady.go_to(F, dt);
  }
  double expected = 0.2 * steady.time;
  for (unsigned int k = 0; k < 2; ++k)
    expected += share[k] * tau[k] * (1 - std::exp(-steady.time / tau[k]));
  std::cout << "pulled at a steady rate, stress / expected: "
            << steady.last.stress[0][0] / (E * rate * expected) << '\n';
  LawPoint<3> fine("maxwell", settings);
  for (unsigned int i = 1; i <= 2000; ++i)
  {
    F[0][0] = std::exp(1e-4 * i);
    F[1][1] = F[2][2] = std::exp(-nu * 1e-4 * i);
    fine.go_to(F, 1e-3);
  }
  std::cout << "work is energy and what is dissipated, to 1 %: "
            << (std::abs((fine.last.energy + fine.dissipated) / fine.work - 1) < 0.01 ? "yes" : "no") << '\n';

  const auto plane = make_law<2>("maxwell", settings);
  const auto space = make_law<3>("maxwell", settings);
  const bool holds = LawProperties<2>(*plane).check() && LawProperties<3>(*space).check() &&
                     check_plane_strain(*plane, *space);
  std::cout << "two branches hold every property: " << (holds ? "yes" : "no") << '\n';
}
