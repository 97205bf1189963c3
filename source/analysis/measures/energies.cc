// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>

namespace softgrain
{
namespace
{
/// Energies of the scene, and the part of the kinetic one that is in the translation of whole bodies.
template <int dim>
class EnergyTerms final : public MeasureIn<dim>
{
public:
  std::vector<std::string> columns() const override
  {
    const std::string unit = dim == 2 ? "_J_per_m" : "_J";
    return {"kinetic_energy" + unit, "kinetic_energy_of_translation" + unit, "elastic_energy" + unit,
            "dissipated_energy" + unit, "external_work" + unit};
  }

  std::vector<MeasuredValue> evaluate(const AssemblyIn<dim> &assembly) const override
  {
    const Energies &energies = assembly.snapshot.energies;
    double translation = 0.;
    for (const BodyState<dim> &body : assembly.snapshot.bodies)
      translation += 0.5 * body.mass * body.velocity.norm_square();
    return {energies.kinetic, translation, energies.elastic, energies.dissipated, energies.external_work};
  }
};

constexpr const char *name = "energies",
                     *description = "kinetic, elastic and dissipated energy, work of walls and loads";
[[maybe_unused]] const bool registered = register_measure<EnergyTerms<2>>(name, description),
                            registered_in_space = register_measure<EnergyTerms<3>, 3>(name, description);
} // namespace
} // namespace softgrain
