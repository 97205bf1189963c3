// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_drucker_prager_h
#define softgrain_constitutive_drucker_prager_h

#include <softgrain/constitutive/elastic_law.h>

namespace softgrain::constitutive
{
/**
 * @brief Powders and soils: Drucker and Prager's cone with an elliptic cap, associated and perfectly plastic.
 *
 * F = Fe Fp, E the logarithmic strain of Fe, Hencky's elasticity in it. With the pressure p = -K tr E, the
 * von Mises stress q = sqrt(6) mu |dev E|, bulk modulus K, all in Kirchhoff's stress:
 *
 *   q <= d + m p                                               where p <= p_a,
 *   ((p - p_a) / (p_b - p_a))^2 + (q / (d + m p_a))^2 <= 1     where p >= p_a.
 *
 * Flow is normal to this convex set: the stress is the point of the set next to the trial stress in the norm
 * of the elastic energy, p^2/K + q^2/(3 mu), Simo and Hughes, Computational Inelasticity, section 3.2. So
 * energy plus dissipation of a step is a potential, and the tangent is symmetric.
 */
template <int dim>
class DruckerPrager final : public ElasticLaw<dim>
{
public:
  std::string title() const override { return "Drucker-Prager"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  /// Fp^-1 (with zz in 2D), then the plastic parts of shear and compaction.
  unsigned int n_history() const override { return dim * dim + (dim == 2 ? 3 : 2); }
  void initial_history(double *history) const override;
  std::vector<std::string> history_names() const override;
  std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const override;

private:
  /// The stress next to a trial stress, and its derivatives by the trial stress.
  struct Projection
  {
    double p, q;
    double ratio; ///< q over that of the trial, also where both vanish
    double pp = 0, pq = 0, qp = 0, qq = 0;
    bool flows = true;
  };
  Projection project(double p, double q) const;
  Projection project_on_cap(double p, double q) const;

  double cohesion = 2e5, friction = 0.5, cap_start = 1e6, cap_end = 2e6;
};
} // namespace softgrain::constitutive

#endif
