// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_load_balance_h
#define softgrain_mpm_model_load_balance_h

#include <softgrain/mpm/body/body_share.h>

#include <vector>

namespace softgrain::mpm
{
/**
 * @brief How even the work of owners is, what bodies cost by that, and when it pays to share them out anew.
 *
 * It goes by processor seconds of an owner's own work, so that neither waiting nor other programs count. All
 * know the numbers of all, and so come to the same verdict.
 */
class LoadBalance
{
public:
  /// @param weights what bodies are thought to cost before anything is measured, in any unit
  void start(std::vector<double> weights) { costs = std::move(weights); }

  /// Measures the work; all owners call it between steps. @return whether it has, and found work uneven
  bool uneven(const Exchange &exchange);

  /// Work of the busiest owner over the mean, of late.
  double imbalance() const;

  /// What bodies cost: as was thought, times what their owner has taken over what was thought of it.
  std::vector<double> measured(const BodyShare &share) const;

  /// Work of the busiest owner over the mean, when these own the bodies.
  static double imbalance_of(const std::vector<double> &costs,
                             const std::vector<unsigned int> &owners,
                             unsigned int n_owners);

  /// Whether to change to a partition that has the imbalance @p expected: when that is better by more than a
  /// tenth, and as much time has been lost without it as the change will take. To be asked once when
  /// uneven().
  bool pays(double expected);

  /// Bodies, which cost so much, have other owners now. @param seconds what that took the busiest owner
  void moved(std::vector<double> measured, const Exchange &exchange, double seconds);

private:
  /// Measures from here on.
  void begin(const Exchange &exchange);

  std::vector<double> costs; ///< of bodies
  double own_before = 0.;    ///< done here, when it was last measured [processor s]
  unsigned int steps = 0;    ///< since then
  std::vector<double> now;   ///< own work of every owner since it was last measured [processor s]
  std::vector<double> late;  ///< the same with what was before, halved each time; empty before the first step
  double lost = 0.;          ///< since work has been uneven, by the busiest owner [processor s]
  double price = 0.;         ///< of the last change; 0: none yet [processor s]
};
} // namespace softgrain::mpm

#endif
