// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_power_potential_h
#define softgrain_bpm_power_potential_h

#include <softgrain/bpm/power_law.h>

namespace softgrain::bpm
{
/**
 * @brief Attraction of @cite nguyen2016, eq. (3.1), which is an energy: `U = -F0 a0 (1 + δ/a0)^-γ`, so that
 * the force is `F = γ F0 (1 + δ/a0)^-(γ+1)`, and γ F0 at contact.
 *
 * The stresses that the thesis reports, a plateau of F0/⟨a0⟩ (@cite nguyen2016, eq. (3.32)) and an unloading
 * modulus γ times that of eq. (3.37), are those of this law; with the same expression as a force they are a
 * sixth of it (doc/results/thesis-3.md). Nothing beyond `δ = cutoff a0`.
 */
class PowerPotential final : public Attraction
{
public:
  std::string title() const override { return "Power potential"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  double range() const override { return law.range(); }
  double contact_force() const override { return law.contact_force(); }
  double characteristic_force() const override { return scale; }
  void evaluate(const std::size_t n,
                const double *distance,
                const double *sum,
                double *force,
                double *energy) const override
  {
    law.evaluate(n, distance, sum, force, energy);
  }

private:
  double scale = 0; ///< F0
  PowerLaw law;     ///< its force
};
} // namespace softgrain::bpm

#endif
