// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_mooney_rivlin_h
#define softgrain_constitutive_mooney_rivlin_h

#include <softgrain/constitutive/elastic_law.h>

namespace softgrain::constitutive
{
/**
 * @brief Mooney-Rivlin rubber with the volumetric energy of Ciarlet and Geymonat.
 *
 * With b = F F^T, I1 = tr b, I2 = (I1^2 - tr b^2)/2 (plane strain in 2D: b_zz = 1), the share s of the second
 * invariant, C1 = mu (1 - s)/2, C2 = mu s/2 and k = lambda - 4 C2:
 *
 *   psi = C1 (I1 - 3) + C2 (I2 - 3) + k/4 (J^2 - 1) - (lambda/2 + mu) ln J,
 *   tau = 2 C1 b + 2 C2 (I1 b - b^2) + (k/2 (J^2 - 1) - 2 C1 - 4 C2) I,
 *   c   = 4 C2 (b x b - b box b) + k J^2 I x I - 2 (k/2 (J^2 - 1) - 2 C1 - 4 C2) II_s,
 *
 * (b box b) d = b d b; @cite ciarlet1988, section 4.10. lambda and mu are those at rest. The energy is
 * polyconvex where 4 C2 <= lambda. In plane strain I2 = I1 - 1 + J^2, so that the stress in the plane
 * does not depend on s: only the stress out of plane does.
 */
template <int dim>
class MooneyRivlin final : public ElasticLaw<dim>
{
public:
  std::string title() const override { return "Mooney-Rivlin"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const override;

private:
  double share = 0.2;
};
} // namespace softgrain::constitutive

#endif
