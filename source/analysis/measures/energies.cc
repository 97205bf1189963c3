// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>

namespace softgrain
{
namespace
{
/// Energies of the scene, and the part of the kinetic one that is in the translation of whole bodies.
class EnergyTerms final : public Measure
{
public:
  std::vector<std::string> columns() const override
  {
    return {"kinetic_energy_J_per_m", "kinetic_energy_of_translation_J_per_m", "elastic_energy_J_per_m",
            "dissipated_energy_J_per_m", "external_work_J_per_m"};
  }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    const Energies &energies = assembly.snapshot.energies;
    double translation = 0.;
    for (const BodyState<2> &body : assembly.snapshot.bodies)
      translation += 0.5 * body.mass * body.velocity.norm_square();
    return {energies.kinetic, translation, energies.elastic, energies.dissipated, energies.external_work};
  }
};

[[maybe_unused]] const bool registered = register_measure<EnergyTerms>(
    "energies", "kinetic, elastic and dissipated energy, work of walls and loads");
} // namespace
} // namespace softgrain
