// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_maxwell_h
#define softgrain_constitutive_maxwell_h

#include <softgrain/constitutive/elastic_law.h>

namespace softgrain::constitutive
{
/**
 * @brief Generalised Maxwell solid at finite strain: Hencky springs, of which some stand behind dashpots.
 *
 * A share g_0 of the modulus is Hencky's in F; the share g_k is Hencky's in the elastic part of F = Fe_k
 * Fv_k, whose logarithmic strain E_k relaxes in the time tau_k, all parts of it alike, so that Poisson's
 * ratio stays. Young's modulus is that at once; under a constant strain it falls as
 *
 *   E(t) / E = g_0 + sum_k g_k exp(-t / tau_k),   g_0 = 1 - sum_k g_k.
 *
 * In a step E_k runs from E_k_old to the trial strain E of F Fv_k_old^-1 at a steady rate and relaxes on the
 * way, E_k = r E_k_old + s (E - E_k_old), r = exp(-dt/tau), s = (1 - r) tau/dt: exact along fixed axes, of
 * second order else. Multiplicative split as in Reese and Govindjee, International Journal of Solids and
 * Structures 35 (1998). The stress has a potential in E, so that the tangent is symmetric.
 */
template <int dim>
class Maxwell final : public ElasticLaw<dim>
{
public:
  std::string title() const override { return "Maxwell"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  /// Number of values: Fv^-1 for every branch, then E_k; in 2D nothing flows out of the plane.
  unsigned int n_history() const override { return times.size() * n_of_branch; }
  void initial_history(double *history) const override;
  std::vector<std::string> history_names() const override;
  std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const override;

private:
  static constexpr unsigned int n_of_branch = dim * dim + (dim == 2 ? 3 : 6);

  std::vector<double> shares{0.5}, times{1.};
};
} // namespace softgrain::constitutive

#endif
