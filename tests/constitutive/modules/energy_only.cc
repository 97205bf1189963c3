// SPDX-License-Identifier: LGPL-2.1-or-later
// The neo-Hookean law by its energy alone, as doc/add-a-law.md shows it.
#include <softgrain/constitutive/energy_law.h>
#include <softgrain/constitutive/law_registry.h>

template <int dim>
class EnergyOnly final : public softgrain::constitutive::EnergyLaw<dim, EnergyOnly<dim>>
{
public:
  std::string title() const override { return "Energy only"; }
  template <typename Number>
  Number energy(const dealii::Tensor<2, 3, Number> &F, const Number &log_J) const
  {
    return this->mu / 2 * (scalar_product(F, F) - 3 - 2 * log_J) + this->lambda / 2 * log_J * log_J;
  }
};

[[maybe_unused]] const bool energy_only = softgrain::constitutive::register_law<EnergyOnly>(
    "energy_only", "Neo-Hookean by its energy alone, for tests.");
