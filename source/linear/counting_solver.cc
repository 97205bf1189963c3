// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/linear/counting_solver.h>

#include <Eigen/SparseCholesky>

namespace softgrain
{
struct CountingSolver::Factor
{
  Eigen::SimplicialLDLT<SystemMatrix::Sparse, Eigen::Lower, Eigen::AMDOrdering<int>> ldlt;
};

CountingSolver::CountingSolver(std::unique_ptr<LinearSolver> solver) : inner(std::move(solver)) {}

CountingSolver::~CountingSolver() = default;

bool CountingSolver::factorize(SystemMatrix &matrix)
{
  const bool new_pattern = matrix.pattern_is_new(); // the other solver takes note of it
  if (!inner->factorize(matrix))
    return false;
  negative = inner->n_negative();
  if (negative)
    return true;
  if (factor == nullptr || new_pattern)
  {
    factor = std::make_unique<Factor>();
    factor->ldlt.analyzePattern(matrix.lower());
  }
  factor->ldlt.factorize(matrix.lower());
  if (factor->ldlt.info() != Eigen::Success)
    return false;
  negative = (factor->ldlt.vectorD().array() < 0.).count();
  return true;
}
} // namespace softgrain
