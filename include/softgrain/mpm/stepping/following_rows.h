// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_following_rows_h
#define softgrain_mpm_stepping_following_rows_h

#include <softgrain/mpm/stepping/anderson_mixing.h>
#include <softgrain/mpm/stepping/step_rows.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The contact rows of one step, which follow the bodies as Newton's method goes.
 *
 * Rows are taken at the middle of the step or at its end (TimeScheme::row_share). A step with inertia gives
 * them the gaps that bodies truly have at its start: a closed row with normal n at the middle of the step
 * does the work -P·gap, so that contact which starts closed neither gives nor takes, however far bodies slide
 * over each other; a gap drawn back along n from the middle is short by u²/8R.
 */
class FollowingRows
{
public:
  /// One per body; displacements handed in are those of this rank's bodies, unless all ranks look for contact
  /// of all.
  using Vectors = std::vector<Eigen::VectorXd>;

  /// @param dt     length of the step [s]
  /// @param motion of the walls
  FollowingRows(const Problem &problem,
                const State &state,
                Workspace &work,
                double dt,
                const std::vector<WallMotion<2>> &motion);

  /// Finds the rows of the step for the displacements @p increment [m]; @p again: they replace others of it.
  void find(const Vectors &increment, bool again);

  /// How far nodes are from where the rows were found, with these displacements [m]; 0 for rows that stay.
  double lag(const Vectors &increment) const;

  /// Whether rows with this lag [m] are those of the step.
  bool settled(double lag) const;

  /// Whether they lag behind a step with these displacements [m] by a small share of its way only.
  bool follow(const Vectors &increment) const;

  /**
   * @brief Makes @p increment, the outcome of these rows on this rank's bodies, what the next ones are best
   * found for, of all bodies.
   *
   * Newton's matrix does not know how rows turn with the bodies and follow them, so iterations are a
   * fixed-point iteration: linear, and in dense packings slow or worse. Near the solution it is mixed; far
   * from it, it goes back between its last two outcomes where they swing.
   * @param lag      of the rows with it [m]
   * @param residual of the Newton iteration there, relative
   * @return whether it is another than it was
   */
  bool mix(Vectors &increment, double lag, double residual);

  /// How often they were found after the first time.
  unsigned int searches() const { return n_searches; }

  /// Deepest overlap at the end of a step with these displacements that stands for no dent [m].
  double penetration(const Vectors &increment) const;

  /// Deepest overlap at its start, of a step with inertia [m].
  double penetration_at_start() const;

private:
  /// How far the displacements @p increment of contact markers are from those of @p from, null: from none
  /// [m].
  double way(const Vectors &increment, const Vectors *from) const;

  /// The nearest to rest between the last outcome and this one. @return whether it is another than it was
  bool go_between(Vectors &increment);

  const Problem &problem;
  const State &state;
  Workspace &work;
  const double dt;
  const std::vector<WallMotion<2>> &motion;
  FoundGaps start_gaps;              ///< of a step with inertia
  Vectors place;                     ///< displacements for which the rows were found [m]
  Vectors last_outcome, last_change; ///< of the search before, when it was too far to be mixed [m]
  AndersonMixing mixing{5};
  double last_lag = std::numeric_limits<double>::max();
  unsigned int n_searches = 0;
};
} // namespace softgrain::mpm

#endif
