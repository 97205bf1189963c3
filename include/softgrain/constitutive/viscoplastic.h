// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_viscoplastic_h
#define softgrain_constitutive_viscoplastic_h

#include <softgrain/constitutive/j2_plastic.h>

namespace softgrain::constitutive
{
/**
 * @brief Flow that takes time: Perzyna's law on J2Plastic, and Norton's creep where the yield stress is zero.
 *
 * With the equivalent stress sigma_eq = sqrt(3/2) |xi| and the yield stress sigma_y(alpha) of J2Plastic, the
 * equivalent plastic strain grows as
 *
 *   d alpha / dt = a (max(sigma_eq - sigma_y, 0) / K)^n,
 *
 * Perzyna (1966), Norton (1929), implicit in the step. As n grows and K stays this tends to flow at
 * sigma_y + K. What is dissipated by viscosity, the integral of s d alpha with s = sigma_eq - sigma_y, is
 * dt (n s_1 a_1 + s_0 a_0) / (n + 1) with the rates a_0, a_1 at both ends of the step: its derivative by the
 * deformation is then that of the work.
 */
template <int dim>
class Viscoplastic final : public J2Plastic<dim>
{
public:
  std::string title() const override { return "Viscoplastic"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  /// That of J2Plastic, then the rate of alpha.
  unsigned int n_history() const override { return J2Plastic<dim>::n_history() + 1; }
  std::vector<std::string> history_names() const override;
  bool limits_step() const override { return this->largest_increment > 0; }

protected:
  using typename J2Plastic<dim>::Flow;
  Flow flow(double trial, double alpha_old, double rate_old, double dt) const override;
  void check_yield(dealii::ParameterHandler &) const override {} // creep may start from zero

private:
  double drag = 1e6, exponent = 1, reference_rate = 1;
};
} // namespace softgrain::constitutive

#endif
