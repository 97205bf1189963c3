// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_hencky_h
#define softgrain_constitutive_hencky_h

#include <softgrain/constitutive/elastic_law.h>

namespace softgrain::constitutive
{
/**
 * @brief Hencky solid: the energy of linear elasticity with logarithmic strain.
 *
 * With eps_a = ln(lambda_a) the logarithms of the principal stretches, n_a their directions in space, and
 * b_a = lambda_a^2 (plane strain in 2D: lambda_3 = 1):
 *
 *   psi   = mu sum_a eps_a^2 + lambda/2 (ln J)^2,
 *   tau_a = 2 mu eps_a + lambda ln J,
 *   c     = sum_ab (d tau_a / d eps_b - 2 tau_a delta_ab) n_a n_a n_b n_b
 *           + sum_{a<b} g_ab (n_a n_b + n_b n_a) x (n_a n_b + n_b n_a),
 *   g_ab  = (tau_a b_b - tau_b b_a) / (b_a - b_b),
 *
 * de Souza Neto, Peric and Owen, Computational Methods for Plasticity, appendix A. Volume and shape are
 * uncoupled, and the answer to tension and compression is symmetric in the logarithm. A stretch beyond about
 * e softens (the energy is not polyconvex).
 */
template <int dim>
class Hencky final : public ElasticLaw<dim>
{
public:
  std::string title() const override { return "Hencky"; }
  std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const override;
};
} // namespace softgrain::constitutive

#endif
