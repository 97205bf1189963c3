// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_elastic_law_h
#define softgrain_constitutive_elastic_law_h

#include <softgrain/constitutive/law.h>

namespace softgrain::constitutive
{
/**
 * @brief Common part of laws whose response at rest is isotropic linear elasticity.
 *
 * Declares and reads "Young's modulus" and "Poisson's ratio" and turns them into the Lamé constants
 * lambda = E nu / ((1 + nu)(1 - 2 nu)) and mu = E / (2 (1 + nu)). Derived laws that add parameters call these
 * functions first.
 */
template <int dim>
class ElasticLaw : public Law<dim>
{
public:
  ElasticLaw();

  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  double wave_modulus() const override;
  double poisson_ratio() const override;
  double young_modulus() const override;

protected:
  /// First Lamé constant [Pa].
  double lambda;
  /// Shear modulus [Pa].
  double mu;

private:
  void set_constants(double young, double poisson);

  double young;
  double poisson;
};
} // namespace softgrain::constitutive

#endif
