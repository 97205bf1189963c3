// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_ogden_h
#define softgrain_constitutive_ogden_h

#include <softgrain/constitutive/elastic_law.h>
#include <softgrain/constitutive/refusal.h>

namespace softgrain::constitutive
{
/**
 * @brief Ogden's rubber: a sum of powers of the principal stretches.
 *
 * With eps_a = ln(lambda_a), n_a their directions in space (plane strain in 2D: lambda_3 = 1), exponents
 * alpha_p and shares s_p of the shear modulus, sum_p s_p = 1:
 *
 *   psi   = sum_p 2 mu s_p / alpha_p^2 (sum_a lambda_a^alpha_p - 3 - alpha_p ln J) + lambda/2 (ln J)^2,
 *   tau_a = sum_p 2 mu s_p / alpha_p (lambda_a^alpha_p - 1) + lambda ln J,
 *
 * @cite ogden1972, eqs. (15) and (24), with mu_p alpha_p = 2 mu s_p; the modulus as in Hencky. Exponents 2
 * and -2 make a Mooney-Rivlin solid, the exponent 2 alone the neo-Hookean one. A deformation whose powers
 * leave the range of numbers (a stretch of 1e-60 with an exponent of -2) is not admissible.
 */
template <int dim>
class Ogden final : public ElasticLaw<dim>, public Refusal<dim>
{
public:
  std::string title() const override { return "Ogden"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  std::string why_refused(const Inputs<dim> &point) const override;
  std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const override;

private:
  std::vector<double> exponents{1.3, 5.};
  /// Shares of the shear modulus, one per exponent, positive, of sum 1.
  std::vector<double> shares{0.99, 0.01};
};
} // namespace softgrain::constitutive

#endif
