// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_neo_hookean_h
#define softgrain_constitutive_neo_hookean_h

#include <softgrain/constitutive/elastic_law.h>

namespace softgrain::constitutive
{
/**
 * @brief Compressible neo-Hookean solid, for rubber-like grains at any strain.
 *
 * Energy per reference volume, with J = det F, b = F F^T and I1 = tr b (plane strain in 2D: b_zz = 1):
 *
 *   psi = mu/2 (I1 - 3 - 2 ln J) + lambda/2 (ln J)^2,
 *   tau = mu (b - I) + lambda ln J I,
 *   c   = lambda I x I + 2 (mu - lambda ln J) II_s,
 *
 * Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element Analysis, 2nd ed., section 6.4.3.
 * psi grows without bound as J tends to 0 or infinity. Where ln J > mu / lambda the shear part of c is
 * negative, and only the geometric part of the stiffness holds a shear.
 */
template <int dim>
class NeoHookean final : public ElasticLaw<dim>
{
public:
  std::string title() const override { return "Neo-Hookean"; }
  std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const override;
};
} // namespace softgrain::constitutive

#endif
