// SPDX-License-Identifier: LGPL-2.1-or-later
// Plasticity against known answers: a block between smooth plates in plane strain, hardening in uniaxial
// tension, dissipation and work, a rotation in the middle of the history, and the properties of every law
// with hardening of all kinds.
#include "law_point.h"
#include "law_properties.h"

#include <iomanip>

namespace
{
using namespace softgrain;
using namespace softgrain::test;

template <int dim>
struct Point : LawPoint<dim>
{
  explicit Point(const Settings &settings) : LawPoint<dim>("j2_plastic", settings) {}
};

template <int dim>
double equivalent_plastic_strain(const Point<dim> &point)
{
  return point.history.back();
}

const Settings metal = {{"Young's modulus", "1e9"},
                        {"Poisson's ratio", "0.3"},
                        {"Yield stress", "2e6"},
                        {"Saturation stress", "3e6"}};

Settings with(const Settings &more)
{
  Settings all = metal;
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// Largest change of stress, in S_y, of random points that rest or turn after a last step of size @p step.
double change_at_rest(const Settings &more, const double step)
{
  const Tensor<2, 3> I = dealii::unit_symmetric_tensor<3>();
  const auto law = make_law<3>("j2_plastic", with(more));
  RandomNumbers random;
  double worst = 0;
  for (unsigned int n = 0; n < 20; ++n)
  {
    const Tensor<2, 3> F = I + random.tensor<3>(0.3), G = (I + random.tensor<3>(step)) * F,
                       Q = random.rotation<3>();
    const Response<3> first = evaluate(*law, {F, {}, initial_history(*law)});
    const Response<3> second = evaluate(*law, {G, {}, first.history});
    const Response<3> rests = evaluate(*law, {G, {}, second.history});
    const Response<3> turned = evaluate(*law, {Q * G, {}, second.history});
    const Tensor<2, 3> expected = Q * Tensor<2, 3>(rests.stress) * dealii::transpose(Q);
    worst = std::max({worst, (rests.stress - second.stress).norm() / 2e6, rests.dissipation / 2e6,
                      (Tensor<2, 3>(turned.stress) - expected).norm() / 2e6});
  }
  return worst;
}
} // namespace

int main()
{
  std::cout << std::setprecision(10);
  // Smooth plates, free sides: the elastic part of the stretch out of plane dies out, sigma_xx -> 2 S_y /
  // sqrt(3).
  Point<2> block(metal);
  for (unsigned int i = 1; i <= 200; ++i)
    block.stretch(-1e-3 * i, true);
  std::cout << "block between smooth plates, stress / S_y: " << -block.last.stress[0][0] / 2e6 << '\n'
            << "dissipated is the work less the energy, to 1e-4: "
            << (std::abs(block.dissipated / (block.work - block.last.energy) - 1) < 1e-4 ? "yes" : "no")
            << '\n'
            << "dissipated / (S_y alpha): " << block.dissipated / (2e6 * equivalent_plastic_strain(block))
            << '\n';

  // Uniaxial tension: the Kirchhoff stress is the yield stress at the plastic strain reached.
  Point<3> linear(with({{"Hardening modulus", "1e7"}}));
  Point<3> voce(with({{"Saturation rate", "20"}}));
  Point<3> kinematic(with({{"Kinematic modulus", "1e7"}}));
  for (unsigned int i = 1; i <= 20; ++i)
    for (auto *point : {&linear, &voce, &kinematic})
      point->stretch(5e-3 * i, true);
  const double a = equivalent_plastic_strain(linear), b = equivalent_plastic_strain(voce),
               c = equivalent_plastic_strain(kinematic);
  std::cout << "linear hardening, stress / expected: " << linear.last.stress[0][0] / (2e6 + 1e7 * a) << '\n'
            << "Voce hardening, stress / expected: "
            << voce.last.stress[0][0] / (3e6 - 1e6 * std::exp(-20 * b)) << '\n'
            << "kinematic hardening, stress / expected: " << kinematic.last.stress[0][0] / (2e6 + 1e7 * c)
            << '\n'
            << "of it is dissipated, in S_y alpha: " << kinematic.dissipated / (2e6 * c) << '\n';

  // Back: kinematic hardening leaves the elastic range 2 S_y wide.
  const double tip = kinematic.last.stress[0][0], reached = 0.1;
  kinematic.stretch(reached - 1.99 * 2e6 / 1e9, true);
  std::cout << "unloaded by 1.99 S_y, flows again: " << (kinematic.last.dissipation > 0 ? "yes" : "no")
            << '\n';
  kinematic.stretch(reached - 2.01 * 2e6 / 1e9, true);
  std::cout << "unloaded by 2.01 S_y, flows again: " << (kinematic.last.dissipation > 0 ? "yes" : "no")
            << '\n'
            << "stress has fallen by, in S_y: " << (tip - kinematic.last.stress[0][0]) / 2e6 << '\n';

  // A point that rests keeps its stress and one that turns turns it. With kinematic hardening the stress of a
  // step is the derivative of its potential, which differs from that of a rest by the square of the step.
  std::cout << "a point that rests or turns keeps its state: "
            << (change_at_rest({{"Hardening modulus", "1e7"}, {"Saturation rate", "20"}}, 0.3) < 1e-6 ? "yes"
                                                                                                      : "no")
            << '\n'
            << "with kinematic hardening after a step of 1e-3, to 1e-5: "
            << (change_at_rest({{"Kinematic modulus", "1e7"}}, 1e-3) < 1e-5 ? "yes" : "no") << '\n';

  bool holds = true;
  for (const Settings &kind : {Settings{{"Hardening modulus", "3e8"}},
                               Settings{{"Saturation rate", "5"}, {"Saturation stress", "4e8"}},
                               Settings{{"Kinematic modulus", "3e8"}},
                               Settings{{"Hardening modulus", "1e8"},
                                        {"Saturation rate", "3"},
                                        {"Saturation stress", "4e8"},
                                        {"Kinematic modulus", "2e8"}}})
  {
    Settings settings = {{"Young's modulus", "1e9"}, {"Poisson's ratio", "0.3"}, {"Yield stress", "1e8"}};
    settings.insert(settings.end(), kind.begin(), kind.end());
    const auto plane = make_law<2>("j2_plastic", settings);
    const auto space = make_law<3>("j2_plastic", settings);
    holds = LawProperties<2>(*plane).check() && holds;
    holds = LawProperties<3>(*space).check() && holds;
    holds = check_plane_strain(*plane, *space) && holds;
  }
  std::cout << "every kind of hardening holds every property: " << (holds ? "yes" : "no") << '\n';
}
