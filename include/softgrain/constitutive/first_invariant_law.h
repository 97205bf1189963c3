// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_first_invariant_law_h
#define softgrain_constitutive_first_invariant_law_h

#include <softgrain/constitutive/elastic_law.h>

namespace softgrain::constitutive
{
/**
 * @brief Common part of rubbers whose energy of shape depends on I1 = tr b only.
 *
 * With b = F F^T, x = I1 - 3 (plane strain in 2D: b_zz = 1), the dimensionless shape(x), shape'(0) = 1, and
 * k = lambda - 2 mu shape''(0), so that lambda and mu are those at rest:
 *
 *   psi = mu/2 shape(x) + k/4 (J^2 - 1) - (k/2 + mu) ln J,
 *   tau = mu shape' b + (k/2 (J^2 - 1) - mu) I,
 *   c   = 2 mu shape'' b x b + k J^2 I x I + 2 (mu - k/2 (J^2 - 1)) II_s.
 *
 * The volumetric part is that of @cite ciarlet1988, section 4.10; it keeps a point from collapsing where
 * k/2 + mu > 0.
 */
template <int dim>
class FirstInvariantLaw : public ElasticLaw<dim>
{
public:
  std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const override;

protected:
  /// The energy of shape and its derivatives, all without units.
  struct Shape
  {
    double value;
    double slope;
    double curvature;
  };

  /// Largest x that the solid can reach is below this. Default: no limit.
  virtual double limit() const;

  /// @throw InputError when k/2 + mu is not above 0; @p cause names the parameter that shape''(0) stems from.
  void check_volume(const std::string &cause) const;

  /// The energy of shape at -3 <= @p x < limit().
  virtual Shape shape(double x) const = 0;
};
} // namespace softgrain::constitutive

#endif
