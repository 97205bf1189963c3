// SPDX-License-Identifier: LGPL-2.1-or-later
// Norton's creep and Perzyna's flow in tension against closed forms: creep at constant stress, stress at
// constant rate, relaxation; what is dissipated; the limits of rates; a shorter step that is asked for; and
// the properties of every law.
#include "law_point.h"
#include "law_properties.h"

#include <iomanip>

int main()
{
  using namespace softgrain;
  using namespace softgrain::test;
  std::cout << std::setprecision(9);
  const double E = 1e9, K = 2e6, n = 3, a = 0.5;
  Settings norton = {{"Young's modulus", "1e9"}, {"Poisson's ratio", "0.3"}, {"Yield stress", "0"},
                     {"Saturation stress", "0"}, {"Drag stress", "2e6"},     {"Exponent", "3"},
                     {"Reference rate", "0.5"}};
  const auto alpha = [](const LawPoint<3> &point) { return point.history[point.history.size() - 2]; };

  LawPoint<3> creeps("viscoplastic", norton);
  const double stress = 1e6;
  for (const double dt : {0.1, 0.5, 0.02, 1.})
    creeps.pull(stress, dt);
  std::cout << "creep at constant stress, strain / expected: "
            << alpha(creeps) / (a * std::pow(stress / K, n) * creeps.time) << '\n';

  LawPoint<3> steady("viscoplastic", norton);
  const double rate = 1e-2;
  for (unsigned int i = 1; i <= 100; ++i)
    steady.stretch(rate * 0.02 * i, true, 0.02);
  std::cout << "steady rate, stress / expected: "
            << steady.last.stress[0][0] / (K * std::pow(rate / a, 1 / n)) << '\n';
  const double before = steady.dissipated, alpha_before = alpha(steady);
  for (unsigned int i = 101; i <= 110; ++i)
    steady.stretch(rate * 0.02 * i, true, 0.02);
  std::cout << "there, dissipated / (stress x strain): "
            << (steady.dissipated - before) / (steady.last.stress[0][0] * (alpha(steady) - alpha_before))
            << '\n'
            << "since the start work is energy and what is dissipated, to 1 %: "
            << (std::abs((steady.last.energy + steady.dissipated) / steady.work - 1) < 0.01 ? "yes" : "no")
            << '\n';

  // sigma^(1-n) = sigma_0^(1-n) + (n-1) E a K^-n t
  LawPoint<3> held("viscoplastic", norton);
  held.stretch(2e-3, true);
  const double at_once = held.last.stress[0][0];
  for (unsigned int i = 0; i < 2000; ++i)
    held.stretch(2e-3, true, 1e-5);
  const double expected =
      std::pow(std::pow(at_once, 1 - n) + (n - 1) * E * a * std::pow(K, -n) * held.time, 1 / (1 - n));
  std::cout << "held for 0.02 s, stress / that at once: " << held.last.stress[0][0] / at_once
            << "; within 1 % of the closed form: "
            << (std::abs(held.last.stress[0][0] / expected - 1) < 0.01 ? "yes" : "no") << '\n';

  Settings perzyna = norton;
  perzyna[2].second = perzyna[3].second = "1.5e6";
  perzyna.emplace_back("Hardening modulus", "1e7");
  LawPoint<3> flows("viscoplastic", perzyna);
  for (unsigned int i = 1; i <= 200; ++i)
    flows.stretch(rate * 0.02 * i, true, 0.02);
  // The stress rises by the hardening, which takes a little of the rate for elastic strain.
  const double plastic_rate = rate / (1 + 1e7 / E);
  std::cout << "Perzyna with hardening, stress / expected: "
            << flows.last.stress[0][0] / (1.5e6 + 1e7 * alpha(flows) + K * std::pow(plastic_rate / a, 1 / n))
            << '\n';

  // Little drag is none.
  Settings quick = perzyna;
  quick[4].second = "1";
  LawPoint<3> slow("viscoplastic", quick), plain("j2_plastic", Settings(quick.begin(), quick.begin() + 4));
  plain.law = make_law<3>("j2_plastic", {quick[0], quick[1], quick[2], quick[3], quick[7]});
  for (unsigned int i = 1; i <= 20; ++i)
  {
    slow.stretch(1e-3 * i, true, 1.);
    plain.stretch(1e-3 * i, true);
  }
  std::cout << "little drag, stress / that of j2_plastic, to 1e-6: "
            << (std::abs(slow.last.stress[0][0] / plain.last.stress[0][0] - 1) < 1e-6 ? "yes" : "no") << '\n';

  // A step that flows by more than is allowed asks for a shorter one; half of it does not.
  const auto law = make_law<2>("viscoplastic", norton);
  const std::vector<double> history = initial_history(*law), none;
  for (const double e : {0.1, 0.04})
  {
    Tensor<2, 2> F = dealii::unit_symmetric_tensor<2>();
    F[0][0] = std::exp(e);
    F[1][1] = std::exp(-e);
    double share = 1;
    Outputs<2> out;
    out.step_share = &share;
    law->update({1, &F, nullptr, history.data(), 10., 10.}, out);
    // Almost all strain has flown: 2/sqrt(3) e.
    std::cout << "strain " << e << " in a step, share x increment within 1 % of the limit: "
              << (share == 1.                                                 ? "no wish"
                  : std::abs(share * 2 / std::sqrt(3.) * e / 0.05 - 1) < 0.01 ? "yes"
                                                                              : "no")
              << '\n';
  }

  bool holds = true;
  for (const char *exponent : {"1", "3", "20"})
  {
    Settings settings = {{"Young's modulus", "1e9"}, {"Poisson's ratio", "0.3"},
                         {"Yield stress", "1e8"},    {"Saturation stress", "4e8"},
                         {"Saturation rate", "3"},   {"Kinematic modulus", "2e8"},
                         {"Drag stress", "1e8"},     {"Exponent", exponent}};
    const auto plane = make_law<2>("viscoplastic", settings);
    const auto space = make_law<3>("viscoplastic", settings);
    holds = LawProperties<2>(*plane).check() && holds;
    holds = LawProperties<3>(*space).check() && holds;
    holds = check_plane_strain(*plane, *space) && holds;
  }
  std::cout << "exponents 1, 3 and 20 hold every property: " << (holds ? "yes" : "no") << '\n';
}
