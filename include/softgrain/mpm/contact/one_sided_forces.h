// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_one_sided_forces_h
#define softgrain_mpm_contact_one_sided_forces_h

#include <Eigen/Core>

#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Forces P >= 0 at places that may touch, so that gaps g + N P are not negative and are zero where
 * there is force.
 *
 * N need not be positive definite: a body that is compressed has unstable motions which its contacts hold.
 * Then a set of closed places belongs to a minimum of the energy when the part of N between them has as many
 * negative eigenvalues as the matrix of the body had.
 */
struct OneSidedForces
{
  Eigen::MatrixXd compliance; ///< N, symmetric [m/N]
  Eigen::VectorXd gap;        ///< without forces [m]
  std::vector<char> closed;   ///< where forces are expected; after solve(), where they are

  Eigen::VectorXd force;   ///< found [N]
  unsigned int passes = 0; ///< of the last solve

  /// @param tolerance a gap, or a force times a compliance, that is rounding [m]
  /// @return whether a set has been found on which no force pulls, and beside which no gap is negative
  bool solve(double tolerance);
  /// Negative eigenvalues of N between closed places.
  unsigned int n_negative() const;

private:
  /// The part of N between closed places, and where these are.
  Eigen::MatrixXd closed_part(std::vector<unsigned int> &places) const;
};
} // namespace softgrain::mpm

#endif
