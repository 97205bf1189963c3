// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_momentum_h
#define softgrain_contact_momentum_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::contact
{
/**
 * @brief Nesterov's sequence of momenta, with restart.
 *
 * Sweeps start from P + m (P - P_before) in place of P. They are no gradient steps, so the sequence, which
 * goes to 1, is bounded, and judge() watches the residual.
 */
class Momentum
{
public:
  /// Bound without friction, where sweeps descend a convex function. Beyond it the residual swings more than
  /// it falls.
  static constexpr double frictionless = 0.98;

  /// Bound with friction: Coulomb's law has no potential, so more may feed on itself.
  static constexpr double frictional = 0.9;

  /// Growth of the residual over the lowest one after which momentum starts afresh where there is friction.
  static constexpr double restart_growth = 2.;

  /// Growth after which momentum is given up. Up to 10 were seen where it did well in the end.
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

  enum class Verdict
  {
    go_on,
    restarted, ///< with friction: the residual has grown, and the momentum starts afresh
    give_up    ///< it has grown too much, or is no number
  };

  /// Takes the residual of the last sweep that was looked at.
  Verdict judge(const double residual)
  {
    if (!(residual <= fallback_growth * lowest))
      return Verdict::give_up;
    if (largest == frictional && residual > restart_growth * lowest_since_restart)
    {
      restart();
      lowest_since_restart = residual;
      return Verdict::restarted;
    }
    lowest = std::min(lowest, residual);
    lowest_since_restart = std::min(lowest_since_restart, residual);
    return Verdict::go_on;
  }

  /// Goes on from the impulses of the lowest residual.
  void return_to_lowest()
  {
    restart();
    lowest_since_restart = lowest;
  }

  /// Lowest residual that judge() has seen.
  double lowest_residual() const { return lowest; }

private:
  double largest, t = 1.;
  double lowest = std::numeric_limits<double>::max(), lowest_since_restart = lowest;
};
} // namespace softgrain::contact

#endif
