// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_flory_rehner_h
#define softgrain_constitutive_flory_rehner_h

#include <softgrain/base/expression.h>
#include <softgrain/constitutive/law.h>
#include <softgrain/constitutive/refusal.h>

#include <array>
#include <mutex>
#include <utility>

namespace softgrain::constitutive
{
/**
 * @brief A gel in balance with a solvent, which it takes up and gives away at once: the energy of Flory and
 * Rehner.
 *
 * With F_t from the dry network, J_t = det F_t, shear modulus G = N k T of the dry network, mixing pressure
 * q = k T / v of the solvent, interaction chi and chemical potential m = mu / (k T) of the solvent outside,
 * what the gel and the solvent have together, per dry volume, is
 *
 *   W = G/2 (tr F_t^T F_t - 3 - 2 ln J_t) - q ((J_t - 1) ln(J_t / (J_t - 1)) + chi / J_t) - q m (J_t - 1),
 *
 * Hong, Liu and Suo, International Journal of Solids and Structures 46 (2009). The state at rest is
 * the gel swollen freely at m(0), by J_0 = lambda_0^3: F_t = lambda_0 F. The energy per volume at rest is psi
 * = (W - W_f) / J_0, with W_f of the gel swollen freely at m(t): free swelling stores nothing. What swelling
 * brings in is the integral of d psi / d m = -q (J_t - J_f) / J_0 over the change of m in a step.
 *
 * Where nearly no solvent is left, J_t < 1.05, the mixing goes on linearly in ln J_t: the dry network has a
 * bulk modulus of 20 q. In the plane the gel keeps its stretch lambda_0 out of it.
 */
template <int dim>
class FloryRehner final : public Law<dim>, public Refusal<dim>
{
public:
  FloryRehner();
  std::string title() const override { return "Flory-Rehner"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  /// Both of the end of the step: det F, and m.
  unsigned int n_history() const override { return 2; }
  void initial_history(double *history) const override
  {
    history[0] = 1.;
    history[1] = m_at_rest;
  }
  std::vector<std::string> history_names() const override { return {"volume_ratio", "chemical_potential"}; }
  bool limits_step() const override { return largest > 0.; }
  bool is_active() const override { return true; }
  double wave_modulus() const override { return lambda + 2. * mu; }
  double poisson_ratio() const override { return 0.5 * lambda / (lambda + mu); }
  std::string why_refused(const Inputs<dim> &point) const override;
  std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const override;

private:
  /// m at a time [s]. NaN where the formula has none.
  double potential(double time) const;
  /// J_t of free swelling at a chemical potential of 0 or less.
  double free_swelling(double m) const;
  /// Stress over q of a gel swollen freely by @p J, and its derivative by ln J.
  std::pair<double, double> free_stress(double J, double m) const;
  /// Finds the state at rest. @throw InputError
  void find_rest();
  /// What the solvent is in a step.
  struct Solvent
  {
    double m_old = 0., m = 0., free = 0.; ///< m at both ends, J_t of free swelling at the end
    std::array<double, 4> free_on_way{};  ///< the same at the places of Gauss's rule between the ends
  };
  /// Finds what @p out asks for.
  Solvent solvent_in_step(double m_old, double m, const Outputs<dim> &out) const;
  /// Energy that a change of m brings in where det F goes from @p J_old to @p J_new, straight in ln det F
  /// [J/m^3].
  double supply(const Solvent &solvent, double J_old, double J_new) const;

  double shear_of_network = 1e4, mixing = 1.36e8, interaction = 0.45; ///< G [Pa], q [Pa], chi
  double largest = 0.1;
  Expression chemical_potential;
  mutable std::mutex mutex; ///< a formula is evaluated by one thread at a time

  double m_at_rest = 0., swelling = 1.; ///< m(0), J_0
  double lambda = 0., mu = 0.;          ///< Lamé's constants at rest [Pa]
};
} // namespace softgrain::constitutive

#endif
