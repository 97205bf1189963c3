// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_power_law_h
#define softgrain_bpm_power_law_h

#include <softgrain/bpm/attraction.h>

namespace softgrain::bpm
{
/**
 * @brief Attraction `F = F0 (1 + δ/a0)^-γ` with the gap δ and a0 the sum of the radii, nothing beyond
 * `δ = cutoff a0`.
 *
 * γ = 7 is the attractive part of Lennard-Jones. Where primaries overlap (δ < 0, an error of the contact
 * solution) the force stays at its maximum F0. The energy is zero at the cutoff.
 */
class PowerLaw final : public Attraction
{
public:
  PowerLaw() = default;
  /// @param largest_force F0 [N/m in 2D], @param exponent γ above 1, @param cutoff in sums of the radii
  PowerLaw(const double largest_force, const double exponent, const double cutoff)
      : largest_force(largest_force), exponent(exponent), cutoff(cutoff)
  {
  }

  /// The entry `Cutoff`, for every law of powers.
  static void declare_cutoff(dealii::ParameterHandler &prm);

  std::string title() const override { return "Power law"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  double range() const override { return 1. + cutoff; }
  double contact_force() const override { return largest_force; }
  void evaluate(
      std::size_t n, const double *distance, const double *sum, double *force, double *energy) const override;

private:
  double largest_force = 0;
  double exponent = 7;
  double cutoff = 1;
};
} // namespace softgrain::bpm

#endif
