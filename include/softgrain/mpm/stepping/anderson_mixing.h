// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_anderson_mixing_h
#define softgrain_mpm_stepping_anderson_mixing_h

#include <Eigen/Core>

#include <deque>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Anderson's mixing for a fixed-point iteration x -> g(x): the next x from the last few pairs, such
 * that the change g - x, taken as linear, is as small as it can be.
 *
 * As many errors as there are pairs less one, each of which changes by a factor of its own from iteration to
 * iteration, are gone in the next one, also where the factors are near 1 or below -1. Far from the solution
 * it may mislead: the caller says when it is to start (see Walker and Ni, SIAM J. Numer. Anal. 49, 2011).
 */
class AndersonMixing
{
public:
  /// @param depth differences of pairs that are kept at most
  explicit AndersonMixing(const unsigned int depth) : depth(depth) {}

  void restart();

  /// The x to go on with, from the last @p x and its @p g.
  Eigen::VectorXd next(const Eigen::VectorXd &x, const Eigen::VectorXd &g);
  /// The next iterate for vectors in parts.
  std::vector<Eigen::VectorXd> next(const std::vector<Eigen::VectorXd> &x,
                                    const std::vector<Eigen::VectorXd> &g);

private:
  unsigned int depth;
  Eigen::VectorXd last_change, last_g;
  std::deque<Eigen::VectorXd> change_differences, g_differences;
};
} // namespace softgrain::mpm

#endif
