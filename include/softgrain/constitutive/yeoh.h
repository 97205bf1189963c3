// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_yeoh_h
#define softgrain_constitutive_yeoh_h

#include <softgrain/constitutive/first_invariant_law.h>

namespace softgrain::constitutive
{
/**
 * @brief Yeoh's rubber: a cubic in I1 - 3, which softens first and stiffens then, as filled rubber does.
 *
 *   shape(x) = x + c2 x^2 + c3 x^3, the energy of FirstInvariantLaw; x = I1 - 3,
 *
 * @cite yeoh1993, eq. (4), with C10 = mu/2, c2 = C20/C10, c3 = C30/C10. shape' > 0 is asked for at every x >=
 * -3, so that the stress never falls with the stretch.
 */
template <int dim>
class Yeoh final : public FirstInvariantLaw<dim>
{
public:
  std::string title() const override { return "Yeoh"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;

protected:
  using typename FirstInvariantLaw<dim>::Shape;
  Shape shape(double x) const override;

private:
  double c2 = -0.01, c3 = 2e-4;
};
} // namespace softgrain::constitutive

#endif
