// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/bpm/power_potential.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain::bpm
{
namespace
{
[[maybe_unused]] const bool registered =
    Registry<Attraction>::instance().add("power_potential",
                                         "energy -F0 a0 (1 + gap/a0)^-exponent up to a cutoff: (3.1) of "
                                         "Nguyen (2016).",
                                         [] { return std::make_unique<PowerPotential>(); });
} // namespace

void PowerPotential::declare_parameters(dealii::ParameterHandler &prm) const
{
  using dealii::Patterns::Double;
  prm.declare_entry("Characteristic force", "100", Double(0.),
                    "F0: the energy at contact is -F0 a0, the force at contact F0 times the exponent; in "
                    "space in N. Units: N/m.");
  prm.declare_entry("Exponent", "7", Double(0.01, 99.), "Exponent gamma of the potential. Units: none.");
  PowerLaw::declare_cutoff(prm);
}

void PowerPotential::parse_parameters(dealii::ParameterHandler &prm)
{
  scale = prm.get_double("Characteristic force");
  const double exponent = prm.get_double("Exponent");
  law = PowerLaw(exponent * scale, exponent + 1., prm.get_double("Cutoff"));
}
} // namespace softgrain::bpm
