// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/linear/rank_one_solver.h>

#include <cmath>

namespace softgrain
{
void RankOneSolver::set_update(const Eigen::VectorXd &r, const double k)
{
  direction = r;
  factor = k;
}

bool RankOneSolver::factorize(SystemMatrix &matrix)
{
  weight = 0.;
  if (!inner->factorize(matrix))
    return false;
  const std::optional<unsigned int> n_negative = inner->n_negative();
  negative = n_negative;
  if (!takes_indefinite && n_negative.value_or(0) > (factor == 0. ? 0u : 1u))
    return false;
  if (factor == 0.)
    return true;
  inner->solve(direction, effect);
  // det(B + k r rᵀ) = det B (1 + k rᵀ B⁻¹ r), and an update with k > 0 lifts one eigenvalue at most above 0:
  // the sum is positive definite when the sign fits the number of negative pivots.
  const double ratio = 1. + factor * direction.dot(effect);
  if (!takes_indefinite && n_negative && (*n_negative == 1) != (ratio < 0.))
    return false;
  if (negative && ratio < 0.)
    negative = *negative - 1;
  if (!(std::abs(ratio) > 1e-10))
    return false;
  weight = factor / ratio;
  return true;
}

void RankOneSolver::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
{
  inner->solve(b, x);
  if (weight != 0.)
    x -= weight * direction.dot(x) * effect;
}

void RankOneSolver::condense(const Rows &rows, Eigen::MatrixXd &W)
{
  inner->condense(rows, W);
  if (weight == 0.)
    return;
  const Eigen::VectorXd of_rows = rows.transpose() * effect;
  W.noalias() -= weight * of_rows * of_rows.transpose();
}
} // namespace softgrain
