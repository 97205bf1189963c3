// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_relaxation_h
#define softgrain_mpm_stepping_relaxation_h

#include <softgrain/mpm/stepping/step.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief How held steps are made so that bodies come to balance: how much they resist, and from where.
 *
 * Resistance goes in balance, whatever it is. Where all goes well it is taken down, so that balance comes
 * sooner; where steps go back and forth, are refused or give energy it is put up. While free walls are on
 * their way it comes back to what was set. Bodies that go on and on
 * slide down a long valley: they are held to where they would be when they went on by a share of their last
 * way, not to where they are (Nesterov 1983; the share starts anew when they turn, or when forces grow).
 */
class Relaxation
{
public:
  Relaxation(const Problem &problem, const State &state, double dt);

  /// The next held step.
  const StepPlan &plan() const { return next; }

  /// Learns from a step that was not accepted. @return false when more resistance is of no use
  bool refused();

  /// Learns from a step that was: how it came out, where the bodies are now, and what was out of balance
  /// before and after it.
  /// @param walls_on_their_way whether free walls have not yet met what bears them: then resistance stays
  void accepted(const StepOutcome &step,
                const State &state,
                double unbalanced_before,
                double unbalanced_after,
                bool walls_on_their_way);

private:
  using Vectors = std::vector<Eigen::VectorXd>;

  void look_ahead(bool go_on);
  void ease(const StepOutcome &step);
  void resist(const StepOutcome &step, double before, double after);

  StepPlan next;
  const double wanted;                                     ///< resistance, as it was set
  const double rise;                                       ///< factor of it after a refused step
  double least;                                            ///< that has not just been too little
  double turn = 0;                                         ///< cosine of the angle between the last two ways
  double sequence = 1;                                     ///< Nesterov's
  double lowest = std::numeric_limits<double>::infinity(); ///< imbalance so far
  unsigned int since_lowest = 0;                           ///< held steps since it was lowered by a tenth
  Vectors place, way; ///< of the nodes of all bodies, and from the place before [m]
};
} // namespace softgrain::mpm

#endif
