// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_drucker_prager_h
#define softgrain_constitutive_drucker_prager_h

#include <softgrain/constitutive/elastic_law.h>

namespace softgrain::constitutive
{
/**
 * @brief Powders and soils: Drucker and Prager's cone with an elliptic cap, associated.
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
 *
 * The cap hardens by moving: p_a and p_b have grown by H times the plastic compaction that it has seen, all
 * that at the start of the step, which keeps the set of a step fixed; the error is of first order in the
 * step. Compaction counts, not dilation.
 */
template <int dim>
class DruckerPrager final : public ElasticLaw<dim>
{
public:
  std::string title() const override { return "Drucker-Prager"; }
  void declare_parameters(dealii::ParameterHandler &prm) const override;
  void parse_parameters(dealii::ParameterHandler &prm) override;
  /// Fp^-1 (with zz in 2D), then the plastic parts of shear and compaction, and what compaction the cap has
  /// seen.
  unsigned int n_history() const override { return dim * dim + (dim == 2 ? 4 : 3); }
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
  /// Where the cap is in a step.
  struct Cap
  {
    double start, end;
    double top; ///< q of the cone where the cap starts
  };
  Cap cap_after(double compaction) const;
  Projection project(double p, double q, const Cap &cap) const;
  Projection project_on_cap(double p, double q, const Cap &cap) const;

  double cohesion = 2e5, friction = 0.5, cap_start = 1e6, cap_end = 2e6, cap_hardening = 0;
};
} // namespace softgrain::constitutive

#endif
