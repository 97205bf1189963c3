// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_j2_plastic_h
#define softgrain_constitutive_j2_plastic_h

#include <softgrain/constitutive/elastic_law.h>

namespace softgrain::constitutive
{
/**
 * @brief Plasticity of von Mises at finite strain: multiplicative, with logarithmic elastic strain.
 *
 * F = Fe Fp with det Fp = 1, Fe = R U, E = ln U, elasticity of Hencky in E. The trial state of a step is
 * Fe = F Fp_old^-1; the return goes along the plastic strain increment D of the intermediate configuration:
 *
 *   E = E_trial - D,  A = A_old + D,  alpha = alpha_old + sqrt(2/3) |D|,
 *   xi = 2 mu dev E - 2/3 H_k A,      sqrt(3/2) |xi| <= sigma_y(alpha),  D along xi,
 *   sigma_y = S_y + H alpha + (S_inf - S_y) (1 - exp(-delta alpha)),
 *
 * Eterovic and Bathe (1990), linear and Voce isotropic and linear kinematic hardening. Without kinematic
 * hardening D and E_trial share their axes and this is the exponential map of de Souza Neto, Peric and Owen,
 * box 14.3. New stress follows from a potential of E_trial, energy plus dissipation, so that the tangent is
 * exact and symmetric. Kinematic hardening stores H_k/3 A : A; the isotropic work, the integral of
 * sigma_y d alpha, is dissipated.
 */
template <int dim>
class J2Plastic : public ElasticLaw<dim>
{
public:
  std::string title() const override { return "J2 plastic"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  /// Fp^-1 in the first dim directions, then A (without zz, which follows from its zero trace), then alpha.
  unsigned int n_history() const override { return dim * dim + (dim == 2 ? 3 : 6) + 1; }
  void initial_history(double *history) const override;
  std::vector<std::string> history_names() const override;
  std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const override;

protected:
  /// What flows in a step.
  struct Flow
  {
    double increment = 0;   ///< of the equivalent plastic strain
    double softness = 0;    ///< derivative of the increment by the equivalent trial stress [1/Pa]
    double dissipation = 0; ///< [J/m^3]
    double rate = 0; ///< of the equivalent plastic strain, kept by laws with one more number of history
  };

  /// What flows at an equivalent trial stress @p trial; a law with viscosity reads @p rate_old and @p dt.
  virtual Flow flow(double trial, double alpha_old, double rate_old, double dt) const;
  /// @throw InputError when the yield stress is no stress to start from. Default: it must be above 0
  virtual void check_yield(dealii::ParameterHandler &prm) const;

  double yield_stress(double alpha) const;
  double hardening(double alpha) const;
  /// Integral of yield_stress from zero to @p alpha.
  double plastic_work(double alpha) const;

  /// Equivalent plastic strain of one step above which a shorter one is asked for; 0: any.
  double largest_increment = 0;
  double yield = 1e6, linear = 0, saturation = 1e6, rate = 0, kinematic = 0;
};
} // namespace softgrain::constitutive

#endif
