// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_momentum_h
#define softgrain_contact_momentum_h

#include <algorithm>
#include <cmath>

namespace softgrain::contact
{
/**
 * @brief Nesterov's sequence of momenta, with restart.
 *
 * Sweeps start from P + m (P - P_before) in place of P. They are no gradient steps, so the sequence, which
 * goes to 1, is bounded, and whoever uses it watches the residual.
 */
class Momentum
{
public:
  /// Bound without friction, where sweeps descend a convex function. Beyond it the residual swings more than
  /// it falls.
  static constexpr double frictionless = 0.98;

  /// Bound with friction: Coulomb's law has no potential, so more may feed on itself.
  static constexpr double frictional = 0.9;

  /// With friction: growth of the residual over the lowest one after which to start afresh.
  static constexpr double restart_growth = 2.;

  /// The same for giving it up. Up to 10 were seen where it did well in the end.
  static constexpr double fallback_growth = 50.;

  /// @param components of a contact; one means no friction
  explicit Momentum(const unsigned int components) : largest(components > 1 ? frictional : frictionless) {}

  /// The next m; 0 the first time and after restart().
  double next()
  {
    const double before = t;
    t = 0.5 * (1. + std::sqrt(1. + 4. * t * t));
    return std::min(largest, (before - 1.) / t);
  }

  void restart() { t = 1.; }

private:
  double largest, t = 1.;
};
} // namespace softgrain::contact

#endif
