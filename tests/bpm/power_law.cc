// SPDX-License-Identifier: LGPL-2.1-or-later
// The attraction (3.1), as a force and as a potential: its values, its energy as the integral of the force,
// any exponent, and overlaps.
#include <softgrain/bpm/power_law.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <iostream>

using namespace softgrain;

namespace
{
void look(const std::string &name, const std::string &exponent, const std::string &cutoff)
{
  const bool potential = name == "power_potential";
  const auto law = Registry<bpm::Attraction>::instance().create(name);
  dealii::ParameterHandler prm;
  law->declare_parameters(prm);
  prm.set(potential ? "Characteristic force" : "Force at contact", "100");
  prm.set("Exponent", exponent);
  prm.set("Cutoff", cutoff);
  law->parse_parameters(prm);

  const double a0 = 2e-4, gamma = std::stod(exponent), h = 1e-11;
  double worst_force = 0., worst_energy = 0.;
  for (double stretch = 0.96; stretch < law->range() - 1e-3; stretch += 0.0137)
  {
    double d[3] = {stretch * a0 - h, stretch * a0, stretch * a0 + h}, sum[3] = {a0, a0, a0}, F[3], U[3];
    law->evaluate(3, d, sum, F, U);
    const double delta = d[1] - a0, open = 1. + std::max(0., delta) / a0,
                 expected =
                     potential ? 100. * gamma * std::pow(open, -gamma - 1.) : 100. * std::pow(open, -gamma);
    worst_force = std::max(worst_force, std::abs(F[1] / expected - 1.));
    worst_energy = std::max(worst_energy, std::abs((U[2] - U[0]) / (2. * h) / F[1] - 1.));
  }
  double at_end, force_at_end;
  const double end = law->range() * a0;
  law->evaluate(1, &end, &a0, &force_at_end, &at_end);
  std::cout << name << ", p_I a0 = " << law->characteristic_force() << " N/m, exponent " << exponent
            << ", cutoff " << cutoff << ": force " << (worst_force < 1e-13 ? "as (3.1)" : "WRONG")
            << ", slope of the energy " << (worst_energy < 1e-5 ? "is the force" : "WRONG")
            << ", energy at the end " << (std::abs(at_end) < 1e-15 ? 0. : at_end) << '\n';
}
} // namespace

int main()
{
  for (const std::string name : {"power_law", "power_potential"})
  {
    look(name, "7", "1");
    look(name, "2", "1");
    look(name, "12", "0.3");
    look(name, "6.5", "2");
  }
}
