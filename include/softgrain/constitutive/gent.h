// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_gent_h
#define softgrain_constitutive_gent_h

#include <softgrain/constitutive/first_invariant_law.h>
#include <softgrain/constitutive/refusal.h>

namespace softgrain::constitutive
{
/**
 * @brief Gent's rubber: chains of finite length, which lock at I1 - 3 = J_m.
 *
 *   shape(x) = -J_m ln(1 - x / J_m), the energy of FirstInvariantLaw; x = I1 - 3,
 *
 * @cite gent1996, eq. (3). The stress grows without bound as x
 * tends to J_m; a deformation beyond is not admissible.
 */
template <int dim>
class Gent final : public FirstInvariantLaw<dim>, public Refusal<dim>
{
public:
  std::string title() const override { return "Gent"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  std::string why_refused(const Inputs<dim> &point) const override;

protected:
  using typename FirstInvariantLaw<dim>::Shape;
  double limit() const override { return locking; }
  Shape shape(double x) const override;

private:
  double locking = 100;
};
} // namespace softgrain::constitutive

#endif
