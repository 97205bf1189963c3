// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_growth_h
#define softgrain_constitutive_growth_h

#include <softgrain/base/expression.h>
#include <softgrain/constitutive/elastic_law.h>
#include <softgrain/constitutive/refusal.h>

#include <mutex>

namespace softgrain::constitutive
{
/**
 * @brief A solid that grows: F = Fe Fg, neo-Hookean in Fe.
 *
 * Fg stretches by sqrt(J_g) along every direction of the plane x, y, or by J_g along one direction a at rest;
 * J_g = det Fg follows the rate given as a formula of time, d ln J_g / dt = r(t). With psi_e the energy of
 * NeoHookean per volume that has grown,
 *
 *   psi = J_g psi_e(Fe),  tau = J_g tau_e(Fe),  c = J_g c_e(Fe),
 *
 * Rodriguez, Hoger and McCulloch, Journal of Biomechanics 27 (1994). What growth brings in is the integral of
 * d psi / d ln J_g at constant F over the growth of a step, along a straight way of ln J_g and of the
 * logarithms of what psi depends on: of second order in the step, exact where growth is confined, and nothing
 * where it is free. The mass of a point stays.
 */
template <int dim>
class Growth final : public ElasticLaw<dim>, public Refusal<dim>
{
public:
  Growth();
  std::string title() const override { return "Growth"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  /// J_g, then of the deformation at the end of the step: det F, tr F^T F, and its part that growth shares.
  unsigned int n_history() const override { return 4; }
  void initial_history(double *history) const override;
  std::vector<std::string> history_names() const override;
  bool limits_step() const override { return largest > 0; }
  bool is_active() const override { return true; }
  std::string why_refused(const Inputs<dim> &point) const override;
  std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const override;

private:
  /// What a point has grown by, ln J_g, in a step that ends at @p time [s]. NaN where the formula has none.
  double growth_in_step(double time, double dt) const;
  double energy(double grown, double J, double first, double shared) const;
  /// Energy that growth brings in from the old history to the new one [J/m^3]. @param growth ln J_g of the
  /// step
  double supply(double growth, const double *old, const double *fresh) const;

  Expression rate;
  mutable std::mutex rate_mutex; ///< a formula is evaluated by one thread at a time
  /// Unit vectors at rest along which it grows.
  std::vector<dealii::Tensor<1, dim>> directions;
  double largest = 0.1;
};
} // namespace softgrain::constitutive

#endif
