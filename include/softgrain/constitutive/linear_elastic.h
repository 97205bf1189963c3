// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_linear_elastic_h
#define softgrain_constitutive_linear_elastic_h

#include <softgrain/constitutive/elastic_law.h>

namespace softgrain::constitutive
{
/**
 * @brief The thesis's law: linear elasticity in accumulated small strain.
 *
 *   sigma = C : eps,   C = lambda I x I + 2 mu II_s,   psi = 1/2 sigma : eps,
 *
 * @cite nguyen2016, eq. (3.5); plane strain in 2D. The history is eps, the sum of the symmetric parts of the
 * increments of all steps. Large rotations are not taken out of it, so a body that turns gets spurious
 * stress: the price of comparing with the thesis. The volume of a point by @cite nguyen2016, eq. (3.17) is
 * the caller's business; the law takes sigma and psi per unit of the volume at hand.
 */
template <int dim>
class LinearElastic final : public ElasticLaw<dim>
{
public:
  std::string title() const override { return "Linear elastic"; }
  Kinematics kinematics() const override { return Kinematics::small_strain; }
  unsigned int n_history() const override
  {
    return dealii::SymmetricTensor<2, dim>::n_independent_components;
  }
  std::vector<std::string> history_names() const override;
  std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const override;
};
} // namespace softgrain::constitutive

#endif
